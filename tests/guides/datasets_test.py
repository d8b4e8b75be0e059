# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs docs/datasets.md."""

import re
from pathlib import Path

import guide

PYTHON = guide.python_with_balcony("numpy")


class DatasetsGuide(guide.GuideTest):
    PAGE = "datasets.md"
    PATH = f"{Path(PYTHON).parent}:{guide.GuideTest.PATH}"

    def contents(self, name):
        return {file.relative_to(self.folder / name): file.read_bytes()
                for file in (self.folder / name).rglob("*") if file.is_file()}

    def test_points_are_in_the_room(self):
        found = re.search(r"(\d+) pixels have a ray; the lowest point is at (\S+)",
                          self.output_of("python3 look.py"))
        self.assertGreater(int(found[1]), 1000)
        self.assertAlmostEqual(float(found[2]), 0, delta=1e-3)

    def test_shards_are_the_whole(self):
        self.assertEqual(self.contents("parts"), self.contents("walk"))


if __name__ == "__main__":
    guide.main()
