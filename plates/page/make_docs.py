# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/plates.md from the folders of the plates.

Usage: make_docs.py PROPERTIES.json

PROPERTIES.json is what measure_plates prints. To be run in the repository.
"""

import json
import re
import sys
import textwrap
from pathlib import Path

from plate import all_plates, bounds_text, number_text

INTRODUCTION = """# The plates

The fifteen plates of "Ray Tracing with Extended Cameras" (H. Löffelmann and E. Gröller, 1996) and more.
The scenes are Balcony's own, and so are the pictures that hang in them. Each plate has a stated
property, which a test measures from the layers of a small render: the numbers below.

```sh
scripts/plates                        # all, in a few minutes, with a page to look at them
scripts/plates 2 5 --quality good     # two of them, in their own size
```

The page, `build/plates/index.html`, has larger pictures with a slider between the ordinary and the
extended view, drawings of the cameras, maps of the magnification, and the command line of each plate.
Each folder of [plates/](../plates) has a camera and the options of its render.
"""


def wrapped(text):
    return textwrap.fill(text, width=100, break_long_words=False, break_on_hyphens=False)


def measured_text(rows):
    return "; ".join(f"{row['what']} {number_text(row['value'])}"
                     + (f" ({bounds})" if (bounds := bounds_text(row)) else "") for row in rows)


def from_docs(text):
    """A text of a plate's folder with the links to other plates as they are from docs/."""
    return re.sub(r"\]\(\.\./(?=\d\d-)", "](../plates/", text)


def section(plate, rows):
    camera = plate.values.get("camera", "camera.cam").split(":")[0]
    link = (plate.source / camera).resolve().relative_to(Path.cwd())
    lines = [f"## {plate.title}", "", f"![]({Path('pictures')}/plate-{plate.name[:2]}.png)", "",
             wrapped(f"{from_docs(plate.paragraph)} ([camera](../{link.as_posix()}))"), ""]
    if rows:
        lines += [wrapped(f"*Measured:* {measured_text(rows)}."), ""]
    povray = Path(f"docs/pictures/plate-{plate.name[:2]}-povray.png")
    if povray.exists():
        lines += ["The original scene through the same camera, rendered by POV-Ray:", "",
                  f"![](pictures/{povray.name})", ""]
    return "\n".join(lines)


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    properties = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    sections = [section(plate, properties.get(str(plate.number), []))
                for plate in all_plates("build/plates")]
    text = INTRODUCTION + "\n" + "\n".join(sections)
    Path("docs/plates.md").write_text(text.rstrip() + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
