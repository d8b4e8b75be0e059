# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Each layout of data sets, read back by NumPy as the documentation of the other program says: rays
made of what its files have must meet the faces of a cube that the pictures show, and hits must be
projected back to their pixels."""

import json
import re

import cube
import numpy as np
import support

CAMERAS = """
camera pin { eye opencv_pinhole(width = 64, height = 48, fx = 60, fy = 66, cx = 29.5, cy = 26) }
camera webcam {
    eye opencv_pinhole(width = 64, height = 48, fx = 60, fy = 66, cx = 33, cy = 21, k1 = -0.2,
                       k2 = 0.05, p1 = 0.002, p2 = -0.003, k3 = 0.01)
}
camera fish {
    eye opencv_fisheye(width = 64, height = 48, fx = 30, fy = 33, cx = 30, cy = 25, k1 = 0.02,
                       k2 = -0.01, k3 = 0.003, k4 = 0.001)
}
camera omni {
    eye omnidirectional(width = 64, height = 48, xi = 1.3, fx = 70, fy = 74, cx = 33, cy = 22,
                        k1 = -0.1, k2 = 0.02)
}
// A pinhole that stands beside its place and looks another way: to its left and down.
camera aside {
    map u = 0.5 .. -0.5, v = square
    eye point(0, 0, 0)
    toward plane((1, 0, 0))
    move rotate(y, 8deg), rotate(z, 10deg), translate(0.2, -0.1, 0.3)
}
// Its rays start on a line.
camera slit {
    map u = 1.5 .. -1.5, v = square
    eye line((0, 0, 0), (0, 1, 0))
    toward surface(u, v) = [1, 1.1*u, 0.4*v]
}
// All rays are parallel.
camera flat {
    map u = 2 .. -2, v = square
    eye plane((0, 0, 0))
    look normal
}
"""

# Places around the cube, in all directions, with the camera upright; and one that is not.
RECIPE = """
layers = ["rgb", "depth", "valid", "rays"]
layouts = [LAYOUTS]
cameras = [CAMERAS]

[render]
size = "64x48"
samples = 4
filter = "box"
exposure = 0
view-transform = "standard"

[[scenes]]
scene = "cube.obj"

[[poses]]
path = 5
closed = true
keys = [
    {at = [4, 1.5, 0.4], look_at = [0.3, 0.2, -0.1]},
    {at = [0.1, -2.4, 3.8], look_at = [0.3, 0.2, -0.1]},
    {at = [-4, 2, 0.2], look_at = [0.5, 0.2, -0.1]},
    {at = [0.6, -0.5, -4], look_at = [0.3, 0.4, -0.1]},
]

