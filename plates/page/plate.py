# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""A plate as its folder describes it, with the files that scripts/plates makes of it."""

import json
import os
import re
from pathlib import Path


class Plate:
    def __init__(self, source, folder):
        self.source = source
        self.folder = folder
        self.name = source.name
        self.number = int(self.name[:2])
        heading, _, rest = (source / "README.md").read_text(encoding="utf-8").partition("\n")
        self.title = heading.removeprefix("# ").strip()
        self.paragraph = " ".join(rest.strip().split("\n\n")[0].split())
        self.values = {}
        for line in (source / "plate").read_text(encoding="utf-8").splitlines():
            key, _, value = line.partition("#")[0].strip().partition(" ")
            self.values[key] = value.strip()

    def file(self, ending):
        """The name of a file beside the page; none if it is missing."""
        name = self.name + ending
        return name if (self.folder / name).exists() else None

    @property
    def is_rendered(self):
        return self.file(".png") is not None and self.file(".json") is not None

    def camera_text(self):
        camera = self.values.get("camera", "camera.cam").split(":")[0]
        text = (self.source / camera).read_text(encoding="utf-8")
        return re.sub(r"\A(// (Balcony:|SPDX).*\n)+", "", text).strip()

    def camera(self, key="camera"):
        """The camera of a key as the command line takes it."""
        camera = self.values.get(key, "camera.cam").split()[0]
        file, colon, name = camera.partition(":")
        return os.path.relpath(self.source / file) + colon + name

    def commands(self):
        """The command lines that render the plate, in a folder with the programs in the path."""
        scene, *options = self.values["scene"].split()
        lines = [" ".join(["build_scene", scene, f"{scene}.glb", *options])]
        add = ""
        if "arrows" in self.values:
            _, *drawing = self.values["arrows"].split()
            lines.append(" ".join(["balcony draw", self.camera("arrows"), "--no-eye --no-toward",
                                   "--no-frame", *drawing, "-o arrows.glb"]))
            add = " --add arrows.glb"
        lines.append(f"balcony render {scene}.glb --camera {self.camera()}{add} "
                     f"{self.values['render']} -o plate-{self.name[:2]}.png")
        return [re.sub(" +", " ", line) for line in lines]

    def facts(self):
        return json.loads((self.folder / self.file(".json")).read_text(encoding="utf-8"))

    def pinhole(self):
        named = self.file(".pinhole")
        picture = (self.folder / named).read_text(encoding="utf-8").strip() if named else None
        return picture if picture and (self.folder / picture).exists() else None


def all_plates(folder):
    return [Plate(source, Path(folder)) for source in sorted(Path("plates").glob("[0-9][0-9]-*"))]


def number_text(value):
    if value != value or abs(value) == float("inf"):
        return str(value)
    return f"{value:.0f}" if value == round(value) and abs(value) < 1e7 else f"{value:.3g}"


def bounds_text(row):
    least, most = row.get("at_least"), row.get("at_most")
    if least is not None and most is not None:
        if least == most:
            return number_text(least)
        return f"{number_text(least)} to {number_text(most)}"
    if least is not None:
        return f"at least {number_text(least)}"
    return f"at most {number_text(most)}" if most is not None else ""
