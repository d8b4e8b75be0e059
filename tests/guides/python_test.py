# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Runs docs/python.md."""

import re
from pathlib import Path

import guide

PYTHON = guide.python_with_balcony("numpy")


class PythonGuide(guide.GuideTest):
    PAGE = "python.md"
    PATH = f"{Path(PYTHON).parent}:{guide.GuideTest.PATH}"

    def test_a_pixel_of_the_fisheye_has_its_width(self):
        found = re.search(r"(\S+) rad; (\S+)% of.*\n.* (\S+) degrees wide",
                          self.output_of("python3 rays.py"))
        # An equidistant fisheye of 170 degrees has them all over its 400 pixels, which are a square
        # around its circle. Its second derivative is 0 in the middle.
        self.assertAlmostEqual(float(found[1]), 2.9671, delta=1e-4)
        self.assertAlmostEqual(float(found[3]), 170 / 400, delta=1e-3)

    def test_a_pose_is_that_of_the_matrix(self):
        found = re.search(r"\((\S+), (\S+), (\S+)\)", self.output_of("python3 poses.py"))
        # From (0, 1.5, 1), 30 degrees to the right of -z, to the wall at z = -2. The middle of pixel
        # (160, 90) is half a pixel from that of the picture: 0.01 on the wall.
        for number, wanted in zip(found.groups(), (3 * 0.57735, 1.5, -2)):
            self.assertAlmostEqual(float(number), wanted, delta=0.02)

    def test_the_fitted_camera_is_the_original(self):
        found = re.search(r"fov (\S+), yaw (\S+), pitch (\S+), pz (\S+)",
                          self.output_of("python3 fit.py"))
        self.assertEqual([float(one) for one in found.groups()], [65.0, 20.0, -5.0, 1.5])

    def test_every_object_has_its_share(self):
        shares = re.findall(r"^(\w+): ([\d.]+)% of the picture, ([\d.]+) units",
                            self.output_of("python3 layers.py"), re.MULTILINE)
        self.assertEqual([name for name, _, _ in shares], ["floor", "ceiling", "walls"])
        # The room is closed. From the middle, nothing is nearer than the floor or further away than
        # a corner.
        self.assertTrue(sum(float(share) for _, share, _ in shares) < 100.2)
        for _, _, distance in shares:
            self.assertTrue(1.2 < float(distance) < 3.9)

    def test_rays_end_at_the_hits(self):
        found = re.search(r"within (\S+) of the hits", self.output_of("python3 layers.py"))
        self.assertLess(float(found[1]), 1e-5)  # roundings of floats of size 4

    def test_copies_of_a_room_have_boxes(self):
        shown = self.output_of("python3 boxes.py")
        for number in range(3):
            found = re.search(rf"picture {number} shows floor, ceiling, walls, (.*)", shown)
            self.assertLessEqual(set(found[1].split(", ")), {f"box {i}" for i in range(4)})
        self.assertIn("the room has floor, ceiling, walls\n", shown)

    def test_the_composed_camera_is_that_of_its_text(self):
        text = self.output_of("python3 flight.py")
        self.assertIn("camera flight(radius = 0.5 above 0) {", text)
        self.assertIn("toward torus(5*radius, 1)", text)
        self.assertIn("no errors", self.output_of("balcony check flight.cam"))

    def test_a_formula_of_python_is_one_of_the_language(self):
        output = self.output_of("python3 ripple.py")
        self.assertIn("eye surface(u, v) = [0*u, u, v + height*sin(12*sqrt(u^2 + v^2))]", output)
        exact, difference = re.search(r"origin by (\S+), and (\S+) by", output).groups()
        # The height is a factor, so a difference is off by roundings alone: 1e-16 / 2e-6.
        self.assertAlmostEqual(float(exact), float(difference), delta=2e-6)

    def test_sampled_rays_keep_their_tolerance(self):
        found = re.search(r"(\d+) x (\d+) rays, off by up to (\S+) degrees", self.output_of("python3 pond.py"))
        self.assertGreater(int(found[1]), 64)
        self.assertLessEqual(float(found[3]), 0.0002)

    def test_a_point_behind_the_wall_is_hidden(self):
        output = self.output_of("python3 photo.py")
        self.assertIn("160 x 90 pixels of uint8", output)
        self.assertEqual(re.findall(r": (.*)$", output, re.MULTILINE), ["seen", "hidden by walls"])

    def test_an_animation_has_its_frames(self):
        self.assertEqual(self.output_of("python3 turn.py").strip(),
                         "turn.01.png, turn.02.png, turn.03.png, turn.04.png")

    def test_the_measured_camera_is_the_original(self):
        self.assertIn("20 columns and 20 rows", self.output_of("python3 measure.py"))
        self.assertIn("no errors", self.output_of("balcony check measured.cam"))
        off = re.search(r"at most (\S+) degrees", self.output_of("python3 compare.py"))
        # The table is 4.25 degrees apart, with natural ends: a cubic is off by some h^2/12 of the
        # second derivative there, and the second derivative is below the number of radians.
        self.assertLess(float(off[1]), 4.25**2 * 3.15 / 180 / 12 * 1.5)


if __name__ == "__main__":
    guide.main()
