# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Rays, their inverse and their derivatives."""

import pickle
import unittest

import balcony
import numpy as np
from scene_files import AIMED

SIZE = (64, 48)


def places_along(rays, distance=3.0):
    return (rays.origins + distance * rays.directions)[rays.valid]


class Rays(unittest.TestCase):
    def test_they_are_those_of_the_formula(self):
        origins, directions, valid = balcony.camera(AIMED, spot=(1, 2, 3)).rays(*SIZE)
        self.assertEqual(origins.shape, (48, 64, 3))
        self.assertEqual((origins.dtype, valid.dtype), (np.float64, np.bool_))
        self.assertTrue(valid.all())
        np.testing.assert_array_equal(origins, np.broadcast_to([1, 2, 3], (48, 64, 3)))
        y, x = np.mgrid[0:48, 0:64] + 0.5
        wanted = np.stack([np.ones_like(x), 1 - x / 32, (24 - y) / 32], axis=-1)
        wanted /= np.linalg.norm(wanted, axis=-1, keepdims=True)
        np.testing.assert_allclose(directions, wanted, atol=1e-15)

    def test_those_at_points_are_the_same(self):
        cam = balcony.camera("fisheye_orthographic")
        of_pixels = cam.rays(*SIZE, footprints=True)
        y, x = np.mgrid[0:48, 0:64] + 0.5
        of_points = cam.rays_at(np.stack([x.ravel(), y.ravel()], axis=-1), size=SIZE,
                                footprints=True)
        self.assertEqual(of_points.footprints.shape, (48 * 64, 4, 3))
        self.assertFalse(of_points.valid.all())
        np.testing.assert_array_equal(of_pixels.valid.ravel(), of_points.valid)
        for one, other in ((of_pixels.directions, of_points.directions),
                           (of_pixels.parameters, of_points.parameters),
                           (of_pixels.footprints, of_points.footprints)):
            np.testing.assert_allclose(one.reshape(other.shape), other, atol=1e-12)
        self.assertEqual(np.abs(of_points.directions[~of_points.valid]).max(), 0)
        self.assertIsNone(of_points.times)
        self.assertIsNone(cam.rays(*SIZE).footprints)

    def test_footprints_are_derivatives(self):
        cam = balcony.camera("superelliptic")
        at = np.array([[20.0, 17.0], [41.5, 30.25]])
        found = cam.rays_at(at, size=SIZE, footprints=True)
        # The third derivative of these rays is below 1e-2 per pixel cubed: 1e-2 * step^2 is 1e-10.
        step = 1e-4
        for axis in (0, 1):
            more, less = at.copy(), at.copy()
            more[:, axis] += step
            less[:, axis] -= step
            after, before = cam.rays_at(more, size=SIZE), cam.rays_at(less, size=SIZE)
            np.testing.assert_allclose((after.origins - before.origins) / (2 * step),
                                       found.footprints[:, axis], atol=1e-9)
            np.testing.assert_allclose((after.directions - before.directions) / (2 * step),
                                       found.footprints[:, 2 + axis], atol=1e-9)

    def test_other_axes_turn_them(self):
        cam = balcony.camera(AIMED, spot=(1, 2, 3))
        z_up, y_up = cam.rays(*SIZE), cam.rays(*SIZE, axes="y_up")
        np.testing.assert_array_equal(y_up.origins, z_up.origins[..., [0, 2, 1]] * [1, 1, -1])
        with self.assertRaisesRegex(ValueError, "y_up"):
            cam.rays(*SIZE, axes="up")

    def test_a_changed_camera_has_other_rays(self):
        cam = balcony.camera(AIMED)
        before = cam.rays(*SIZE).directions
        cam.fov = "20deg"
        self.assertGreater(np.abs(cam.rays(*SIZE).directions - before).max(), 0.1)

    def test_sizes_and_shapes_that_cannot_be(self):
        cam = balcony.camera(AIMED)
        for size in ((0, 4), (4, 0)):
            with self.assertRaisesRegex(ValueError, "at least one pixel"):
                cam.rays(*size)
        with self.assertRaises(TypeError):
            cam.rays(-1, 4)
        with self.assertRaises(balcony.Error):
            cam.rays(10**6, 10**6)
        for points in ([1, 2, 3], [[[1, 2]]], 5, [[1], [2]]):
            with self.assertRaisesRegex(ValueError, "shape"):
                cam.rays_at(points, size=SIZE)
        for points in (["a", "b"], [[1j, 2]], [[None, 1]]):
            with self.assertRaisesRegex(TypeError, "real numbers"):
                cam.rays_at(points, size=SIZE)
        self.assertEqual(cam.rays_at(np.zeros((0, 2)), size=SIZE).valid.shape, (0,))

    def test_any_layout_and_type_of_numbers(self):
        cam = balcony.camera(AIMED)
        at = np.array([[1, 2], [3, 4], [5, 6]])
        wanted = cam.rays_at(at.astype(float), size=SIZE).directions
        wide = np.zeros((3, 7), np.float32)
        wide[:, 2:6:3] = at
        for points in (at, at.astype(np.float32), at[::-1][::-1], np.asfortranarray(at),
                       at.astype(">i4"), wide[:, 2:6:3], at.tolist()):
            np.testing.assert_array_equal(cam.rays_at(points, size=SIZE).directions, wanted)


