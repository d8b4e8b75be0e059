# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs docs/solve.md."""

import guide


class SolveGuide(guide.GuideTest):
    PAGE = "solve.md"

    def test_the_facade_is_where_the_photo_has_it(self):
        shown = self.output_of("balcony solve facade.cam")
        self.assertIn("photo, 640 x 480 pixels: solved after", shown)
        solved = (self.folder / "solved.cam").read_text()
        self.assertTrue(solved.startswith("// facade.cam\n// A photo of the facade.\n"))
        for foot, position in (("20,4,0", (155, 347)), ("20,-4,0", (446, 346))):
            line = self.run_line(f"balcony locate solved.cam --size 640x480 --point {foot}")
            x, y = (float(line.split(axis + " ")[1].split()[0]) for axis in "xy")
            self.assertAlmostEqual(x, position[0], delta=1)
            self.assertAlmostEqual(y, position[1], delta=1)


if __name__ == "__main__":
    guide.main()
