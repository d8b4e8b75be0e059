# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The commands that do not render."""

import json
import math
import re

import support


class List(support.CommandTest):
    def test_stages_of_one_kind(self):
        out, _ = self.run_command("list", "direction rules")
        self.assertTrue(out.startswith("direction rules\n  normal "), out)
        self.assertNotIn("sphere", out)
        for name in ("direction_rules", "direction rule"):
            self.assertEqual(self.run_command("list", name), (out, ""))

    def test_stages_and_one_stage(self):
        out, err = self.run_command("list")
        self.assertEqual(err, "")
        self.assertEqual(self.run_command("list", "stages")[0], out)
        self.assertIn("superellipse", out)
        out, _ = self.run_command("list", "zoom")
        self.assertIn("radius", out)
        out, _ = self.run_command("list", "blend")
        self.assertIn(": blend(first, second, weight(u, v) = [w], by)\n", out)
        out, _ = self.run_command("list", "sweep")
        self.assertIn(", scale(s) = [k], ", out)

    def test_cameras(self):
        out, _ = self.run_command("list", "cameras")
        self.assertRegex(out, r"\nperspective\n(  .+\n)*  pinhole +For ordinary pictures")
        out, _ = self.run_command("list", "pinhole")
        self.assertIn("pinhole(fov = 60deg", out)
        out, _ = self.run_command("list", "my.cam")
        self.assertIn("closeup()\n    Looks at the scene from nearby.", out)

    def test_mistakes(self):
        self.refused("list", "zom", code=2, says="'zom'", helps="did you mean 'zoom'?")
        self.refused("list", "panoramo", code=2, says="'panoramo'", helps="'panorama'")
        self.refused("list", "qwertyuiop", code=2, says="'qwertyuiop'", helps="cameras")
        self.refused("list", "none.cam", code=1, says="'none.cam'")

    def test_json(self):
        self.assertGreater(len(self.json_of("list")["stages"]), 20)
        self.assertEqual([row["name"] for row in self.json_of("list", "torus")["stages"]],
                         ["torus"])
        families = {row["name"]: row["family"] for row in self.json_of("list", "cameras")["cameras"]}
        self.assertEqual(families["pinhole"], "perspective")
        above = self.json_of("list", "my.cam")["cameras"][0]
        self.assertEqual(above["parameters"], [{"name": "size", "default": "3"}])
        fov = self.json_of("list", "pinhole")["cameras"][0]["parameters"][0]
        self.assertEqual(fov["limits"], "above 0 to 179deg")
        self.assertEqual(fov["minimum"], 0)
        self.assertAlmostEqual(fov["maximum"], math.radians(179))
        self.assertIn("fov = 60deg above 0 to 179deg, px = 0,",
                      self.run_command("list", "pinhole")[0])
        self.json_of("list", "zom", code=2)
        self.json_of("list", "none.cam", code=1)


class Check(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "bad.cam").write_text("camera a {\n    eye sphree(1)\n}\n")

    def test_good_and_bad_files(self):
        out, err = self.run_command("check", "my.cam")
        self.assertTrue(out.startswith("my.cam: 4 cameras, no errors\n"), out)
        self.assertEqual(err, "")
        out, err = self.run_command("check", "bad.cam", "my.cam", code=1)
        self.assertTrue(out.startswith("my.cam: 4 cameras, no errors\n"), out)
        self.assertIn("bad.cam:2:9: error: ", err)
        self.assertIn("did you mean 'sphere'?", err)

    def test_what_is_no_camera_file(self):
        self.refused("check", "none.cam", code=1, says="'none.cam'")
        self.refused("check", ".", code=1, says="'.' is a folder")
        self.run_command("check", "room.glb", code=1)
        (self.folder / "empty.cam").write_text("")
        self.run_command("check", "empty.cam", code=1)

    def test_json(self):
        (file,) = self.json_of("check", "my.cam")["files"]
        self.assertEqual((file["file"], file["cameras"], file["good"]), ("my.cam", 4, True))
        document = self.json_of("check", "bad.cam", "my.cam", "none.cam", code=1)
        self.assertEqual([file["good"] for file in document["files"]], [False, True, False])
        places = [(said["file"], said["line"], said["column"])
                  for said in document["diagnostics"] if "line" in said]
        self.assertIn(("bad.cam", 2, 9), places)


