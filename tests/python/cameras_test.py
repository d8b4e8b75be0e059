# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Cameras, their parameters, and errors."""

import copy
import math
import pickle
import unittest
import warnings

import balcony
from scene_files import AIMED, RoomTest


class Cameras(RoomTest):
    def test_a_built_in_camera_has_its_parameters(self):
        cam = balcony.camera("pinhole", fov="60deg")
        self.assertEqual(cam.name, "pinhole")
        self.assertAlmostEqual(cam.fov, math.pi / 3, 15)
        fov = cam.parameters["fov"]
        self.assertEqual((fov.written, fov.is_angle), ("60deg", True))
        self.assertLess(fov.range[1], math.pi)
        self.assertIn("fov", dir(cam))
        self.assertIn("fov='60deg'", repr(cam))

    def test_parameters_are_attributes(self):
        cam = balcony.camera(AIMED)
        cam.fov = "2*atan(2)"
        self.assertAlmostEqual(cam.fov, 2 * math.atan(2), 15)
        cam.fov = 1
        self.assertEqual(cam.fov, 1.0)
        cam.spot = (1, 2.5, -3)
        self.assertEqual(cam.spot, "(1, 2.5, -3)")
        self.assertEqual(cam.set(fov=2, yaw=0.5), cam)
        self.assertEqual((cam.fov, cam.yaw), (2.0, 0.5))

    def test_a_copy_has_values_of_its_own(self):
        cam = balcony.camera(AIMED, fov=1)
        for other in (cam.copy(), copy.copy(cam), copy.deepcopy(cam),
                      pickle.loads(pickle.dumps(cam))):
            self.assertEqual((other.name, other.fov), ("aimed", 1.0))
            other.fov = 2
            self.assertEqual(cam.fov, 1.0)
        self.assertEqual(cam.copy(fov=1.5).fov, 1.5)

    def test_the_text_has_the_values_and_comments(self):
        cam = balcony.camera(AIMED, fov="30deg")
        self.assertIn("fov = 30deg from 1deg", cam.text)
        self.assertIn("// Looks around.", cam.text)
        self.assertTrue(str(cam).startswith("aimed\nLooks around.\n"))
        file = self.folder / "my.cam"
        cam.save(file)
        self.assertAlmostEqual(balcony.camera(file).fov, math.pi / 6, 15)
        self.assertAlmostEqual(balcony.camera(f"{file}:aimed").fov, math.pi / 6, 15)
        self.assertAlmostEqual(balcony.camera(file, "aimed", fov=1).fov, 1, 15)

    def test_it_draws_itself(self):
        self.assertTrue(balcony.camera("fisheye")._repr_svg_().startswith("<svg"))

    def test_built_in_cameras_are_found(self):
        self.assertGreater(len(balcony.cameras()), 150)
        self.assertIn("fisheye", balcony.cameras())
        self.assertIn("fisheye", balcony.cameras("fisheye")[:3])

    def test_a_check_finds_what_has_no_ray(self):
        found = balcony.camera("fisheye_orthographic").check(size=(165, 131))
        missing = next(one for one in found if one.name == "no ray")
        self.assertIn("has no ray", missing.message)
        x, y = missing.at
        self.assertFalse(balcony.camera("fisheye_orthographic").rays_at(
            [[x, y]], size=(165, 131)).valid[0])
        names = [one.name for one in
                 balcony.camera("pinhole", fov="20deg").check(balcony.load(self.room))]
        self.assertIn("never seen", names)


class Errors(RoomTest):
    def test_they_have_a_place_and_a_remedy(self):
        with self.assertRaises(balcony.InputError) as caught:
            balcony.camera("camera a {\n  eye shpere(1)\n}")
        error = caught.exception
        self.assertIsInstance(error, ValueError)
        self.assertIn("shpere", error.message)
        self.assertEqual((error.file, error.line, error.column), ("text", 2, 7))
        self.assertIn("sphere", error.remedy)
        self.assertIn("^~~~~~", str(error))
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual(str(again), str(error))

    def test_a_value_that_is_refused_changes_nothing(self):
        cam = balcony.camera(AIMED, fov=1)
        for value in (4, "4", "60 apples"):
            with self.assertRaises(balcony.InputError):
                cam.fov = value
        for value in (None, {}, True, object(), (1, None)):
            with self.assertRaises(TypeError):
                cam.fov = value
        for value in (float("nan"), float("inf")):
            with self.assertRaisesRegex(ValueError, "finite"):
                cam.fov = value
        self.assertEqual(cam.fov, 1.0)

    def test_a_name_that_is_not_known_is_answered_with_others(self):
        with self.assertRaisesRegex(balcony.InputError, "pinhole"):
            balcony.camera("pinhoel")
        cam = balcony.camera(AIMED)
        with self.assertRaisesRegex(AttributeError, "did you mean 'fov'"):
            cam.fovv
        with self.assertRaisesRegex(AttributeError, "its parameters are 'yaw', 'fov' and 'spot'"):
            cam.aperture
        with self.assertRaisesRegex(balcony.InputError, "fov"):
            cam.fovv = 1
        with self.assertRaises(AttributeError):
            cam.name = "other"
        with self.assertRaises(balcony.InputError):
            balcony.camera("no/such/file.cam")

    def test_options_are_called_as_here(self):
        with self.assertRaisesRegex(balcony.UsageError, "did you mean 'samples'"):
            balcony.render(self.room, "pinhole", smaples=4)
        with self.assertRaisesRegex(balcony.Error, r"\bsize") as caught:
            balcony.render(self.room, "pinhole", size=(0, 4))
        self.assertNotIn("--", str(caught.exception))

    def test_errors_of_the_machine_are_errors_of_the_system(self):
        picture = balcony.render(self.room, "pinhole", size=(8, 4), samples=1)
        with self.assertRaises(balcony.MachineError) as caught:
            picture.save("/dev/full/a.png")
        self.assertIsInstance(caught.exception, OSError)
        self.assertIn("/dev/full", str(caught.exception))
        self.assertEqual(str(pickle.loads(pickle.dumps(caught.exception))), str(caught.exception))

    def test_warnings_are_warnings(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            balcony.camera("camera a { let unused = 1 map u = 0 .. 1, v = 0 .. 1 eye point(0, 0, 0) toward sphere(1) }")
        self.assertTrue(any(one.category is balcony.BalconyWarning and "unused" in str(one.message)
                            for one in caught), [str(one.message) for one in caught])


if __name__ == "__main__":
    unittest.main()