class Places(unittest.TestCase):
    # It stands at (5, 6, 7) and looks along y.
    PLACES = {"balcony": [[0, -1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7]],
              "opencv": [[1, 0, 0, 5], [0, 0, 1, 6], [0, -1, 0, 7]],
              "opengl": [[1, 0, 0, 5], [0, 0, -1, 6], [0, 1, 0, 7], [0, 0, 0, 1]]}

    def test_a_matrix_in_any_axes_places_a_camera(self):
        cam = balcony.camera("pinhole", fov="90deg")
        for axes, pose in self.PLACES.items():
            rays = cam.placed(pose, axes).rays(65, 65)
            np.testing.assert_allclose(rays.origins[32, 32], [5, 6, 7], atol=1e-15)
            np.testing.assert_allclose(rays.directions[32, 32], [0, 1, 0], atol=1e-15)
            self.assertGreater(rays.directions[32, 64, 0], 0.5)  # To the right is x.
            self.assertGreater(rays.directions[0, 32, 2], 0.5)
            again = pickle.loads(pickle.dumps(cam.placed(pose, axes, world="y_up")))
            np.testing.assert_array_equal(again.rays(65, 65).directions,
                                          cam.placed(pose, axes, world="y_up").rays(65, 65).directions)
        np.testing.assert_array_equal(cam.rays(65, 65).origins[0, 0], [0, 0, 0])

    def test_the_world_of_the_matrix_may_have_y_up(self):
        # In a world with y up, it looks along -z and stands at (5, 7, -6).
        pose = [[1, 0, 0, 5], [0, -1, 0, 7], [0, 0, -1, -6]]
        cam = balcony.camera("pinhole").placed(pose, "opencv", world="y_up")
        rays = cam.rays(65, 65, axes="y_up")
        np.testing.assert_allclose(rays.origins[32, 32], [5, 7, -6], atol=1e-15)
        np.testing.assert_allclose(rays.directions[32, 32], [0, 0, -1], atol=1e-15)
        same = balcony.camera("pinhole").placed(self.PLACES["opencv"], "opencv").rays(65, 65)
        np.testing.assert_allclose(cam.rays(65, 65).directions, same.directions, atol=1e-15)
        seen = cam.project([[5, 7, -9]], size=(65, 65), axes="y_up")
        np.testing.assert_allclose(seen, [[32.5, 32.5]], atol=1e-9)

    def test_what_is_no_place(self):
        cam = balcony.camera("pinhole")
        for pose in (np.eye(3), np.eye(4)[:2], [1, 2, 3, 4]):
            with self.assertRaises(ValueError):
                cam.placed(pose)
        for pose in (2 * np.eye(4), np.diag([1, 1, -1, 1]), np.full((4, 4), np.nan)):
            with self.assertRaisesRegex(balcony.UsageError, "rotation"):
                cam.placed(pose)
        with self.assertRaisesRegex(balcony.UsageError, "did you mean 'opencv'"):
            cam.placed(np.eye(4), "opencb")


