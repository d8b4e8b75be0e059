# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The light that render adds to a scene: environments, skies, and what it chooses by itself."""

import base64
import json
import struct

import elsewhere
import support


def hdr(width, height, rgbe):
    """A Radiance picture of one colour, without compression."""
    header = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n"
    return header.encode() + bytes(rgbe) * (width * height)


def sunny_scene():
    """A triangle in glTF under a sun that shines straight down."""
    corners = struct.pack("<9f", 0, 0, 0, 0, 0, 1, 1, 0, 0)
    data = "data:application/octet-stream;base64," + base64.b64encode(corners).decode()
    lamps = {"lights": [{"type": "directional", "intensity": 5}]}
    sun = {"extensions": {"KHR_lights_punctual": {"light": 0}}, "rotation": [-0.5**0.5, 0, 0, 0.5**0.5]}
    return {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": lamps},
        "buffers": [{"uri": data, "byteLength": len(corners)}],
        "bufferViews": [{"buffer": 0, "byteLength": len(corners)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 0, 1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": [{"mesh": 0}, sun],
        "scenes": [{"nodes": [0, 1]}],
    }


def write_furnace(folder, albedo):
    """A closed room whose walls all emit 1 and reflect the albedo: n bounces leave out
    albedo^(n + 2) of its light."""
    (folder / "furnace.mtl").write_text(
        f"newmtl wall\nillum 0\nKd {albedo} {albedo} {albedo}\nKe 1 1 1\n")
    corners = "".join(f"v {x} {y} {z}\n" for x in (-1, 1) for y in (-1, 1) for z in (-1, 1))
    (folder / "furnace.obj").write_text(
        "mtllib furnace.mtl\n" + corners + "usemtl wall\nf 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\n"
        "f 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n")


class Light(support.CommandTest):
    def facts(self, *words, scene="scene.obj", output="p.exr"):
        out, _ = self.run_command("render", scene, "--size", "16x16", "--samples", "1",
                                  "--integrator", "path", "-o", output, "--json", *words)
        return json.loads(out)

    def refuses(self, option, *values):
        for value in values:
            with self.subTest(option=option, value=value):
                self.refused("render", "scene.obj", f"{option}={value}", "-o", "p.exr", code=2,
                             says=option)

    def test_light_beyond_limits_of_bounces(self):
        words = ("render", "furnace.obj", "-c", "panorama", "--size", "32x16", "--samples", "64",
                 "-o", "p.exr")
        for albedo, bounces, says in ((0.75, 3, "; --bounces 128 keeps more"),
                                      (0.75, 20, None),
                                      (0.99, 128, "; they are the highest")):
            with self.subTest(albedo=albedo, bounces=bounces):
                write_furnace(self.folder, albedo)
                lost = albedo ** (bounces + 2)
                limit = ("--bounces", str(bounces))
                layer = self.json_of(*words, *limit)["layers"][0]
                # One in eight of the paths that reach a limit tells.
                self.assertAlmostEqual(layer["cut_off"], lost, delta=0.1 * lost + 0.002)
                text, _ = self.run_command(*words, *limit)
                if says is None:
                    self.assertNotIn("cut off", text)
                else:
                    self.assertRegex(text, r"about \d+\.\d % of the light is cut off by limits of "
                                     "bounces" + says)

    def test_numbers_out_of_range(self):
        self.refuses("--environment-rotation", "nan", "inf", "left", "1e9")
        self.refuses("--environment-strength", "-1", "nan", "1e39", "bright")
        self.refuses("--emission-scale", "-1", "nan", "1e39", "bright")
        self.refuses("--sun-angle", "-1", "181", "nan", "wide")
        self.refuses("--environment", "sky:elevation", "sky:elevation=high", "sky:height=3",
                     "sky:elevation=91", "sky:turbidity=0", "sky:turbidity=11", "sky:azimuth=nan")

    def test_lamps(self):
        for lamp in ("point 100 at 1,2,3", "spot 5,4,3 at 0,0,5 to 0,0,0 cone 30",
                     "sun 3 at 1,1,1 to 0,0,0"):
            self.assertIn("1 ", self.facts("--lamp", lamp)["light"])
        lit = self.facts("--lamp", "point 100 at 1,2,3", "--lamp", "point 1 at 0,0,5")["light"]
        self.assertEqual(lit, "2 lamps")
        for wrong in ("point", "point 100", "lamp 3 at 1,2,3", "point 3 at 1,2", "point -1 at 1,2,3",
                      "spot 3 at 1,2,3", "point 3 at 1,2,3 to 0,0,0", "sun 3 at 1,1,1 to 1,1,1"):
            self.refuses("--lamp", wrong)

    def test_a_lamp_at_the_eye(self):
        (self.folder / "sunny.gltf").write_text(json.dumps(sunny_scene()))
        self.assertEqual(self.facts("--lamp-at-eye")["light"],
                         "a light at the eye, as the scene has none")
        self.assertEqual(self.facts("--lamp-at-eye", scene="sunny.gltf")["light"],
                         "a light at the eye alone")
        self.refused("render", "scene.obj", "--lamp-at-eye", "--environment", "sky", code=2,
                     says="--lamp-at-eye excludes")

    def test_a_file_of_lamps_joins_a_scene(self):
        lamp = {"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"],
                "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point",
                                                                   "intensity": 50}]}},
                "scenes": [{"nodes": [0]}],
                "nodes": [{"translation": [0, 0, 5],
                           "extensions": {"KHR_lights_punctual": {"light": 0}}}]}
        (self.folder / "lamp.gltf").write_text(json.dumps(lamp))
        self.assertEqual(self.facts("--add", "lamp.gltf")["light"], "1 lamp")
        self.refused("render", "lamp.gltf", code=1, says="it has no triangles")

    def test_skies_and_colours(self):
        self.assertIn("elevation of 12", self.facts("--environment", "sky:elevation=12deg")["light"])
        self.assertIn("sun", self.facts("--environment", "sky")["light"])
        self.assertIn("constant", self.facts("--environment", "0.5")["light"])
        self.assertIn("constant", self.facts("--environment", "0.5,0.6,1")["light"])
        self.assertIn("constant", self.facts("--ambient", "0.5")["light"])

    def test_a_scene_without_light_has_a_sky(self):
        self.assertIn("sky without sun", self.facts()["light"])
        info = self.run_command("info", "scene.obj")[0]
        self.assertIn("sky without sun", info)
        out, _ = self.run_command("render", "scene.obj", "--size", "8x8", "--integrator", "path",
                                  "-o", "p.exr")
        self.assertIn("lit by a sky without sun", out)

    def test_a_scene_with_a_sun_has_a_sky_as_well(self):
        (self.folder / "sunny.gltf").write_text(json.dumps(sunny_scene()))
        facts = self.facts(scene="sunny.gltf")
        self.assertEqual("1 lamp and a soft sky, as the scene has a sun and no sky", facts["light"])
        self.assertIn("soft sky", self.run_command("info", "sunny.gltf")[0])
        elsewhere.write(self.folder)
        self.assertIn("a soft sky", self.facts("--camera", "panorama", scene="attic.glb")["light"])
        facts = self.facts("--ambient", "0", scene="sunny.gltf")
        self.assertIn("1 lamp, a constant environment", facts["light"])

    def test_emission_of_blender_is_in_the_units_of_its_lamps(self):
        scene = sunny_scene()
        scene["asset"]["generator"] = "Khronos glTF Blender I/O v3.4.50"
        scene["materials"] = [{"emissiveFactor": [1, 1, 1]}]
        scene["meshes"][0]["primitives"][0]["material"] = 0
        (self.folder / "sunny.gltf").write_text(json.dumps(scene))
        words = ("render", "sunny.gltf", "--size", "8x8", "--samples", "1", "-o", "p.exr")
        said = "emission x 683, to the units of Blender's lamps"
        self.assertIn(said, self.run_command(*words)[0])
        self.assertIn(said, self.run_command("info", "sunny.gltf")[0])
        self.assertNotIn(said, self.run_command(*words, "--emission-scale", "683")[0])
        self.assertEqual(self.facts(scene="sunny.gltf")["emission_scale"], 683)
        self.assertEqual(self.facts("--emission-scale", "1", scene="sunny.gltf")["emission_scale"], 1)

    def test_the_environment_is_the_background_unless_it_is_hidden(self):
        for words, share in (((), 1.0), (("--background", "auto"), 1.0)):
            self.facts(*words, output="p.png")
            self.assertEqual(share, support.opaque_share(self.folder / "p.png"))
        self.facts("--background", "transparent", "--environment", "sky", output="p.png")
        self.assertLess(support.opaque_share(self.folder / "p.png"), 1.0)

    def test_files(self):
        (self.folder / "meadow.hdr").write_bytes(hdr(4, 2, (128, 128, 128, 129)))
        facts = self.facts("--environment", "meadow.hdr", "--environment-rotation", "90deg",
                           "--environment-strength", "2")
        self.assertIn("meadow.hdr", facts["light"])
        self.assertEqual([], facts["diagnostics"])
        self.refused("render", "scene.obj", "--environment", "nowhere.hdr", "-o", "q.exr", code=1,
                     says="nowhere.hdr")
        (self.folder / "text.png").write_bytes(b"no picture")
        self.refused("render", "scene.obj", "--environment", "text.png", "-o", "q.exr", code=1,
                     says="text.png")
        (self.folder / "black.hdr").write_bytes(hdr(4, 2, (0, 0, 0, 0)))
        facts = self.facts("--environment", "black.hdr")
        self.assertIn("black", facts["diagnostics"][0]["message"])
        self.assertNotIn("q.exr", self.files())


if __name__ == "__main__":
    support.main()
