# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Cameras that the scene places: built-in ones, and others with --fit or --fit-to."""

import base64
import json
import math
import struct

import support

CAMERA = """// Looks down, and shows the whole scene.
camera plan(width = 1, px = 0, py = 0) {
    fit    width = 2*scene_radius, (px, py) = (scene_center[0], scene_center[1])
    aspect 1
    map    u = -width/2 .. width/2, v = square
    eye    surface(u, v) = [px + u, py + v, 100]
    look   along(-z)
}

// Cannot be fitted.
camera fixed {
    map  u = -1 .. 1, v = square
    eye  surface(u, v) = [u, v, 100]
    look along(-z)
}
"""

# With y up, the plan of this scene is from -2 to 2 and from -1 to 0 (x and -z).
SCENE = """o slab
v -2 0 0
v -1 0 0
v -1 0 1
v -2 0 1
f 1 4 3 2
o tile
v 1 0.1 0
v 2 0.1 0
v 2 0.1 1
v 1 0.1 1
f 5 8 7 6
"""


class Fit(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "plan.cam").write_text(CAMERA)
        (self.folder / "tiles.obj").write_text(SCENE)

    def fitted(self, *words):
        out, _ = self.run_command("render", "tiles.obj", "--camera", "plan.cam:plan", "--size", "16",
                                  "-s", "1", "-o", "out.exr", *words)
        lines = [line for line in out.splitlines() if line.startswith("  fitted: ")]
        return dict(word.split("=") for word in lines[0].split()[1:]) if lines else {}

    def test_the_whole_scene(self):
        self.assertEqual(self.fitted(), {})
        self.assertEqual(self.fitted("--fit"), {"width": "4.123", "px": "0", "py": "-0.5"})

    def test_built_in_cameras_are_placed_unless_they_are_not_to_be(self):
        def hits(*words):
            facts = self.json_of("render", "tiles.obj", "--camera", "panorama", "--size", "32",
                                 "-s", "1", "-o", "out.exr", *words)
            return facts["layers"][0]["hits"], {one["name"]: one["value"] for one in facts["fitted"]}

        placed, where = hits()
        self.assertGreater(placed, 0)
        self.assertEqual(set(where), {"px", "py", "pz"})
        self.assertGreater(where["pz"], 0)
        self.assertEqual(hits("--fit"), (placed, where))
        self.assertEqual(hits("--no-fit")[1], {})
        self.assertEqual(hits("--set", "pz=7")[1], {**where, "pz": 7})
        # A file of that name is one's own.
        (self.folder / "panorama").write_text(CAMERA)
        self.assertEqual(hits()[1], {})

    def test_check_and_locate_place_what_render_places(self):
        def located(*words):
            facts = self.json_of("locate", "panorama", "--scene", "tiles.obj", "--axes", "z_up",
                                 "--point", "10,0,0", "--size", "3600", *words)
            return facts["points"][0]["sightings"][0]["y"]

        # Level with the eye, or at its feet.
        self.assertGreater(located(), located("--no-fit") + 0.01)
        self.assertAlmostEqual(located("--no-fit"), 900, places=6)

        def never_seen(*words):
            facts = self.json_of("check", "--scene", "tiles.obj", "--size", "16", *words)
            return facts["files"][0]["reports"][0]["in_scene"]["never_seen"]

        own = ("plan.cam:plan", "--set", "px=90")
        self.assertEqual(never_seen(*own), ["slab", "tile"])
        self.assertEqual(never_seen("plan.cam:plan", "--fit"), [])
        self.assertEqual(never_seen("plan.cam:plan", "--fit-to", "tile"), ["slab"])
        self.assertEqual(never_seen("plan.cam:plan", "--fit", "--set", "px=90"), ["slab", "tile"])

    def test_an_object(self):
        self.assertEqual(self.fitted("--fit-to", "tile"),
                         {"width": "1.414", "px": "1.5", "py": "-0.5"})

    def test_set_has_the_last_word(self):
        hits = {}
        for words in ((), ("--fit",), ("--fit", "--set", "width=100")):
            facts = self.json_of("render", "tiles.obj", "--camera", "plan.cam:plan", "--size", "64",
                                 "-s", "1", "-o", "out.exr", *words)
            hits[words] = facts["layers"][0]["hits"]
        self.assertGreater(hits[("--fit",)], 64 * 64 * 0.1)
        self.assertLess(hits[("--fit", "--set", "width=100")], 64 * 64 * 0.01)

    def located(self, camera, point):
        words = [f"{name}={value}" for name, value in camera.items()]
        sets = [word for one in words for word in ("--set", one)]
        out, _ = self.run_command("locate", "pinhole", *sets, "--size", "32x32", "--axes", "y_up",
                                  "--point", point, "--json")
        return json.loads(out)["points"][0]["sightings"]

    def placed(self, *words):
        out, _ = self.run_command("render", "tiles.obj", "--camera", "pinhole", "--size", "16",
                                  "-s", "1", "-o", "out.exr", *words)
        line = next(line for line in out.splitlines() if line.startswith("  fitted: "))
        return dict(word.split("=") for word in line.split()[1:])

    def test_a_camera_that_stands_looks_at_the_object(self):
        for option in ("--fit-to", "--look-at"):
            placed = self.placed(option, "tile")
            (seen,) = self.located(placed, "1.5,0.1,0.5")
            self.assertAlmostEqual(seen["x"], 16, delta=0.1)
            self.assertAlmostEqual(seen["y"], 16, delta=0.1)
            self.assertGreater(seen["distance"], 1)

    def test_the_place_can_be_given(self):
        placed = self.placed("--look-at", "tile", "--from", "-3,1,4")
        self.assertEqual((placed["px"], placed["py"], placed["pz"]), ("-3", "-4", "1"))
        (seen,) = self.located(placed, "1.5,0.1,0.5")
        self.assertAlmostEqual(seen["x"], 16, delta=0.1)
        self.assertAlmostEqual(seen["y"], 16, delta=0.1)
        self.refused("render", "tiles.obj", "-c", "pinhole", "--from", "1,2", code=2,
                     says="--from cannot be '1,2'", helps="scene:NAME")
        self.refused("render", "tiles.obj", "-c", "pinhole", "--from", "scene:Front", code=1,
                     says="has no cameras")
        self.refused("render", "tiles.obj", "--from", "1,2,3", code=2, says="--from needs a camera")

    def test_a_place_that_decides_nothing_is_answered(self):
        for camera, unused in (("superelliptic", True), ("orthographic", True),
                               ("panorama", False), ("cave", False), ("walkthrough", False)):
            _, err = self.run_command("render", "tiles.obj", "-c", camera, "--from", "0,1.5,0",
                                      "--size", "16x8", "-s", "1", "-o", "out.exr")
            self.assertEqual("--from has no effect" in err, unused, f"{camera}: {err}")

    def test_a_camera_of_the_scene_gives_its_place_and_its_look(self):
        # Rolled by 20 degrees, off level and off the axes.
        turn = [0.2, 0.3, 0.1]
        turn.append(math.sqrt(1 - sum(part * part for part in turn)))
        corners = struct.pack("<9f", -1, 0, 0, 1, 0, 0, 0, 1, 0)
        data = "data:application/octet-stream;base64," + base64.b64encode(corners).decode()
        (self.folder / "seen.gltf").write_text(json.dumps({
            "asset": {"version": "2.0"},
            "buffers": [{"uri": data, "byteLength": len(corners)}],
            "bufferViews": [{"buffer": 0, "byteLength": len(corners)}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                           "min": [-1, 0, 0], "max": [1, 1, 0]}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "cameras": [{"type": "perspective", "name": "Front",
                         "perspective": {"yfov": math.radians(60), "aspectRatio": 1, "znear": 0.1}}],
            "nodes": [{"mesh": 0}, {"camera": 0, "name": "Front", "translation": [0.5, 1, 4],
                                    "rotation": turn}],
            "scenes": [{"nodes": [0, 1]}]}))
        own = ("render", "seen.gltf", "--size", "32x32", "-s", "1", "--integrator", "preview",
               "--exposure", "0", "--no-dither")
        self.run_command(*own, "--camera", "scene:Front", "-o", "a.png")
        self.run_command(*own, "--camera", "pinhole", "--from", "scene:Front", "--set", "fov=60deg",
                         "-o", "b.png")
        one, other = ([pixel for row in support.png_pixels(self.folder / name)[2] for pixel in row]
                      for name in ("a.png", "b.png"))
        different = sum(a != b for a, b in zip(one, other))
        self.assertLess(different, 0.02 * len(one))
        self.assertGreater(len(set(one)), 1)

    def test_mistakes(self):
        render = ("render", "tiles.obj", "-o", "out.exr", "--camera")
        self.refused(*render, "plan.cam:fixed", "--fit", code=1, says="no fit statement",
                     helps="fit (px, py, pz) = scene_inside")
        self.refused(*render, "plan.cam:plan", "--fit-to", "tyle", code=1,
                     says="no object 'tyle'", helps="did you mean 'tile'?")
        self.refused("render", "tiles.obj", "-o", "out.exr", "--fit", code=2,
                     says="--fit needs a camera", helps="--camera")
        self.refused(*render, "scene:", "--fit", code=2, says="--fit needs a camera",
                     helps="--camera")
        self.refused(*render, "plan.cam:plan", "--no-fit", "--fit-to", "tile", code=2,
                     says="--no-fit contradicts --fit-to", helps="leave out one")
        for command in (("check", "panorama"), ("locate", "panorama", "--point", "1,2,3")):
            self.refused(*command, "--fit", code=2, says="there is none", helps="--scene")
        # Before the scene is read.
        self.refused("render", "nowhere.obj", "--camera", "panorama", "--set", "nix=1", code=1,
                     says="'nix'")


