# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Scenes, pictures and their layers."""

import struct
import tempfile
import time
import unittest
from pathlib import Path

import balcony
import numpy as np
from scene_files import RoomTest

SIZE = (48, 32)


class Pictures(RoomTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.scene = balcony.load(cls.room)
        cls.cam = balcony.camera("fisheye", fov="170deg")

    def picture(self, **options):
        return self.scene.render(self.cam, **{"size": SIZE, "samples": 4, **options})

    def test_a_scene_has_its_objects(self):
        self.assertEqual(self.scene.objects, ["floor", "ceiling", "walls"])
        self.assertEqual((self.scene.cameras, self.scene.axes), ([], "y_up"))
        self.assertIn("3 objects", repr(self.scene))

    def test_layers_are_arrays(self):
        picture = self.picture()
        self.assertEqual((picture.width, picture.height), SIZE)
        self.assertEqual(picture["color"].shape, (32, 48, 4))
        self.assertEqual(picture["normal"].shape, (32, 48, 3))
        self.assertEqual(picture["depth"].dtype, np.float32)
        self.assertIs(picture["depth"], picture["ray_length"])
        self.assertEqual(set(picture.about), set(picture))
        self.assertEqual(len(picture), len(list(picture)))
        for name, meaning in picture.about.items():
            self.assertTrue(meaning)
            self.assertEqual(picture[name].shape[:2], (32, 48), name)
        with self.assertRaisesRegex(KeyError, "did you mean 'normal'"):
            picture["normals"]
        self.assertIn("fisheye, 48 x 32", repr(picture))

    def test_layers_agree_with_the_rays_of_the_scene(self):
        picture = self.picture()
        rays = self.cam.rays(*SIZE, scene=self.scene)
        np.testing.assert_array_equal(picture["valid"].astype(bool), rays.valid)
        # Floats of size 4.
        np.testing.assert_allclose(picture["direction"], rays.directions, atol=1e-6)
        hits = rays.origins + picture["depth"][..., None] * rays.directions
        np.testing.assert_allclose(hits[rays.valid], picture["position"][rays.valid], atol=1e-5)
        # Every third point, since the inverse takes its time: it is where its ray is.
        seen = self.cam.project(hits[rays.valid][::3], size=SIZE, scene=self.scene)
        y, x = np.mgrid[0:32, 0:48] + 0.5
        wanted = np.stack([x[rays.valid], y[rays.valid]], axis=-1)[::3]
        np.testing.assert_allclose(seen, wanted, atol=1e-3)
        walls = self.scene.objects.index("walls") + 1
        self.assertTrue((np.abs(hits[picture["object"] == walls])[:, [0, 2]] > 1.99).any(axis=1).all())

    def test_pixels_are_those_of_the_file(self):
        picture = self.picture()
        pixels = picture.pixels()
        self.assertEqual((pixels.shape, pixels.dtype), ((32, 48, 3), np.uint8))
        self.assertGreater(picture.pixels(exposure=picture.exposure + 1).mean(), pixels.mean())
        file = self.folder / "picture.png"
        picture.save(file)
        self.assertEqual(file.read_bytes(), picture._repr_png_())
        layers = self.folder / "picture.exr"
        picture.save(layers)
        self.assertIn(b"ray_length.Z", layers.read_bytes())

    def test_options_are_those_of_the_command(self):
        picture = self.picture(layers="default,motion,variance", noise=0.5, seed=3,
                               exposure=1.5, time_limit=None, no_dither=True, samples=8)
        self.assertEqual(picture.exposure, 1.5)
        self.assertEqual(picture["motion"].shape, (32, 48, 4))
        with self.assertRaisesRegex(KeyError, "no layer 'motion'"):
            self.picture()["motion"]
        for wrong in ({"samples": "many"}, {"samples": -1}, {"size": (1, 2, 3)}):
            with self.assertRaises(balcony.Error):
                self.picture(**wrong)
        with self.assertRaises(TypeError):
            self.picture(samples=object())

    def test_pictures_have_the_options_of_their_scene(self):
        bright = balcony.load(self.room, environment=8, samples=4, size=SIZE)
        dark = bright.render(self.cam, environment=4)
        np.testing.assert_array_equal(
            bright.render(self.cam)["color"],
            balcony.render(self.room, self.cam, environment=8, samples=4, size=SIZE)["color"])
        self.assertEqual((dark.width, dark.height), SIZE)
        for option in ({"time": 1}, {"set": ["fov=1rad"]}, {"lamp": ["0,1,0"]}, {"fit": True},
                       {"shutter": 1}):
            with self.assertRaisesRegex(balcony.UsageError, "no option of a picture"):
                bright.render(self.cam, **option)

    def test_a_scene_places_cameras_as_it_is_told(self):
        # A pinhole that is fitted to an object has its middle in the middle of the picture.
        for name, height in (("floor", 0), ("ceiling", 2.5)):
            scene = balcony.load(self.room, fit_to=name)
            at = balcony.camera("pinhole").project([[0, height, 0]], size=SIZE, scene=scene)
            np.testing.assert_allclose(at, [[SIZE[0] / 2, SIZE[1] / 2]], atol=1e-6)
            self.assertEqual(scene.render("pinhole", size=SIZE, samples=1).width, SIZE[0])
        for option in ({"camera": "pinhole"}, {"set": ["fov=1rad"]}):
            with self.assertRaisesRegex(balcony.UsageError, "no option of a scene"):
                balcony.load(self.room, **option)

    def test_a_scale_in_place_of_a_size(self):
        # The room is 6 wide, in centimetres here; the camera shows all of it.
        scene = balcony.load(self.room, unit="cm")
        cam = balcony.camera("orthographic", width=6, height=2.5)
        picture = scene.render(cam, mm_per_pixel=0.5, samples=1)
        self.assertEqual((picture.width, picture.height), (120, 50))
        with tempfile.TemporaryDirectory() as folder:
            picture.save(f"{folder}/plan.png")
            # 25.4 / 0.5 pixels per inch are 2000 per metre, which PNG files name.
            written = Path(folder, "plan.png").read_bytes()
            at = written.index(b"pHYs") + 4
            self.assertEqual(struct.unpack(">IIB", written[at:at + 9]), (2000, 2000, 1))
        with self.assertRaisesRegex(balcony.UsageError, "has no scale"):
            scene.render(self.cam, mm_per_pixel=0.5)
        with self.assertRaisesRegex(balcony.UsageError, "how long its unit is"):
            self.scene.render(cam, mm_per_pixel=0.5)

    def test_one_call_renders_a_file(self):
        picture = balcony.render(self.room, "fisheye", size=SIZE, samples=4)
        again = balcony.render(self.scene, balcony.camera("fisheye"), size=SIZE, samples=4)
        np.testing.assert_array_equal(picture["color"], again["color"])
        self.assertEqual(balcony.render(self.room, size=SIZE, samples=1).camera, "default view")
        with self.assertRaises(balcony.InputError):
            balcony.render(self.folder / "no.glb", "fisheye")
        with self.assertRaises(balcony.InputError):
            self.scene.render("scene:none", size=SIZE)

    def test_progress_is_told_by_the_thread_that_called(self):
        told = []
        self.picture(size=(320, 240), samples=64, progress=told.append)
        self.assertEqual(told, sorted(told))
        self.assertTrue(all(0 < one <= 1 for one in told))
        self.assertGreater(len(told), 0)

        def fail(done):
            raise RuntimeError("enough")

        began = time.monotonic()
        with self.assertRaisesRegex(RuntimeError, "enough"):
            self.picture(size=(320, 240), samples=100000, progress=fail)
        self.assertLess(time.monotonic() - began, 60)  # All samples take hours.

    def test_arrays_outlive_their_picture(self):
        color = self.picture()["color"]
        copy = color.copy()
        for _ in range(3):
            self.picture()
        np.testing.assert_array_equal(color, copy)


if __name__ == "__main__":
    unittest.main()
