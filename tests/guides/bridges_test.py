# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs docs/bridges.md."""

import os
import re
from pathlib import Path

import guide

TORCH = guide.python_with("numpy", "torch")
PYTHON = TORCH or guide.python_with("numpy")
if PYTHON is None:
    guide.skip("no Python has numpy")
if TORCH is None:
    os.environ["PYTHONPATH"] = str(guide.STAND_INS)


class BridgesGuide(guide.GuideTest):
    PAGE = "bridges.md"
    PATH = f"{Path(PYTHON).parent}:{guide.GuideTest.PATH}"

    def test_the_shader_has_sliders(self):
        text = (self.folder / "tower.osl").read_text()
        self.assertIn("float radius = 3.0 [[", text)
        self.assertRegex(text, r'float lean = (10\.0|9\.99\d+) \[\[ .*string units = "degrees"')
        self.assertIn("exported; single precision", self.output_of("balcony export tower.cam --to osl"))

    def test_the_c_function_takes_another_radius(self):
        # The middle of the picture looks along x: the point (5, 0, 0) leans by 10 degrees.
        self.assertIn("from (4.924, 0.000, -0.868) to (0.985, 0.000, -0.174)",
                      self.output_of("./ray"))

    def test_the_functions_of_povray_have_the_names_of_the_page(self):
        text = (self.folder / "tower.inc").read_text()
        for name in ("Tower", "Tower_u", "Tower_eye_x_2", "Tower_direction", "Tower_direction_2"):
            self.assertIn(f"#declare {name} =", text)

    def test_the_ball_is_seen(self):
        share = re.search(r"covers ([\d.]+) %", self.output_of("python3 sphere.py"))
        self.assertTrue(1.0 < float(share[1]) < 20.0, share[0])

    def test_the_tower_is_found(self):
        found = self.output_of("python3 fit.py")
        self.assertIn("radius 4.500, lean 0.350, loss", found)
        self.assertLess(float(found.split()[-1]), 1e-7)

    def test_mitsuba_takes_another_radius(self):
        line = 'python3 -c "from sensor import *; print(parameters[\'radius\'].value, list(parameters))"'
        self.assertEqual(guide.run_line(f"PYTHONPATH={guide.STAND_INS} {line}", self.folder, self.path),
                         "5.0 ['to_world', 'radius', 'lean']\n")


if __name__ == "__main__":
    guide.main()
