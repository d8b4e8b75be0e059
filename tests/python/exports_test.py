# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Cameras for other programs, and cameras from what they are to show."""

import math
import unittest
from pathlib import Path

import balcony
import numpy as np
from scene_files import AIMED, RoomTest

SIZE = (64, 48)


class Exports(RoomTest):
    def test_the_exported_function_has_the_same_rays(self):
        cam = balcony.camera(AIMED, fov=1.2)
        self.assertIn("numpy", balcony.export_languages())
        module = {}
        exec(cam.export("numpy"), module)  # noqa: S102
        y, x = np.mgrid[0:48, 0:64] + 0.5
        origins, directions, valid = module["aimed_ray"](x, y, *SIZE)
        rays = cam.rays(*SIZE)
        np.testing.assert_allclose(directions, rays.directions, atol=1e-14)
        np.testing.assert_array_equal(origins, rays.origins)
        self.assertTrue(valid.all())
        with self.assertRaisesRegex(balcony.UsageError, "did you mean 'numpy'"):
            cam.export("nunpy")

    def test_ray_maps(self):
        cam = balcony.camera("fisheye_orthographic")
        file = self.folder / "rays.npy"
        cam.save_rays(file, *SIZE)
        rays = cam.rays(*SIZE)
        saved = np.load(file)
        self.assertEqual(saved.shape[:2], (48, 64))
        np.testing.assert_allclose(saved[..., 3:6], rays.directions, atol=1e-7)
        with self.assertRaises(balcony.Error):
            cam.save_rays(self.folder / "rays.txt", *SIZE)
        with self.assertRaises(balcony.Error):
            cam.save_rays(self.folder / "none" / "rays.exr", *SIZE)

    def test_a_camera_is_solved(self):
        camera = self.folder / "aimed.cam"
        camera.write_text(AIMED)
        truth = balcony.camera(AIMED, fov=1.2, yaw=0.1)
        points = {"a": [5, 1, 0.5], "b": [4, -1, 1], "c": [6, 0, -1]}
        seen = truth.project(list(points.values()), size=SIZE)
        marks = self.folder / "marks.yml"
        marks.write_text(
            "size: [64, 48]\nunknowns: [fov, yaw]\nmarks:\n"
            + "".join(f"  {name}: {point}\n" for name, point in points.items())
            + "constraints:\n"
            + "".join(f"  - {{at: {name}, position: [{x}, {y}]}}\n"
                      for name, (x, y) in zip(points, seen.tolist())))
        found = balcony.solve(camera, marks)
        self.assertEqual(set(found.values), {"fov", "yaw"})
        self.assertAlmostEqual(found.camera.fov, 1.2, 6)
        self.assertAlmostEqual(found.values["yaw"], 0.1, 6)
        self.assertLess(found.error, 1e-6)
        self.assertTrue(all(math.isfinite(one) for one in found.deviations.values()))
        marks.write_text("size: [64, 48]\nmarks:\n  a: [1, 2]\n")
        with self.assertRaises(balcony.InputError) as caught:
            balcony.solve(camera, marks)
        self.assertEqual(Path(caught.exception.file).name, "marks.yml")


if __name__ == "__main__":
    unittest.main()
