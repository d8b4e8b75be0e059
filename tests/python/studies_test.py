# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Photos in the pictures of cameras, what hides points, and animations."""

import os
import subprocess
import sys
import time
import unittest
from pathlib import Path

import balcony
import numpy as np
from scene_files import AIMED, RoomTest

SIZE = (64, 48)


def command():
    """The command of this build, beside the folder of the module."""
    folder = next(Path(one) for one in os.environ["PYTHONPATH"].split(":")
                  if (Path(one) / "balcony").is_dir())
    return folder.parent / "balcony"


def colours(width, height, kind=np.uint8, channels=3):
    """Smooth noise, no two pixels alike."""
    y, x = np.mgrid[0:height, 0:width]
    most = np.iinfo(kind).max if np.issubdtype(kind, np.integer) else 1
    bands = [0.5 + 0.5 * np.sin(x / width * a + y / height * b) for a, b in ((5, 3), (2, 7), (11, 1))]
    bands.append(np.ones_like(bands[0]))
    return (np.stack(bands[:channels], axis=-1) * most).astype(kind)


class Warp(RoomTest):
    def test_a_camera_shows_its_own_photo_as_it_is(self):
        for kind in (np.uint8, np.uint16, np.float32):
            for channels in (1, 3, 4):
                photo = colours(*SIZE, kind, channels)
                found = balcony.warp(photo, AIMED, AIMED, size=SIZE)
                self.assertEqual((found.shape, found.dtype), ((48, 64, 4), photo.dtype))
                wanted = np.repeat(photo, 3, axis=-1) if channels == 1 else photo[..., :3]
                most = np.iinfo(kind).max if kind != np.float32 else 1.0
                # The curve of sRGB, to linear light and back, in floats: 6e-8 of values up to 1, times
                # its slope of at most 12.92. A whole number may then be rounded to its neighbour.
                limit = 1e-6 if kind == np.float32 else 1 if kind == np.uint16 else 0
                self.assertLessEqual(np.abs(found[..., :3].astype(float) - wanted).max(), limit)
                self.assertEqual((found[..., 3].min(), found[..., 3].max()), (most, most))

    def test_an_array_is_warped_as_its_file(self):
        photo = colours(128, 64)
        scene = balcony.load(self.room)
        picture = scene.render("panorama", size=(128, 64), samples=1)
        picture.save(self.folder / "photo.png")
        file = self.folder / "photo.png"
        balcony.warp(file, "panorama", AIMED, size=SIZE, output=self.folder / "view.png")
        subprocess.run([command(), "warp", file, "--from", "panorama", "--camera", self.camera_file(),
                        "--size", "64x48", "-o", self.folder / "command.png", "--quiet"], check=True)
        self.assertEqual((self.folder / "view.png").read_bytes(),
                         (self.folder / "command.png").read_bytes())
        # A picture is light, of which its file has 8 bits.
        from_file = balcony.warp(file, "panorama", AIMED, size=SIZE)
        self.assertEqual(from_file.dtype, np.uint8)
        from_array = balcony.warp(picture.pixels(), "panorama", AIMED, size=SIZE)
        self.assertLessEqual(np.abs(from_array.astype(int) - from_file).max(), 1)
        light = balcony.warp(picture, "panorama", AIMED, size=SIZE)
        self.assertEqual((light.dtype, light.shape), (np.float32, (48, 64, 4)))
        self.assertTrue(np.isfinite(light).all())
        del photo

    def camera_file(self):
        file = self.folder / "aimed.cam"
        file.write_text(AIMED)
        return file

    def test_the_map_is_where_the_photo_shows_the_rays(self):
        cam = balcony.camera(AIMED)
        panorama = balcony.camera("panorama")
        found = cam.stmap(panorama, size=SIZE, photo_size=(256, 128))
        self.assertEqual((found.shape, found.dtype), ((48, 64, 4), np.float32))
        rays = cam.rays(*SIZE)
        at = panorama.project(rays.origins.reshape(-1, 3) + rays.directions.reshape(-1, 3),
                              size=(256, 128)).reshape(48, 64, 2)
        wanted = at / [256, -128] + [0, 1]
        # 32-bit floats up to 1 are within 6e-8; the search ends within 1e-8 pixel.
        np.testing.assert_allclose(found[..., :2], wanted, atol=1e-7)
        self.assertEqual((found[..., 2].max(), found[..., 3].min()), (0, 1))

    def test_the_file_of_a_map_is_that_of_the_command(self):
        cam = balcony.camera("fisheye")
        cam.save_stmap(self.folder / "own.exr", "pinhole", size=32)
        subprocess.run([command(), "stmap", "fisheye", "--from", "pinhole", "--size", "32",
                        "-o", self.folder / "command.exr", "--quiet"], check=True)
        self.assertEqual((self.folder / "own.exr").read_bytes(),
                         (self.folder / "command.exr").read_bytes())
        found = cam.stmap("pinhole", size=32)
        self.assertEqual(found.shape, (32, 32, 4))
        self.assertEqual(np.abs(found[found[..., 3] == 0]).max(), 0)

    def test_a_camera_without_a_viewpoint(self):
        photo = colours(64, 32)
        with self.assertRaisesRegex(balcony.InputError, "single viewpoint.*") as caught:
            balcony.warp(photo, "panorama", "superelliptic", size=32)
        self.assertIn("allow_parallax", caught.exception.remedy)
        with self.assertWarnsRegex(balcony.BalconyWarning, "single viewpoint"):
            balcony.warp(photo, "panorama", "superelliptic", size=32, allow_parallax=True)

    def test_photos_that_cannot_be(self):
        for photo, wrong in ((np.zeros((4, 4, 5), np.uint8), ValueError),
                             (np.zeros((4,), np.uint8), ValueError),
                             (np.zeros((0, 4, 3), np.uint8), ValueError),
                             (np.zeros((4, 4, 3), np.int64), TypeError),
                             (np.zeros((4, 4, 3), complex), TypeError),
                             ("none.png", balcony.InputError)):
            with self.assertRaises(wrong):
                balcony.warp(photo, AIMED, AIMED, size=8)
        for size in ((4,), (1, 2, 3), "8", 2.5, (8, 4.5)):
            with self.assertRaisesRegex(TypeError, "'size' is"):
                balcony.warp(colours(8, 8), AIMED, AIMED, size=size)
        for size in (0, (0, 4), (8, 2_000_000), -1):
            with self.assertRaises((ValueError, TypeError)):
                balcony.warp(colours(8, 8), AIMED, AIMED, size=size)
        with self.assertRaises(balcony.UsageError):
            balcony.camera(AIMED).save_stmap(self.folder / "st.png", AIMED, size=8)
        with self.assertRaises(balcony.Error):
            balcony.warp(colours(8, 8), AIMED, AIMED, size=8, output=self.folder / "none" / "a.png")
        photo = colours(8, 8, np.float32)
        photo[2:4, 2:4] = np.nan
        self.assertTrue(np.isfinite(balcony.warp(photo, AIMED, AIMED, size=8)).all())


