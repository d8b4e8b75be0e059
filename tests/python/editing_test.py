# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Scenes that are changed, and scenes of arrays."""

import base64
import copy
import json
import threading
import unittest

import balcony
import numpy as np
from scene_files import ROOM, RoomTest

SIZE = (32, 24)
# A cube from -0.5 to 0.5 in each direction, its faces outwards.
CORNERS = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                  [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])
# At the back wall of the room, looking along -z, with x to the right and y up.
POSE = [[1, 0, 0, 0], [0, 1, 0, 1.25], [0, 0, 1, 1.9]]


def obj_of(name, corners, first):
    """The cube with these corners as a part of an OBJ file, whose first vertex has this number."""
    return (f"o {name}\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in corners)
            + "".join(f"f {a + first} {b + first} {c + first}\n" for a, b, c in FACES))


def shifted(x, y, z):
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def lift():
    """A glTF file with the cube, which rises by 2 in 4 seconds."""
    arrays = [(CORNERS.astype(np.float32), 5126, "VEC3"), (FACES.astype(np.uint16).ravel(), 5123, "SCALAR"),
              (np.array([0, 4], np.float32), 5126, "SCALAR"),
              (np.array([[0, 0, 0], [0, 2, 0]], np.float32), 5126, "VEC3")]
    views, accessors, data = [], [], b""
    for array, kind, shape in arrays:
        accessors.append({"bufferView": len(views), "componentType": kind, "count": len(array), "type": shape})
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": array.nbytes})
        data += array.tobytes()
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return json.dumps({
        "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"name": "lift", "mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                        "samplers": [{"input": 2, "output": 3}]}],
        "buffers": [{"uri": uri, "byteLength": len(data)}], "bufferViews": views, "accessors": accessors})


