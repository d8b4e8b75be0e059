# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs the commands of docs/cookbook.md, in small, and looks after its pictures."""

import re
import subprocess
import sys
import unittest
from pathlib import Path

import guide

BUILD_SCENE = Path(sys.argv[3]).resolve()
PICTURES = guide.REPOSITORY / "docs" / "pictures" / "cookbook"


def in_small(line):
    """A command line whose last options make it quick."""
    size = "--size 96" if "--size" in line else "--scale 10%"
    frames = " --frames 1-2" if "--frames" in line else ""
    return f"{line} {size} --samples 2{frames}"


class Cookbook(guide.GuideTest):
    PAGE = "cookbook.md"
    EDIT = staticmethod(in_small)

    @classmethod
    def prepare(cls):
        for scene in ("vase", "room", "street"):
            subprocess.run([BUILD_SCENE, scene, cls.folder / f"{scene}.glb"], check=True)

    def test_commands_write_the_pictures_of_the_page(self):
        shown = re.findall(r"\(pictures/cookbook/(.*?)\)", guide.page_text(self.PAGE))
        written = [line.rsplit(" -o ")[-1] for line in self.outputs if " -o " in line]
        self.assertEqual([name for name in written if name.endswith(".jpg")], shown)
        for name in written:
            self.assertTrue((self.folder / name).exists(), name)
        for name in shown:
            self.assertLess((PICTURES / name).stat().st_size, 100_000, name)

    def test_cameras_are_fitted(self):
        for line, said in self.outputs.items():
            if line.startswith("balcony") and "--quiet" not in line:
                self.assertIn("fitted: ", said, line)


if __name__ == "__main__":
    guide.main()