class Locate(RoomTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        # A wall across the room at x = 1, from the floor up to 1, in front of what is behind it.
        cls.walled = cls.folder / "walled.obj"
        cls.walled.write_text(cls.room.read_text()
                              + "v 1 0 -2\nv 1 0 2\nv 1 1 2\nv 1 1 -2\no wall\nf 9 10 11 12\n")
        cls.scene = balcony.load(cls.walled)
        # At (0, 1.2, 0) of a scene with y up.
        cls.cam = balcony.camera(AIMED, spot=(0, 0, 1.2)).placed(np.eye(4))

    def test_what_hides_points_is_what_the_picture_shows(self):
        points = np.random.default_rng(1).uniform([0.2, 0.05, -1.5], [2.9, 2.4, 1.5], (400, 3))
        found = self.cam.locate(points, self.scene, size=SIZE)
        sightings = self.cam.sightings(points, size=SIZE, scene=self.scene)
        for name in ("point", "layer", "position", "origin", "distance"):
            np.testing.assert_array_equal(getattr(found, name), getattr(sightings, name))
        # By hand: the line from the eye crosses x = 1 below 1.
        at = points[found.point]
        height = 1.2 + (at[:, 1] - 1.2) / at[:, 0]
        hidden = (at[:, 0] > 1) & (height < 1)
        self.assertTrue(hidden.any() and not hidden.all())
        np.testing.assert_array_equal(found.hidden, hidden)
        self.assertEqual({*found.hidden_by}, {"wall", None})
        self.assertEqual(found.objects, self.scene.objects)
        to_wall = np.linalg.norm(at - [0, 1.2, 0], axis=1) / at[:, 0]
        np.testing.assert_allclose(found.obstacle_distance[hidden], to_wall[hidden], rtol=1e-6)
        self.assertTrue(np.isnan(found.obstacle_distance[~hidden]).all())
        # The depth layer: what is hidden is deeper than what its pixel shows.
        picture = self.scene.render(self.cam, size=SIZE, samples=1)
        x, y = np.floor(found.position).astype(int).T
        rays = self.cam.rays(*SIZE, scene=self.scene)
        # The ray of a pixel's middle is up to 0.02 off, which moves its hit by less than 0.2 here.
        depth = picture["depth"][y, x]
        self.assertTrue((found.distance[hidden] > depth[hidden] - 0.2).all())
        self.assertTrue((found.distance[~hidden] < depth[~hidden] + 0.2).mean() > 0.99)
        self.assertEqual(rays.valid.shape, depth.shape[:0] + (48, 64))

    def test_points_that_are_not_seen(self):
        with self.assertWarns(balcony.BalconyWarning):
            found = self.cam.locate([[-5, 1, 0]], self.scene, size=SIZE)
        self.assertEqual((len(found.point), found.hidden.shape, found.hidden_by), (0, (0,), []))
        found = self.cam.locate(np.empty((0, 3)), self.scene, size=SIZE)
        self.assertEqual(found.position.shape, (0, 2))
        for points in (np.zeros((3, 2)), "points", np.zeros((2, 2, 3))):
            with self.assertRaises((ValueError, TypeError)):
                self.cam.locate(points, self.scene, size=SIZE)
        with self.assertRaises((TypeError, AttributeError)):
            self.cam.locate([[1, 1, 1]], None, size=SIZE)

    def test_a_changed_camera_is_asked_anew(self):
        cam = balcony.camera(AIMED, spot=(0, 0, 1.2)).placed(np.eye(4))
        before = cam.locate([[2, 1.5, 0.3]], self.scene, size=SIZE).position
        cam.fov = "40deg"
        after = cam.locate([[2, 1.5, 0.3]], self.scene, size=SIZE).position
        np.testing.assert_allclose(after, cam.project([[2, 1.5, 0.3]], size=SIZE, scene=self.scene))
        self.assertGreater(np.abs(after - before).max(), 1)


class Animate(RoomTest):
    TURN = AIMED.replace("rotate(z, yaw)", "rotate(z, yaw + t*90deg)")

    def frames(self, name, **options):
        cam = balcony.camera(self.TURN, spot=(0, 0, 1)).placed(np.eye(4))
        return balcony.animate(balcony.load(self.room), cam, self.folder / name,
                               **{"size": (16, 12), "samples": 1, "fps": 2, **options})

    def test_frames_are_pictures_at_their_times(self):
        told = []
        files = self.frames("turn.##.exr", frames=range(1, 4), progress=told.append)
        self.assertEqual([Path(one).name for one in files], ["turn.01.exr", "turn.02.exr", "turn.03.exr"])
        self.assertTrue(all(Path(one).stat().st_size for one in files))
        self.assertTrue(all(0 <= one <= 1 for one in told))
        scene = balcony.load(self.room)
        cam = balcony.camera(self.TURN, spot=(0, 0, 1)).placed(np.eye(4))
        for number, file in enumerate(files):
            scene.time = number / 2
            wanted = scene.render(cam, size=(16, 12), samples=1, seed=number + 1)
            wanted.save(self.folder / "wanted.exr")
            frame = balcony.warp(file, AIMED, AIMED, size=(16, 12))
            picture = balcony.warp(self.folder / "wanted.exr", AIMED, AIMED, size=(16, 12))
            np.testing.assert_array_equal(frame, picture)

    def test_finished_frames_are_kept(self):
        files = self.frames("kept.#.exr", frames="1-2")
        before = [os.stat(one).st_mtime_ns for one in files]
        more = self.frames("kept.#.exr", frames="1-3")
        self.assertEqual(more[:2], files)
        self.assertEqual([os.stat(one).st_mtime_ns for one in more[:2]], before)
        with self.assertRaisesRegex(balcony.InputError, "another animation"):
            self.frames("kept.#.exr", frames="1-3", samples=2)
        self.frames("kept.#.exr", frames="1-3", samples=2, overwrite=True)
        self.assertNotEqual(os.stat(files[0]).st_mtime_ns, before[0])

    def test_another_camera_is_another_animation(self):
        scene = balcony.load(self.room)
        cam = balcony.camera(AIMED).placed(np.eye(4))
        output = self.folder / "camera.#.exr"
        arguments = {"frames": [1], "size": (8, 8), "samples": 1}
        balcony.animate(scene, cam, output, **arguments)
        balcony.animate(scene, cam, output, **arguments)
        for other in (cam.copy(fov="50deg"), cam.placed(np.diag([1.0, -1, -1, 1]))):
            with self.assertRaisesRegex(balcony.InputError, "another animation"):
                balcony.animate(scene, other, output, **arguments)

    def test_a_scene_with_other_changes_is_another_animation(self):
        def animate(**lamp):
            scene = balcony.load(self.room)
            scene["floor"].move(0, 0.1, 0)
            scene.add_light("lamp", position=(0, 2, 0), **lamp)
            return balcony.animate(scene, balcony.camera(AIMED).placed(np.eye(4)), self.folder / "edited.#.exr",
                                   [1], size=(8, 8), samples=1)

        files = animate(intensity=5)
        before = os.stat(files[0]).st_mtime_ns
        self.assertEqual(os.stat(animate(intensity=5)[0]).st_mtime_ns, before)
        with self.assertRaisesRegex(balcony.InputError, "another animation"):
            animate(intensity=6)

    def test_a_turntable_of_a_scene_by_its_file(self):
        words = {"size": 8, "samples": 1, "turntable": True, "lamp": "point 100 at 0,2,0"}
        files = balcony.animate(self.room, None, self.folder / "table.#.exr", 4, **words)
        self.assertEqual([Path(one).name for one in files], ["table.4.exr"])
        files = balcony.animate(self.room, None, self.folder / "turn.#.exr", range(1, 4), **words)
        first, second, _ = (balcony.warp(one, AIMED, AIMED, size=(8, 8)) for one in files)
        self.assertFalse(np.array_equal(first, second))

    def test_the_time_of_the_scene_stays(self):
        scene = balcony.load(self.room)
        scene.time = 0.75
        cam = balcony.camera(self.TURN).placed(np.eye(4))
        before = scene.render(cam, size=8, samples=1)["position"]
        balcony.animate(scene, cam, self.folder / "time.#.exr", [1, 2], size=8, samples=1)
        self.assertEqual(scene.time, 0.75)
        np.testing.assert_array_equal(scene.render(cam, size=8, samples=1)["position"], before)

    def test_an_interrupt_keeps_what_is_finished(self):
        text = ("import balcony, sys\n"
                f"scene = balcony.load({str(self.room)!r})\n"
                "def tell(done):\n"
                "    if done > 0.3:\n"
                "        raise KeyboardInterrupt\n"
                "try:\n"
                f"    balcony.animate(scene, 'fisheye', {str(self.folder / 'stop.##.exr')!r}, range(1, 9),\n"
                "                    size=(160, 120), samples=16, progress=tell)\n"
                "except KeyboardInterrupt:\n"
                "    print('stopped')\n")
        began = time.monotonic()
        output = subprocess.run([sys.executable, "-B", "-c", text], check=True, capture_output=True,
                                text=True).stdout
        self.assertEqual(output, "stopped\n")
        finished = sorted(self.folder.glob("stop.??.exr"))
        self.assertTrue(1 <= len(finished) < 8, finished)
        self.assertLess(time.monotonic() - began, 100)

    def test_what_cannot_be_animated(self):
        for name, options, wrong in (("turn.mpg", {}, balcony.Error),
                                     ("turn.png", {"frames": 3}, balcony.UsageError),
                                     ("turn.#.png", {"frames": "none"}, balcony.UsageError),
                                     ("turn.#.png", {"frames": 1, "turntabel": True}, balcony.UsageError),
                                     ("turn.#.png", {"frames": 1, "lamp": "0,2,0"}, balcony.UsageError),
                                     ("none/turn.#.png", {"frames": 1}, balcony.Error)):
            with self.assertRaises(wrong, msg=(name, options)):
                self.frames(name, **options)


if __name__ == "__main__":
    unittest.main()
