# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""docs/gallery.md shows every built-in camera as it is, and docs/coverage.md names tests that exist."""

import re
import subprocess
import sys
import unittest
from pathlib import Path

BALCONY, REPOSITORY = sys.argv[1], Path(sys.argv[2])


class Gallery(unittest.TestCase):
    def test_is_up_to_date(self):
        made = subprocess.run([sys.executable, "-B", "cameras/gallery.py", "page", BALCONY],
                              cwd=REPOSITORY, check=True, capture_output=True, text=True).stdout
        kept = (REPOSITORY / "docs" / "gallery.md").read_text(encoding="utf-8")
        self.assertEqual(made, kept, "run scripts/gallery with the names of the changed cameras")

    def test_every_picture_is_there_and_small(self):
        page = (REPOSITORY / "docs" / "gallery.md").read_text(encoding="utf-8")
        shown = set(re.findall(r'"pictures/(gallery/[\w-]+\.webp)"', page))
        self.assertGreater(len(shown), 200)
        kept = (REPOSITORY / "docs" / "pictures" / "gallery").glob("*")
        self.assertEqual(shown, {f"gallery/{picture.name}" for picture in kept})
        for name in shown:
            self.assertLess((REPOSITORY / "docs" / "pictures" / name).stat().st_size, 300_000, name)

    def test_the_tests_of_the_coverage_exist(self):
        page = (REPOSITORY / "docs" / "coverage.md").read_text(encoding="utf-8")
        sources = "".join(file.read_text(encoding="utf-8")
                          for file in (REPOSITORY / "tests").glob("*/*_test.cpp"))
        suites = set(re.findall(r"\bTEST(?:_P|_F)?\((\w+),", sources))
        named = re.findall(r"`(\w+)\.(\w+)`", page)
        self.assertGreater(len(named), 20)
        for folder, suite in named:
            scripts = list((REPOSITORY / "tests" / folder).glob(f"{suite}_test.py"))
            self.assertTrue(suite in suites or scripts, f"{folder}.{suite}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