[[poses]]
list = [[[0.36, 0.48, -0.8, 4.2], [-0.8, 0.6, 0, 0.4], [0.48, 0.64, 0.6, -3.4]]]
"""


def pixels(height, width):
    """x and y of the middles of pixels, from the corner of the first one."""
    y, x = np.mgrid[:height, :width] + 0.5
    return x, y


def fourth_row(matrix):
    return np.vstack([matrix, [0, 0, 0, 1]])


def moved(matrix, points):
    return points @ matrix[:3, :3].T + matrix[:3, 3]


class Layouts(support.CommandTest):
    def make(self, layout, *cameras):
        cube.write(self.folder)
        (self.folder / "lenses.cam").write_text(CAMERAS)
        text = RECIPE.replace("LAYOUTS", f'"{layout}"')
        text = text.replace("CAMERAS", ", ".join(f'"lenses.cam:{name}"' for name in cameras))
        (self.folder / "cube.toml").write_text(text)
        self.run_command("dataset", "cube.toml", "-o", "out", "-q")
        self.manifest = json.loads((self.folder / "out/manifest.json").read_text())
        return self.folder / "out/cube"

    def picture(self, file):
        return np.array(support.png_pixels(file)[2], np.uint8)

    def check_sight(self, origins, directions, file):
        """Rays with y up see what the picture shows; none is seen in vain."""
        faces, _ = cube.seen(origins, directions)
        certain = cube.inner(faces)
        self.assertGreater((certain & (faces != cube.NOTHING)).sum(), 50)
        np.testing.assert_array_equal(cube.faces_in(self.picture(file))[certain], faces[certain])
        return set(np.unique(faces[certain])) - {cube.NOTHING}

    def check_hits(self, folder, name, project):
        """What the pixels show is projected back to them: project(places with y up) gives x, y."""
        rays = np.load(folder / f"rays/{name}.npy").astype(float)
        depth = np.load(folder / f"depth/{name}.npy").astype(float)
        hit = np.isfinite(depth)
        places = rays[hit][:, :3] + depth[hit][:, None] * rays[hit][:, 3:]
        x, y = pixels(*depth.shape)
        # Floats at 5 units, and 70 pixels a unit at the distance of 1.
        np.testing.assert_allclose(np.stack(project(places), axis=-1),
                                   np.stack([x[hit], y[hit]], axis=-1), atol=1e-3)

    def frames_of(self, camera):
        return [frame["name"] for frame in self.manifest["frames"] if frame["camera"] == camera]

    # ---------------------------------------------------------------------------- nerfstudio

    def opencv(self, camera, d):
        """The projection of OpenCV's model with what nerfstudio names; axes of OpenCV."""
        a, b = d[:, 0] / d[:, 2], d[:, 1] / d[:, 2]
        r2 = a * a + b * b
        radial = 1 + sum(camera[f"k{i}"] * r2**i for i in (1, 2, 3, 4))
        x = a * radial + 2 * camera["p1"] * a * b + camera["p2"] * (r2 + 2 * a * a)
        y = b * radial + 2 * camera["p2"] * a * b + camera["p1"] * (r2 + 2 * b * b)
        return camera["fl_x"] * x + camera["cx"], camera["fl_y"] * y + camera["cy"]

    def fisheye(self, camera, d):
        across = np.hypot(d[:, 0], d[:, 1])
        angle = np.arctan2(across, d[:, 2])
        bent = angle * (1 + sum(camera[f"k{i}"] * angle**(2 * i) for i in (1, 2, 3, 4)))
        return (camera["fl_x"] * bent * d[:, 0] / across + camera["cx"],
                camera["fl_y"] * bent * d[:, 1] / across + camera["cy"])

    def test_nerfstudio(self):
        cameras = ["pin", "webcam", "fish", "aside"]
        folder = self.make("nerfstudio", *cameras)
        sides = set()
        for name in cameras:
            transforms = json.loads((folder / f"transforms-{name}.json").read_text())
            model = self.fisheye if name == "fish" else self.opencv
            self.assertEqual(transforms["camera_model"],
                             "OPENCV_FISHEYE" if name == "fish" else "OPENCV")
            self.assertEqual((transforms["w"], transforms["h"]), (64, 48))
            self.assertEqual(len(transforms["frames"]), 6)
            for frame in transforms["frames"]:
                # Camera to world: x to the right, y up, z to the back; z is up in the world.
                pose = np.array(frame["transform_matrix"])

                def project(places, pose=pose, transforms=transforms, model=model):
                    own = (cube.z_up(places) - pose[:3, 3]) @ pose[:3, :3]
                    return model(transforms, own * [1, -1, -1])

                stem = frame["file_path"].split("/")[1][:-4]
                self.check_hits(folder, stem, project)
                if name not in ("pin", "aside"):
                    continue
                x, y = pixels(48, 64)
                own = np.stack([(x - transforms["cx"]) / transforms["fl_x"],
                                -(y - transforms["cy"]) / transforms["fl_y"], -np.ones_like(x)],
                               axis=-1)
                directions = cube.y_up(own @ pose[:3, :3].T)
                sides |= self.check_sight(cube.y_up(pose[:3, 3]), directions,
                                          folder / frame["file_path"])
        self.assertEqual(sides, set(range(6)))

    # -------------------------------------------------------------------------------- COLMAP

    def test_colmap(self):
        folder = self.make("colmap", "pin", "webcam", "fish")
        cameras, images = {}, []
        for line in (folder / "sparse/0/cameras.txt").read_text().splitlines():
            if not line.startswith("#"):
                number, model, width, height, *parameters = line.split()
                cameras[number] = (model, int(width), int(height), [float(p) for p in parameters])
        lines = [line for line in (folder / "sparse/0/images.txt").read_text().splitlines()
                 if not line.startswith("#")]
        for line, points in zip(lines[::2], lines[1::2]):
            self.assertEqual(points, "")
            images.append(line.split())
        self.assertTrue((folder / "sparse/0/points3D.txt").exists())
        self.assertEqual([one[0] for one in cameras.values()],
                         ["PINHOLE", "FULL_OPENCV", "OPENCV_FISHEYE"])
        self.assertEqual(len(images), 18)
        sides = set()
        for _, *numbers, camera, name in images:
            w, x, y, z, *translation = (float(one) for one in numbers)
            # The rotation of a quaternion of Hamilton, from the world to the camera.
            rotation = np.array(
                [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                 [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                 [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
            model, width, height, p = cameras[camera]
            named = dict(zip(("fl_x", "fl_y", "cx", "cy"), p), **dict.fromkeys(
                ("k1", "k2", "k3", "k4", "p1", "p2"), 0))
            order = {"PINHOLE": (), "FULL_OPENCV": ("k1", "k2", "p1", "p2", "k3"),
                     "OPENCV_FISHEYE": ("k1", "k2", "k3", "k4")}[model]
            named.update(zip(order, p[4:]))
            if model == "FULL_OPENCV":
                self.assertEqual(p[9:], [0, 0, 0])
            project = self.fisheye if model == "OPENCV_FISHEYE" else self.opencv
            self.check_hits(folder, name[:-4], lambda places: project(
                named, places @ rotation.T + translation))
            if model == "PINHOLE":
                u, v = pixels(height, width)
                own = np.stack([(u - p[2]) / p[0], (v - p[3]) / p[1], np.ones_like(u)], axis=-1)
                sides |= self.check_sight(-rotation.T @ translation, own @ rotation,
                                          folder / "rgb" / name)
        self.assertEqual(sides, set(range(6)))

    # ----------------------------------------------------------------------------- KITTI-360

    def test_kitti360(self):
        folder = self.make("kitti360", "pin", "omni", "aside") / "kitti360"
        calibration = folder / "calibration"

        def lines_of(name):
            return {line.split(":")[0]: [float(x) for x in line.split()[1:]]
                    for line in (calibration / name).read_text().splitlines()}

        to_pose = {name: fourth_row(np.reshape(numbers, (3, 4)))
                   for name, numbers in lines_of("calib_cam_to_pose.txt").items()}
        self.assertEqual(sorted(to_pose), [f"image_0{i}" for i in range(4)])
        poses = np.loadtxt(folder / "data_poses/cube/poses.txt")
        np.testing.assert_array_equal(poses[:, 0], range(6))
        perspective = lines_of("perspective.txt")
        x, y = pixels(48, 64)
        sides = set()
        for row in poses:
            system = fourth_row(row[1:].reshape(3, 4))
            # The system that carries the cameras: x ahead, y to the right, z down. The path is
            # walked upright, so that "down" is downwards in a world with z up.
            if row[0] < 5:
                self.assertLess(system[2, 2], -0.5)
            for number, name in ((0, "pin"), (1, "aside")):
                k = np.reshape(perspective[f"P_rect_0{number}"], (3, 4))
                self.assertEqual(perspective[f"S_rect_0{number}"], [64, 48])
                pose = system @ to_pose[f"image_0{number}"]
                # The middle of the first pixel is (0, 0).
                own = np.stack([(x - 0.5 - k[0, 2]) / k[0, 0], (y - 0.5 - k[1, 2]) / k[1, 1],
                                np.ones_like(x)], axis=-1)
                file = folder / f"data_2d_raw/cube/image_0{number}/data_rect/{int(row[0]):010}.png"
                sides |= self.check_sight(cube.y_up(pose[:3, 3]),
                                          cube.y_up(own @ pose[:3, :3].T), file)
                self.check_hits(folder.parent, f"{name}-{int(row[0]):05}",
                                lambda places: self.rectified(k, (
                                    cube.z_up(places) - pose[:3, 3]) @ pose[:3, :3]))
                original = folder.parent / f"rgb/{name}-{int(row[0]):05}.png"
                self.assertEqual(file.read_bytes(), original.read_bytes())
            pose = system @ to_pose["image_02"]
            self.check_hits(folder.parent, f"omni-{int(row[0]):05}",
                            lambda places: self.omni(calibration / "image_02.yaml", (
                                cube.z_up(places) - pose[:3, 3]) @ pose[:3, :3]))
            self.assertTrue((folder / f"data_2d_raw/cube/image_02/data_rgb/{int(row[0]):010}.png")
                            .exists())
        self.assertEqual(sides, set(range(6)))

    def rectified(self, k, points):
        """cam2image of CameraPerspective, likewise."""
        u, v, w = k[:, :3] @ points.T
        return u / w + 0.5, v / w + 0.5

    def omni(self, file, points):
        """cam2image of CameraFisheye in kitti360scripts/helpers/project.py, but for the middle of
        pixels."""
        text = file.read_text()
        self.assertTrue(text.startswith("%YAML:1.0\n"))
        value = {name: float(number)
                 for name, number in re.findall(r"^ +(\w+): (\S+)$", text, re.MULTILINE)}
        unit = points / np.linalg.norm(points, axis=1)[:, None]
        a = unit[:, 0] / (unit[:, 2] + value["xi"])
        b = unit[:, 1] / (unit[:, 2] + value["xi"])
        r2 = a * a + b * b
        radial = 1 + value["k1"] * r2 + value["k2"] * r2 * r2
        return (value["gamma1"] * a * radial + value["u0"] + 0.5,
                value["gamma2"] * b * radial + value["v0"] + 0.5)

    # ------------------------------------------------------------------------------ with rays

    def test_gsplat(self):
        folder = self.make("gsplat", "fish", "omni", "slit")
        sides = set()
        for camera in ("fish", "omni", "slit"):
            for name in self.frames_of(camera):
                rays = np.load(folder / f"gsplat/{name}.npy")
                self.assertEqual((rays.shape, rays.dtype), ((1, 48, 64, 6), np.float32))
                origins, directions = np.split(rays[0].astype(float), 2, axis=-1)
                sides |= self.check_sight(origins, directions, folder / f"rgb/{name}.png")
                spread = np.linalg.norm(directions, axis=-1)
                unit = directions / spread[..., None]
                # The solid angle of a pixel, by its neighbours: central differences, whose error
                # is the third derivative over 6.
                by_x = (unit[1:-1, 2:] - unit[1:-1, :-2]) / 2
                by_y = (unit[2:, 1:-1] - unit[:-2, 1:-1]) / 2
                angle = np.sqrt(np.linalg.norm(np.cross(by_x, by_y), axis=-1))
                np.testing.assert_allclose(spread[1:-1, 1:-1], angle, rtol=0.01)
        self.assertEqual(sides, set(range(6)))

    def test_3dgrt(self):
        folder = self.make("3dgrt", "fish", "slit", "flat")
        sides = set()
        for camera in ("fish", "slit", "flat"):
            origins = np.load(folder / f"3dgrt/{camera}.rays_ori.npy").astype(float)
            directions = np.load(folder / f"3dgrt/{camera}.rays_dir.npy").astype(float)
            poses = np.load(folder / f"3dgrt/{camera}.T_to_world.npy")
            self.assertEqual((origins.shape, directions.shape, poses.shape),
                             ((1, 48, 64, 3), (1, 48, 64, 3), (6, 4, 4)))
            # Right, down, front: rays to the right in the picture go to the right.
            self.assertGreater((directions[0, 24, 63] + origins[0, 24, 63])[0], 0)
            self.assertGreater((directions[0, 47, 32] + origins[0, 47, 32])[1], 0)
            self.assertGreater(directions[0, 24, 32, 2], 0.9)
            for pose, name in zip(poses, self.frames_of(camera)):
                sides |= self.check_sight(moved(pose, origins[0]), directions[0] @ pose[:3, :3].T,
                                          folder / f"rgb/{name}.png")
        self.assertEqual(sides, set(range(6)))

    def test_mapanything(self):
        folder = self.make("mapanything", "fish", "aside")
        sides = set()
        for camera in ("fish", "aside"):
            directions = np.load(folder / f"mapanything/{camera}.ray_directions.npy").astype(float)
            poses = np.load(folder / f"mapanything/{camera}.camera_poses.npy")
            self.assertEqual((directions.shape, poses.shape), ((48, 64, 3), (6, 4, 4)))
            np.testing.assert_allclose(np.linalg.norm(directions, axis=-1), 1, atol=1e-6)
            for pose, name in zip(poses, self.frames_of(camera)):
                world = directions @ pose[:3, :3].T
                sides |= self.check_sight(pose[:3, 3], world, folder / f"rgb/{name}.png")
                depth_z = np.load(folder / f"mapanything/{name}.depth_z.npy").astype(float)
                faces, away = cube.seen(pose[:3, 3], world)
                certain = cube.inner(faces) & (faces != cube.NOTHING)
                np.testing.assert_allclose(depth_z[certain],
                                           (away * directions[..., 2])[certain], rtol=1e-5)
                self.assertTrue((depth_z[cube.inner(faces) & (faces == cube.NOTHING)] == 0).all())
        self.assertEqual(sides, set(range(6)))

    # -------------------------------------------------------------------------------- misfits

    def test_a_camera_that_a_layout_cannot_have_is_refused(self):
        for layout, camera, says in (
                ("colmap", "omni", "PINHOLE, FULL_OPENCV and OPENCV_FISHEYE"),
                ("nerfstudio", "slit", "pinholes and lenses of OpenCV's models"),
                ("kitti360", "fish", "the omnidirectional model of Mei"),
                ("gsplat", "flat", "whose rays spread"),
                ("mapanything", "slit", "whose rays start at one point")):
            with self.subTest(layout):
                with self.assertRaises(AssertionError):
                    self.make(layout, camera)
                err = self.refused("dataset", "cube.toml", "-o", "out", code=2, says=says,
                                   helps="can")
                self.assertIn("cube.toml:4:", err)
                self.assertIn("3dgrt", err)
                self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    support.main()