class Info(support.CommandTest):
    def test_without_lights(self):
        out, err = self.run_command("info", "scene.obj")
        self.assertEqual(err, "")
        self.assertRegex(out, r"triangles +3 in 2 objects, 2 meshes\n")
        self.assertRegex(out, r"lights +0; lit by a sky without sun")
        self.assertNotIn("tip", out)
        self.assertRegex(self.run_command("info", "scene.obj", "--objects")[0], r"object 2 +tip\n")

    def test_with_a_light(self):
        text = support.gltf_text_with_light()
        (self.folder / "lit.gltf").write_text(text)
        out, err = self.run_command("info", "lit.gltf")
        self.assertEqual(err, "")
        self.assertRegex(out, r"lights +1\n")
        self.assertRegex(out, r"triangles +1 in 1 object, 1 mesh\n")
        self.assertEqual(self.json_of("info", "lit.gltf")["scene"]["lights"], 1)

    def test_a_sky_beside_a_sun(self):
        document = json.loads(support.gltf_text_with_light())
        document["extensions"]["KHR_lights_punctual"]["lights"] = [{"type": "directional"}]
        (self.folder / "sun.gltf").write_text(json.dumps(document))
        out, _ = self.run_command("info", "sun.gltf")
        self.assertRegex(out, r"lights +1; lit by 1 lamp and a soft sky")
        self.assertIn("a soft sky", self.json_of("info", "sun.gltf")["scene"]["default_light"])

    def test_cameras(self):
        (self.folder / "filmed.gltf").write_text(support.gltf_text_with_cameras())
        out, err = self.run_command("info", "filmed.gltf")
        self.assertEqual(err, "")
        self.assertRegex(out, r"cameras +2\n")
        self.assertRegex(out, r"camera +Front, perspective, 90 x 90 degrees\n")
        self.assertRegex(out, r"camera +Plan, orthographic, 8 x 4 units\n")
        cameras = self.json_of("info", "filmed.gltf")["scene"]["cameras"]
        self.assertEqual([camera["name"] for camera in cameras], ["Front", "Plan"])
        self.assertEqual(cameras[1]["half_height"], 2)
        self.assertEqual(self.json_of("info", "scene.obj")["scene"]["cameras"], [])

    def test_json(self):
        scene = self.json_of("info", "scene.obj")["scene"]
        self.assertEqual(scene["objects"], ["wall", "tip"])
        self.assertEqual(scene["bounds"], [[-2, -1, -1], [2, 1, 0]])
        self.assertNotIn("scene", self.json_of("info", "none.obj", code=1))

    def test_lenses(self):
        out, err = self.run_command("info", "triplet.dat")
        self.assertEqual(err, "")
        self.assertRegex(out, r"focal length +50\.02 mm, f/5\n")
        self.assertRegex(out, r"\n +0 deg +100 % +\d+\.\d+ +\d+\.\d+ +\d+\.\d+\n +5 deg ")
        (self.folder / "wide.dat").write_text("stop 1 air 4\n20 3 1.5 8 radius_x=15\n-20 30 air 8\n")
        out, _ = self.run_command("info", "wide.dat")
        self.assertRegex(out, r"focal length +20\.51 mm in the vertical plane, .*\n +17\.65 mm in the")
        self.assertRegex(out, r"\n +5 up [^\n]*\n(.*\n)* +5 aside ")
        lens = self.json_of("info", "triplet.dat")["lens"]
        self.assertAlmostEqual(lens["focal_length"], 50.02, places=2)
        first, last = lens["spots"][0], lens["spots"][-1]
        self.assertEqual((first["field"], last["field"]), ([0, 0], [0, 30]))
        self.assertLess(first["rms_radius"], 0.02)
        self.assertLess(last["area"], 0.8 * first["area"])
        (self.folder / "bad.ZMX").write_text("SURF 0\nSURF 1\n")
        self.refused("info", "bad.ZMX", code=1, says="bad.ZMX:1:1: error: this file has no surfaces")
        self.refused("info", "none.dat", code=1, says="'none.dat'")

    def test_distortion_is_that_of_the_picture(self):
        """Where the lens shows a far point, by the ray through the middle of what passes; the
        table has the centroid of the light, which is a tenth of a per cent beside it."""
        (self.folder / "far.cam").write_text(
            "camera far { map u = 0.6 .. -0.6, v = square  eye point  toward plane((1, 0, 0))\n"
            "  lens table(\"dgauss.dat\", focus = 1e9, unit = 1) }\n")
        out, _ = self.run_command("info", "dgauss.dat")
        for angle in (15, 25):
            tangent = math.tan(math.radians(angle))
            (point,) = self.json_of("locate", "far.cam", "--size", "1000x200", "--point",
                                    f"1e9,{1e9 * tangent},0")["points"]
            seen = 0.6 * (1 - point["sightings"][0]["x"] / 500)
            (printed,) = re.findall(rf"\n +{angle} deg +\d+ % +(\S+) %", out)
            self.assertAlmostEqual(float(printed), 100 * (seen / tangent - 1), delta=0.15)

    def test_mistakes(self):
        self.refused("info", "none.obj", code=1, says="'none.obj'")
        self.refused("info", ".", code=1, says="'.' is a folder")
        self.refused("info", "", code=2, says="''")


if __name__ == "__main__":
    support.main()