# A closed box that faces outwards, around the origin, and a triangle outside.
BOX = """o box
v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
o sail
v 3 0 0
v 4 0 0
v 3 2 0
f 9 10 11
"""


class RaysThatStartInside(support.CommandTest):
    WARNING = "rays of camera 'rows' start in closed objects"

    def told(self, camera, scene=BOX, *words, output="out.exr"):
        (self.folder / "box.obj").write_text(scene)
        (self.folder / "rows.cam").write_text("camera rows {\n    map u = -4 .. 4, v = square\n"
                                              f"    eye {camera}\n    look along(x)\n}}\n")
        return self.run_command("render", "box.obj", "-c", "rows.cam", "--size", "64", "-s", "1",
                                "-o", output, *words)[1]

    def test_the_object_is_named_with_its_share(self):
        # The picture shows 8 by 4.5, the box is 2 by 2.
        said = self.told("surface(u, v) = [0, u, v]")
        self.assertIn(self.WARNING, said)
        self.assertIn("11.1 % in 'box'", said)
        self.assertIn("--set", said)

    def test_rays_that_start_in_the_open_are_fine(self):
        self.assertNotIn(self.WARNING, self.told("surface(u, v) = [-5, u, v]"))

    def test_a_room_is_no_trap(self):
        alone = self.told("surface(u, v) = [0, u/9, v/9]")
        self.assertIn("100 % in 'box'", alone)
        self.assertIn("pass through them: 100 % in 'box'",
                      self.told("surface(u, v) = [0, u/9, v/9]", BOX, "--inside", "pass"))
        furnished = BOX.replace("v 3 0 0", "v 0.5 0 -0.9").replace("v 4 0 0", "v 0.5 0.5 -0.9")
        furnished = furnished.replace("v 3 2 0", "v 0.5 0 0.9")
        self.assertNotIn(self.WARNING, self.told("surface(u, v) = [0, u/9, v/9]", furnished))

    def test_they_may_pass(self):
        # Behind the box is a slanted wall, which is darker than its back.
        wall = BOX + "o wall\nv 5 -9 -9\nv 5 -9 9\nv 23 9 9\nv 23 9 -9\nf -4 -3 -2 -1\n"
        for integrator in ("preview", "direct", "path"):
            words = ("--exposure", "0", "--no-dither", "--integrator", integrator, "--ambient", "1")
            pictures = []
            for x, *rule in ((1.5,), (0,), (0, "--inside", "pass")):
                said = self.told(f"surface(u, v) = [{x}, u, v]", wall, *words, *rule,
                                 output="out.png")
                pictures.append(support.png_pixels(self.folder / "out.png"))
            self.assertIn("pass through them: 11.1 % in 'box'", said)
            self.assertTrue(pictures[0] != pictures[1], integrator)
            if integrator != "path":  # Whose light the box takes part in.
                self.assertTrue(pictures[0] == pictures[2], integrator)


def box(name, low, high, turned=False):
    """A closed box in OBJ; turned inside out, it is a room."""
    corners = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    faces = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
    text = f"o {name}\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in corners)
    for face in faces:
        text += "f " + " ".join(str(i - 9) for i in (face[::-1] if turned else face)) + "\n"
    return text


class FitInTheOpen(support.CommandTest):
    def test_the_eye_object_becomes_smaller(self):
        # The fitted one would reach 2.52 from the middle, and the cupboard begins at 1.6.
        room = box("room", (-3, 0, -3), (3, 3, 3), turned=True)
        for furniture, smallest, largest in (("", 2.5, 2.53),
                                             (box("cupboard", (-1, 0, -3), (1, 2, -1.6)), 1, 1.6)):
            (self.folder / "room.obj").write_text(room + furniture)
            facts = self.json_of("render", "room.obj", "-c", "superelliptic", "--size", "64", "-s", "1",
                                 "-o", "p.exr")
            fitted = {one["name"]: one["value"] for one in facts["fitted"]}
            self.assertGreater(fitted["b"], smallest)
            self.assertLess(fitted["b"], largest)
            self.assertNotIn("start in closed objects", json.dumps(facts["diagnostics"]))


if __name__ == "__main__":
    support.main()