class Inverse(unittest.TestCase):
    def test_points_are_seen_where_their_rays_are(self):
        for name in ("pinhole", "fisheye", "superelliptic"):
            cam = balcony.camera(name)
            rays = cam.rays(*SIZE)
            y, x = np.mgrid[0:48, 0:64] + 0.5
            found = cam.project(places_along(rays), size=SIZE)
            # Newton's iteration ends below a millionth of a pixel.
            np.testing.assert_allclose(
                found, np.stack([x[rays.valid], y[rays.valid]], axis=-1), atol=1e-5)

    def test_what_is_not_seen_is_no_number(self):
        cam = balcony.camera(AIMED)
        found = cam.project([[1, 0, 0], [-1, 0, 0], [np.nan, 0, 0], [np.inf, 0, 0]], size=SIZE)
        np.testing.assert_allclose(found[0], [32, 24], atol=1e-9)
        self.assertTrue(np.isnan(found[1:]).all())
        self.assertEqual(cam.project(np.zeros((0, 3)), size=SIZE).shape, (0, 2))

    def test_all_sightings_of_a_point(self):
        cam = balcony.camera("""
            camera front { map u = 1 .. -1, v = square
                           eye point(0, 0, 0) toward plane((1, 0, 0)) }
            picture twice { layer front { place (0, 0) .. (0.5, 1) }
                            layer front { place (0.5, 0) .. (1, 1) } }""")
        self.assertEqual(cam.name, "twice")
        seen = cam.sightings([[9, 9, 99], [2, 0.2, 0]], size=SIZE)
        self.assertEqual(seen.point.tolist(), [1, 1])
        self.assertEqual(sorted(seen.layer.tolist()), [0, 1])
        self.assertAlmostEqual(abs(seen.position[0, 0] - seen.position[1, 0]), 32, 6)
        np.testing.assert_allclose(seen.distance, np.hypot(2, 0.2))
        front = seen.position[seen.layer == 1][0]
        np.testing.assert_array_equal(cam.project([[2, 0.2, 0]], size=SIZE)[0], front)


class Derivatives(unittest.TestCase):
    def test_of_positions(self):
        cam = balcony.camera(AIMED, fov=1.2, yaw=0.1)
        points = np.array([[4, 1, 0.5], [5, -1, 1], [-3, 0, 0]])
        # In the order that is asked for, which is not that of the camera.
        array, by = cam.jacobian(points, ["fov", "yaw"], size=SIZE)
        self.assertEqual((array.shape, by), ((3, 2, 2), ["fov", "yaw"]))
        self.assertTrue(np.isnan(array[2]).all())
        # As of footprints, with third derivatives below 1e3.
        step = 1e-5
        for j, name in enumerate(by):
            value = getattr(cam, name)
            after = cam.copy(**{name: value + step}).project(points[:2], size=SIZE)
            before = cam.copy(**{name: value - step}).project(points[:2], size=SIZE)
            np.testing.assert_allclose((after - before) / (2 * step), array[:2, :, j], atol=1e-5)

    def test_of_rays(self):
        cam = balcony.camera(AIMED, fov=1.2, yaw=0.1)
        at = np.array([[10.0, 20.0], [50.0, 3.5]])
        for axes in (None, "y_up"):
            array, by = cam.jacobian(at, size=SIZE, axes=axes)
            self.assertEqual((array.shape, by), ((2, 6, 2), ["yaw", "fov"]))
            step = 1e-5
            for j, name in enumerate(by):
                value = getattr(cam, name)
                after = cam.copy(**{name: value + step}).rays_at(at, size=SIZE, axes=axes)
                before = cam.copy(**{name: value - step}).rays_at(at, size=SIZE, axes=axes)
                np.testing.assert_allclose((after.directions - before.directions) / (2 * step),
                                           array[:, 3:, j], atol=1e-9)
                self.assertEqual(np.abs(array[:, :3]).max(), 0)

    def test_by_what_is_no_number(self):
        cam = balcony.camera(AIMED)
        with self.assertRaisesRegex(balcony.UsageError, "spot"):
            cam.jacobian([[1, 2, 3]], ["spot"], size=SIZE)
        with self.assertRaises(balcony.Error):
            cam.jacobian([[1, 2, 3]], ["nothing"], size=SIZE)
        with self.assertRaises(balcony.UsageError):
            cam.jacobian([[1, 2, 3]], size=SIZE, layer=7)


if __name__ == "__main__":
    unittest.main()
