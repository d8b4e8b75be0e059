# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Data sets."""

import unittest

import balcony
import numpy as np
from scene_files import AIMED, RoomTest


class Datasets(RoomTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "aimed.cam").write_text(AIMED)
        cls.recipe = {
            "seed": 5,
            "scenes": [{"scene": cls.room, "name": "hall"}],
            "cameras": [{"camera": cls.folder / "aimed.cam", "set": {"fov": "60deg"}}, "panorama"],
            "poses": [{"random": 2, "clearance": np.float64(0.25)}],
            "layers": ["rgb", "depth", "object", "rays", "valid"],
            "render": {"size": (24, 16), "samples": 1},
        }
        cls.told = []
        cls.made = balcony.dataset(cls.recipe, cls.folder / "out", progress=cls.told.append)

    def test_frames_have_arrays(self):
        self.assertEqual(len(self.made), 4)
        self.assertEqual([frame.camera for frame in self.made],
                         ["aimed", "aimed", "panorama", "panorama"])
        for i, frame in enumerate(self.made):
            self.assertEqual(frame.index, i)
            self.assertTrue(frame.is_finished)
            self.assertEqual(set(frame), {"rgb", "rays", "depth", "object", "valid"})
            self.assertEqual((frame["rgb"].dtype, frame["rgb"].shape[:2]), (np.uint8, (16, 24)))
            self.assertEqual((frame["depth"].dtype, frame["depth"].shape), (np.float32, (16, 24)))
            self.assertEqual((frame["object"].dtype, frame["rays"].shape), (np.uint32, (16, 24, 6)))
            self.assertEqual(frame["valid"].dtype, np.uint8)
        with self.assertRaisesRegex(KeyError, "did you mean 'depth'"):
            self.made[0]["dept"]
        self.assertIn("4 frames", repr(self.made))

    def test_rays_are_those_of_the_camera_in_the_pose(self):
        cam = balcony.camera(self.folder / "aimed.cam", fov="60deg")
        for frame in list(self.made)[:2]:
            placed = cam.placed(frame.matrix, "opencv", world="y_up")
            rays = placed.rays(24, 16, axes="y_up")
            # Floats at 4 units.
            np.testing.assert_allclose(frame["rays"][..., :3], rays.origins, atol=5e-7)
            np.testing.assert_allclose(frame["rays"][..., 3:], rays.directions, atol=5e-7)

    def test_progress_is_told(self):
        self.assertEqual(self.told[-1], 1)
        self.assertEqual(self.told, sorted(self.told))

    def test_finished_frames_are_kept(self):
        times = [file.stat().st_mtime_ns for file in self.made[0].files.values()]
        again = balcony.dataset(self.recipe, self.folder / "out")
        self.assertEqual(times, [file.stat().st_mtime_ns for file in again[0].files.values()])

    def test_the_camera_has_its_intrinsics(self):
        intrinsics = self.made.camera(self.made[0])["intrinsics"]
        self.assertEqual(intrinsics["model"], "pinhole")
        self.assertAlmostEqual(intrinsics["fx"], 12 / np.tan(np.pi / 6), places=9)
        self.assertIsNone(self.made.camera(self.made[2])["intrinsics"])

    def test_shards(self):
        for part in (1, 2):
            made = balcony.dataset(self.recipe, self.folder / "parts", shard=(part, 2))
        for one, other in zip(made, self.made):
            np.testing.assert_array_equal(one["depth"], other["depth"])
        with self.assertRaisesRegex(ValueError, "shard"):
            balcony.dataset(self.recipe, self.folder / "parts", shard=(3, 2))

    def test_mistakes_are_exceptions_with_their_place(self):
        with self.assertRaisesRegex(balcony.InputError, "did you mean 'random'"):
            balcony.dataset({**self.recipe, "poses": [{"random": 2, "randon": 3}]},
                            self.folder / "wrong")
        with self.assertRaises(TypeError):
            balcony.dataset({**self.recipe, "seed": object()}, self.folder / "wrong")
        with self.assertRaises(balcony.UsageError):
            balcony.dataset({**self.recipe, "seed": 6}, self.folder / "out")
        self.assertFalse((self.folder / "wrong").exists())


if __name__ == "__main__":
    unittest.main()
