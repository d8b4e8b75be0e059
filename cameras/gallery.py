# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/gallery.md, and the options of its pictures, from the built-in cameras.

Usage: gallery.py page BALCONY
       gallery.py options BALCONY SCENE [NAME...]

`page` prints the page. `options` prints for each camera, or each of these names, its name and what the
render of its picture of a scene needs, as cameras/gallery.txt has it. To be run in the
repository.
"""

import itertools
import json
import subprocess
import sys
import textwrap
from pathlib import Path

INTRODUCTION = """# Gallery

What the built-in cameras see in a furnished room, 7 by 5 metres, and in a street. Each stands where
the scene places it:

```sh
balcony list cameras                            # all of them, with a line on what each is for
balcony list little_planet                      # one of them, with its parameters
```

```
balcony render room.glb --camera little_planet -o planet.png
```

`scripts/gallery` makes this page and its pictures. The scenes are those of `build_scene room` and
`build_scene street`. [coverage.md](coverage.md) says with what each camera is compared.
"""

HEADINGS = {
    "perspective": "Perspective", "parallel": "Parallel projection", "fisheye": "Fisheye",
    "panorama": "Panoramas", "maps": "Map projections", "dome": "Domes", "walls": "Walls",
    "stereo": "Stereo", "unroll": "Unrolling", "strip": "Strips", "mirrors": "Mirrors",
    "art": "Art", "paper": "The paper's own",
}
SCENES = ("room", "street")
WIDTH = 420  # Of a picture on the page: two are side by side.


def built_in(balcony):
    """The built-in cameras in the order of the headings."""
    listed = json.loads(subprocess.run([balcony, "list", "cameras", "--json"], check=True,
                                       capture_output=True, text=True).stdout)["cameras"]
    families = list(HEADINGS)
    return sorted(listed, key=lambda camera: (families.index(camera["family"]), camera["name"]))


def extra_options(name, family, scene):
    """The options of the rows NAME and NAME@SCENE of cameras/gallery.txt; maps are small."""
    options = ["--scale 28%"] if family == "maps" else []
    for line in Path("cameras/gallery.txt").read_text(encoding="utf-8").splitlines():
        row, _, rest = line.partition(" ")
        if row in (name, f"{name}@{scene}"):
            options.append(rest.strip())
    return " ".join(options)


def scenes_of(family):
    """Where a picture shows a camera: of the many maps, one each is enough."""
    return SCENES[:1] if family == "maps" else SCENES


def use_of(camera):
    sentence = " ".join(camera["comment"].split())
    return sentence[:sentence.find(". ") + 1] or sentence


def picture(camera, scene):
    name = camera["name"]
    return (f'<img src="pictures/gallery/{name}-{scene}.webp" width="{WIDTH}" '
            f'alt="{name} in the {scene}">')


def link(camera):
    file = f"{camera['name']}.cam"
    return f"[{file}](../cameras/{camera['family']}/{file})"


def section(camera):
    """A heading, and what the camera sees in both scenes, side by side."""
    text = f"{use_of(camera)} {link(camera)}"
    pictures = " ".join(picture(camera, scene) for scene in scenes_of(camera["family"]))
    return [f"### {camera['name']}", "",
            textwrap.fill(text, width=100, break_long_words=False, break_on_hyphens=False), "",
            pictures, ""]


def maps(cameras):
    """What many cameras see in one scene, folded: two side by side, each with its use below."""
    lines = [f"<details><summary>{len(cameras)} projections</summary>", "", "| | |", "|---|---|"]
    for i in range(0, len(cameras), 2):
        cells = [f"{picture(camera, SCENES[0])}<br>**{camera['name']}** {use_of(camera)} {link(camera)}"
                 for camera in cameras[i:i + 2]]
        lines.append(f"| {' | '.join(cells + [''] * (2 - len(cells)))} |")
    return [*lines, "", "</details>", ""]


def page(balcony):
    lines = [INTRODUCTION]
    for family, cameras in itertools.groupby(built_in(balcony), lambda camera: camera["family"]):
        cameras = list(cameras)
        lines += [f"## {HEADINGS[family]}", ""]
        lines += maps(cameras) if family == "maps" else itertools.chain(*map(section, cameras))
    return "\n".join(lines).rstrip() + "\n"


def main():
    words = sys.argv[1:]
    if words[:1] == ["page"] and len(words) == 2:
        sys.stdout.write(page(words[1]))
    elif words[:1] == ["options"] and len(words) >= 3:
        known = [camera["name"] for camera in built_in(words[1])]
        unknown = [name for name in words[3:] if name not in known]
        if unknown:
            raise SystemExit(f"there is no built-in camera '{unknown[0]}'")
        families = {camera["name"]: camera["family"] for camera in built_in(words[1])}
        for name in words[3:] or known:
            if words[2] in scenes_of(families[name]):
                print(name, extra_options(name, families[name], words[2]))
    else:
        raise SystemExit(__doc__)


if __name__ == "__main__":
    main()