class Editing(RoomTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.cam = balcony.camera("pinhole", fov="90deg").placed(POSE, "opengl", world="y_up")

    def setUp(self):
        self.scene = self.loaded(ROOM + obj_of("cube", CORNERS, 9))

    def loaded(self, text):
        file = self.folder / "scene.obj"
        file.write_text(text)
        return balcony.load(file)

    def color(self, scene):
        return scene.render(self.cam, size=SIZE, samples=2)["color"]

    def assert_same(self, a, b):
        np.testing.assert_array_equal(self.color(a), self.color(b))

    def test_an_object_moves_as_in_another_file(self):
        before = self.color(self.scene)
        cube = self.scene["cube"]
        self.assertIs(cube.move(0.5, 1, -0.25), cube)
        moved = self.loaded(ROOM + obj_of("cube", CORNERS + [0.5, 1, -0.25], 9))
        self.assert_same(self.scene, moved)
        self.assertGreater(np.abs(self.color(self.scene) - before).max(), 0.1)
        np.testing.assert_array_equal(cube.matrix, shifted(0.5, 1, -0.25))
        np.testing.assert_array_equal(cube.bounds, [[0, 0.5, -0.75], [1, 1.5, 0.25]])
        cube.matrix = np.eye(4)
        np.testing.assert_array_equal(self.color(self.scene), before)

    def test_matrices_are_for_column_vectors(self):
        # From the axes of the cube, of which x goes up and y to the left.
        turn = np.array([[0, -2, 0, 0.5], [1, 0, 0, 1.5], [0, 0, 1, -1], [0, 0, 0, 1.0]])
        cube = self.scene.object("cube")
        cube.matrix = turn
        np.testing.assert_array_equal(cube.matrix, turn)
        np.testing.assert_array_equal(cube.bounds, [[-0.5, 1, -1.5], [1.5, 2, -0.5]])
        cube.transform(shifted(0, 0, -0.5))
        np.testing.assert_array_equal(cube.matrix, shifted(0, 0, -0.5) @ turn)
        corners = CORNERS @ cube.matrix[:3, :3].T + cube.matrix[:3, 3]
        self.assert_same(self.scene, self.loaded(ROOM + obj_of("cube", corners, 9)))

    def test_layers_follow_an_edit(self):
        self.scene["cube"].move(0, 1.25, 0)
        picture = self.scene.render(self.cam, size=SIZE, samples=1)
        middle = picture["position"][12, 16]
        np.testing.assert_allclose(middle[2], 0.5, atol=1e-6)
        rays = self.cam.rays(*SIZE, scene=self.scene)
        hits = rays.origins + picture["depth"][..., None] * rays.directions
        np.testing.assert_allclose(hits, picture["position"], atol=1e-5)
        self.assertEqual(picture.objects[int(picture["object"][12, 16]) - 1], "cube")

    def test_what_moves_keeps_moving(self):
        file = self.folder / "lift.gltf"
        file.write_text(lift())
        scene = balcony.load(file)
        picture = scene.render(size=SIZE, samples=1)
        still, seen = picture["position"], picture["object"] == 1
        scene["lift"].move(1, 0, 0)
        scene.time = 2
        np.testing.assert_array_equal(scene["lift"].matrix, shifted(1, 1, 0))
        # The default camera is placed by what the scene is now, as one that is loaded there is.
        moved = scene.render(size=SIZE, samples=1)
        np.testing.assert_array_equal(moved["object"] == 1, seen)
        np.testing.assert_allclose(moved["position"][seen] - [1, 1, 0], still[seen], atol=1e-5)
        scene["lift"].matrix = np.eye(4)
        scene.time = 3
        np.testing.assert_array_equal(scene["lift"].matrix, np.eye(4))
        np.testing.assert_array_equal(scene.render(size=SIZE, samples=1)["position"], still)

    def test_a_removed_object_is_gone(self):
        cube = self.scene["cube"]
        cube.remove()
        self.assertEqual(self.scene.objects, ["floor", "ceiling", "walls"])
        self.assert_same(self.scene, self.loaded(ROOM))
        for use in (lambda: cube.matrix, lambda: cube.move(1, 0, 0), lambda: self.scene["cube"]):
            with self.assertRaisesRegex(balcony.InputError, "has no object 'cube'"):
                use()

    def test_a_mesh_of_arrays_is_that_of_a_file(self):
        scene = self.loaded(ROOM)
        # Every other row of larger arrays, in other types.
        corners = np.repeat(CORNERS.astype(np.float32), 2, axis=0)[::2]
        cube = scene.add_mesh("cube", corners, np.asfortranarray(FACES.astype(np.uint8)))
        self.assertEqual((cube.name, scene.objects[-1]), ("cube", "cube"))
        # The material of a file without any is grey and matt, too.
        self.assert_same(scene, self.scene)
        placed = self.loaded(ROOM)
        placed.add_mesh("cube", CORNERS.tolist(), FACES.tolist(), matrix=shifted(0, 1, 0),
                        material=0)
        self.assert_same(placed, self.loaded(ROOM + obj_of("cube", CORNERS + [0, 1, 0], 9)))

    def test_colours_and_normals_are_by_vertex(self):
        self.scene["cube"].remove()
        near = shifted(0, 1.25, 0)
        red = np.tile([1.0, 0, 0], (8, 1))
        self.scene.add_mesh("cube", CORNERS, FACES, normals=np.tile([0, 1.0, 0], (8, 1)), colors=red,
                            uv=np.zeros((8, 2)), material={"base_color": (0.5, 0.5, 1)}, matrix=near)
        picture = self.scene.render(self.cam, size=SIZE, samples=1)
        np.testing.assert_allclose(picture["albedo"][12, 16], [0.5, 0, 0], atol=1e-6)
        # The normal is seen from above, but bent to be seen from the camera.
        self.assertGreater(picture["normal"][12, 16][1], 0.9)

    def test_wrong_arrays_say_what_is_wrong(self):
        add = self.scene.add_mesh
        nan = CORNERS.copy()
        nan[3, 1] = np.nan
        wrong = [
            (ValueError, r"'positions' has the shape \(8, 2\)", (CORNERS[:, :2], FACES)),
            (TypeError, "'positions' has the type", (CORNERS.astype(complex), FACES)),
            (TypeError, "'positions' is no array of real numbers", ([[0, 0, 0], [1]], FACES)),
            (TypeError, "'triangles' has the type float64, but whole", (CORNERS, FACES.astype(float))),
            (ValueError, r"'triangles' has the shape \(12, 2\)", (CORNERS, FACES[:, :2])),
            (balcony.InputError, "row 3 of the positions is not finite", (nan, FACES)),
            (balcony.InputError, "row 0 of the triangles .* numbered from 0", (CORNERS, FACES - 1)),
            (balcony.InputError, "row 1 of the triangles", (CORNERS[:4], FACES[[1, 2]])),
            (balcony.InputError, "row 0 of the triangles",
             (CORNERS, np.full((1, 3), 2**64 - 1, dtype=np.uint64))),
            (balcony.InputError, "has no triangles", (CORNERS, np.zeros((0, 3), int))),
            (balcony.InputError, "3 rows of the normals", (CORNERS, FACES, CORNERS[:3])),
            (ValueError, r"'colors' has the shape .* \(n, 3\) or \(n, 4\)",
             (CORNERS, FACES, None, None, CORNERS[:, :2])),
            (balcony.InputError, "row 0 of the colours is not from 0 to 1",
             (CORNERS, FACES, None, None, CORNERS)),
        ]
        materials = self.scene.materials
        for kind, message, arrays in wrong:
            with self.assertRaisesRegex(kind, message):
                add("other", *arrays, material={})
        with self.assertRaisesRegex(balcony.InputError, "has no material 'wod'"):
            add("other", CORNERS, FACES, material="wod")
        with self.assertRaisesRegex(balcony.InputError, "object 'cube' is in the scene already"):
            add("cube", CORNERS, FACES, material=0)
        with self.assertRaises(TypeError):
            add("other", CORNERS, FACES, material=1.5)
        self.assertEqual(self.scene.objects, ["floor", "ceiling", "walls", "cube"])
        self.assertEqual(self.scene.materials, materials)

    def test_wrong_places_say_what_is_wrong(self):
        cube = self.scene["cube"]
        for kind, message, matrix in [
                (ValueError, "no matrix of 4 x 4", np.eye(4)[:3]),
                (ValueError, "has the shape", np.eye(3)),
                (balcony.InputError, "not finite", np.eye(4) * np.nan),
                (balcony.InputError, "singular", np.diag([1, 0, 1, 1])),
                (balcony.InputError, "not affine", np.diag([1, 1, 1, 2]))]:
            with self.assertRaisesRegex(kind, message):
                cube.matrix = matrix
        with self.assertRaisesRegex(balcony.InputError, "further than"):
            cube.move(1e13, 0, 0)
        np.testing.assert_array_equal(cube.matrix, np.eye(4))
        with self.assertRaisesRegex(AttributeError, "cannot be set"):
            cube.matrx = np.eye(4)
        for name in ("cub", 9, -1, 1.5):
            with self.assertRaises((balcony.InputError, TypeError)):
                self.scene[name]
        with self.assertRaises(TypeError):
            list(self.scene)

    def test_properties_of_materials_are_attributes(self):
        scene = balcony.Scene()
        scene.add_mesh("cube", CORNERS, FACES, material={"roughness": 0.25, "base_color": 0.5})
        self.assertEqual(scene.materials, ["cube"])
        cube = scene.material("cube")
        self.assertEqual((cube.roughness, cube.base_color, cube.unlit), (0.25, (0.5, 0.5, 0.5), False))
        before = self.color(scene)
        cube.emission = np.array([4, 0, 0])
        cube.unlit = True
        self.assertIs(cube.set(metallic=np.float32(1), alpha=0.5), cube)
        self.assertEqual((cube.emission, cube.metallic, cube.unlit), ((4, 0, 0), 1, True))
        self.assertTrue(all(one.meaning for one in cube.properties.values()))
        self.assertIn("roughness", dir(cube))
        self.assertEqual(cube.properties["ior"][1:], (1.5, (1, 1e4)))
        self.assertFalse(np.array_equal(self.color(scene), before))
        with self.assertRaisesRegex(AttributeError, "did you mean 'roughness'"):
            cube.rougness
        for wrong in ({"rougness": 1}, {"roughness": 2}, {"roughness": float("nan")},
                      {"base_color": (1, 2)}, {"roughness": (1, 1, 1)}):
            with self.assertRaises(balcony.InputError):
                cube.set(**wrong)
        for wrong in ("matt", None, [], [[1]]):
            with self.assertRaises(TypeError):
                cube.roughness = wrong
        with self.assertRaisesRegex(AttributeError, "cannot be set"):
            cube.properties = {}
        self.assertEqual(scene.add_material("gold", metallic=1).metallic, 1)
        with self.assertRaisesRegex(balcony.InputError, "has no material 'glod'.*\n.*'gold'"):
            scene.material("glod")

    def test_emission_lights_the_room(self):
        dark = self.loaded(ROOM)
        dark.add_mesh("lamp", CORNERS / 4, FACES, material={"emission": 20}, matrix=shifted(0, 2, 0))
        lit = dark.render(self.cam, size=SIZE, samples=8)["color"]
        dark.material("lamp").emission = 10
        half = dark.render(self.cam, size=SIZE, samples=8)["color"]
        np.testing.assert_allclose(half[..., :3], lit[..., :3] / 2, rtol=1e-5)
        dark["lamp"].remove()
        self.assert_same(dark, self.loaded(ROOM))

    def test_lights_are_added_changed_and_removed(self):
        wanted = balcony.load(self.room, lamp=["point 30 at 0,2,1"])
        scene = balcony.load(self.room)
        lamp = scene.add_light("lamp", position=(0, 2, 1), intensity=30)
        self.assertEqual((lamp.kind, scene.lights), ("point", ["lamp"]))
        self.assert_same(scene, wanted)
        lamp.set(position=(1, 2, 0), intensity=(30, 20, 10))
        self.assertEqual(lamp.position, (1, 2, 0))
        self.assert_same(scene, balcony.load(self.room, lamp=["point 30,20,10 at 1,2,0"]))
        spot = scene.add_light("spot", "spot", position=(0, 2, 0), direction=(0, -3, 0), outer_cone=0.5)
        self.assertEqual((spot.kind, spot.direction), ("spot", (0, -1, 0)))
        for light in ("lamp", "spot"):
            scene.light(light).remove()
        self.assert_same(scene, balcony.load(self.room))
        with self.assertRaisesRegex(ValueError, "'point', 'spot' or 'sun'"):
            scene.add_light("x", "bulb")
        with self.assertRaisesRegex(balcony.InputError, "has no light 'spot'"):
            spot.position = (0, 0, 0)

    def test_copies_do_not_see_edits(self):
        before = self.color(self.scene)
        made = [self.scene.copy(), copy.copy(self.scene), copy.deepcopy(self.scene)]
        self.scene["cube"].move(0, 1, 0)
        made[1]["cube"].remove()
        np.testing.assert_array_equal(self.color(made[0]), before)
        np.testing.assert_array_equal(self.color(made[2]), before)
        self.assertEqual(made[1].objects, ["floor", "ceiling", "walls"])
        self.assertEqual(self.scene.objects[-1], "cube")
        # A copy has the options of its scene.
        bright = balcony.load(self.room, environment=8, samples=4, size=SIZE)
        np.testing.assert_array_equal(bright.copy().render(self.cam)["color"],
                                      bright.render(self.cam)["color"])

    def test_a_scene_without_a_file(self):
        scene = balcony.Scene(axes="z_up", lamp=["point 10 at 0,0,3"])
        self.assertEqual((scene.axes, scene.objects, scene.lights), ("z_up", [], ["lamp"]))
        self.assertIn("without a file", repr(scene))
        with self.assertWarnsRegex(balcony.BalconyWarning, "the scene has no surface"):
            self.assertEqual(scene.render(self.cam, size=SIZE, samples=1)["object"].max(), 0)
        with self.assertRaisesRegex(balcony.InputError, "has no finite size, so no camera"):
            scene.render(size=SIZE, samples=1)
        for i in range(3):
            scene.add_mesh("cube", CORNERS, FACES, material={"roughness": 0.5})
            scene["cube"].move(0, i, 0)
            if i < 2:
                scene["cube"].remove()
        self.assertEqual((scene.objects, scene.materials), (["cube"], ["cube"]))
        # A camera that the scene places follows what was added.
        picture = scene.render(size=SIZE, samples=1)
        self.assertGreater((picture["object"] == 1).mean(), 0.05)
        with self.assertRaisesRegex(TypeError, "its own axes"):
            balcony.Scene(self.room, axes="z_up")
        with self.assertRaisesRegex(ValueError, "no axes 'up'"):
            balcony.Scene(axes="up")

    def test_threads_share_a_scene(self):
        scenes = [self.scene, self.scene, self.scene.copy()]

        def work(scene):
            for i in range(5):
                scene["cube"].move(0, 0.125, 0)
                self.color(scene)

        threads = [threading.Thread(target=work, args=[scene]) for scene in scenes]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        np.testing.assert_array_equal(self.scene["cube"].matrix, shifted(0, 1.25, 0))
        np.testing.assert_array_equal(scenes[2]["cube"].matrix, shifted(0, 0.625, 0))


if __name__ == "__main__":
    unittest.main()
