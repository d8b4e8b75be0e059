# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony check: the analysis of cameras, apart from errors in their text."""

import os
import struct
import zlib

import support

CAMERAS = """// Looks at the front of the scene.
camera front(turn = 0) {
    axes y_up
    map  u = -2 .. 2, v = square
    eye  surface(u, v) = [u, v, 5]
    toward surface(u, v) = [u + turn, v, 0]
    look relative
}

// Shows a part of it several times, once mirrored.
camera folded {
    axes y_up
    map  u = -2 .. 2, v = square
    warp zoom(at = (0.5, 0), radius = 0.5, strength = 0.2)
    eye  surface(u, v) = [u, v, 5]
    toward surface(u, v) = [u, v, 0]
    look relative
}
"""

# Layers that show one camera with the same parameters, with others, and one that has a fault.
PICTURES = """import "two.cam"
picture pair { layer front(turn = 5) layer folded }
picture poster(slant = 5) 160 x 90 {
    layer front
    layer front(turn = slant) { place (0, 0) .. (1/2, 1/2) }
    layer pair                { place (0, 0) .. (1/4, 1/2) arrange rotate(90deg) }
    layer front(turn = 2)     { place (1/2, 1/2) .. (1, 1) }
}
"""


def box(first, last):
    """A closed box that faces outwards: from first to last along x, -9 to 9 along y and z."""
    corners = [f"v {x} {y} {z}" for z in (-9, 9) for y in (-9, 9) for x in (first, last)]
    return "\n".join(["o box", *corners, "f 1 3 4 2", "f 5 6 8 7", "f 1 2 6 5", "f 3 7 8 4",
                      "f 1 5 7 3", "f 2 4 8 6", ""])


def png_size(path):
    """Width and height of a PNG file, each chunk checked."""
    data, place, size = path.read_bytes(), 8, None
    while place < len(data):
        length, kind = struct.unpack_from(">I4s", data, place)
        body = data[place + 8:place + 8 + length]
        (check,) = struct.unpack_from(">I", data, place + 8 + length)
        assert zlib.crc32(kind + body) == check, "a chunk's check sum is wrong"
        size = struct.unpack_from(">II", body) if kind == b"IHDR" else size
        place += 12 + length
    return size


class Check(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "two.cam").write_text(CAMERAS)

    def reports(self, *words, code=0):
        return self.json_of("check", *words, "--size", "160x90", code=code)["files"][0]["reports"]

    def test_text(self):
        out, err = self.run_command("check", "two.cam")
        self.assertEqual(err, "")
        front, folded = out.split("\ncamera ")[1:]
        self.assertTrue(front.startswith("front: "), out)
        self.assertIn("no defects", front)
        self.assertRegex(folded, r"fold +the picture folds over: \S+ % of it, in one region")
        self.assertRegex(folded, r"at \(\S+, \S+\), u = \S+, v = ")
        self.assertIn("help: ", folded)
        self.assertNotIn("no defects", folded)

    def test_quiet_leaves_the_mistakes(self):
        self.assertEqual(self.run_command("check", "two.cam", "-q"), ("", ""))
        out, err = self.run_command("check", "two.cam", "-q", "--strict", code=1)
        self.assertEqual(out, "")
        self.assertIn("camera 'folded' has 2 defects, but --strict allows none", err)

    def test_one_camera_with_parameters(self):
        (report,) = self.reports("two.cam:front")
        self.assertEqual((report["camera"], report["width"], report["defects"]), ("front", 160, 0))
        self.assertAlmostEqual(report["magnification"]["median"], 40, places=9)
        # Slanting rays see what is straight before them compressed.
        (report,) = self.reports("two.cam:front", "--set", "turn=5")
        self.assertAlmostEqual(report["anisotropy"]["median"], 2 ** 0.5, places=9)
        (report,) = self.reports("pinhole", "--distance", "3")
        self.assertEqual((report["single_viewpoint"], report["distance"]), (True, 3))
        (report,) = self.reports("my.cam:nowhere")
        self.assertEqual((report["magnification"], report["valid_share"]), (None, 0))
        self.refused_after_text("two.cam:front", "--set", "turm=5", says="'turm'")
        self.refused_after_text("two.cam:frnt", says="'frnt'")

    def test_pictures(self):
        (self.folder / "poster.cam").write_text(PICTURES)
        reports = self.json_of("check", "poster.cam:poster")["files"][0]["reports"]
        self.assertEqual(
            [(report["camera"], [layer["layer"] for layer in report["layers"]], report["width"],
              report["height"]) for report in reports],
            [("front", ["1"], 160, 90),
             # With one and the same turn, in the largest of its layers.
             ("front", ["2", "3.1"], 80, 45),
             ("folded", ["3.2"], 40, 45),
             ("front", ["4"], 80, 45)])
        # The parameters are those that the layers give; slanting rays see things compressed.
        for report, turn in ((reports[0], 0), (reports[1], 5), (reports[3], 2)):
            self.assertAlmostEqual(report["anisotropy"]["median"], (1 + (turn/5)**2)**0.5, places=9)
        out, _ = self.run_command("check", "poster.cam:poster", "--set", "slant=2")
        self.assertIn("\ncamera front, layer 2 of poster, layer 4 of poster: 80 x 45 pixels", out)
        # The whole file: what two pictures show is looked at once.
        out, err = self.run_command("check", "poster.cam", "--strict", code=1)
        self.assertEqual(out.count("\ncamera "), 4)
        self.assertIn("\ncamera folded, layer 2 of pair, layer 3.2 of poster: ", out)
        self.assertIn("camera 'folded, layer 2 of pair, layer 3.2 of poster' has ", err)
        # A camera by itself as well.
        (self.folder / "both.cam").write_text(CAMERAS + "picture both { layer front layer folded }")
        out, _ = self.run_command("check", "both.cam")
        self.assertIn("\ncamera front, and layer 1 of both: ", out)

    def test_one_layer(self):
        (self.folder / "poster.cam").write_text(PICTURES)
        numbers = lambda *words: [[layer["layer"] for layer in report["layers"]]
                                  for report in self.reports("poster.cam:poster", *words)]
        self.assertEqual(numbers("--layer", "2"), [["2"]])
        self.assertEqual(numbers("--layer", "3"), [["3.1"], ["3.2"]])
        self.assertEqual(numbers("--layer", "3.2", "--map", "seams", "a.png"), [["3.2"]])
        self.assertGreater(png_size(self.folder / "a.png")[0], 0)
        self.refused("check", "poster.cam:poster", "--map", "seams", "a.png", code=2,
                     says="several", helps="--layer: 1 for front, 2 for front, 3.1 for front, "
                                           "3.2 for folded, 4 for front")
        self.refused("check", "poster.cam", "two.cam", "--layer", "1", code=2, says="--layer")
        self.refused_after_text("poster.cam:poster", "--layer", "5", says="no layer 5")
        self.refused_after_text("two.cam:front", "--layer", "1", says="'front' is a camera")

    def refused_after_text(self, *words, says):
        _, err = self.run_command("check", *words, code=1)
        self.assertIn("error: ", err)
        self.assertIn(says, err)

    def test_what_is_found_is_not_followed_by_all_is_well(self):
        (self.folder / "mirrored.cam").write_text(
            "camera m { map u = -1 .. 1, v = -1 .. 1 eye point(0, 0, 0)\n"
            "toward surface(u, v) = [1, u, v] look relative }")
        out, _ = self.run_command("check", "mirrored.cam")
        self.assertIn("the picture is mirrored", out)
        self.assertIn("no defects     apart from what is said above", out)
        self.assertNotIn("no folds", out)

    def test_mistakes_elsewhere_in_the_file_are_reported(self):
        (self.folder / "half.cam").write_text(CAMERAS + "camera other { eye sphree(1) }\n")
        _, err = self.run_command("check", "half.cam:front", "--set", "turn=1", code=1)
        self.assertIn("sphree", err)
        self.assertNotIn("'turn'", err)

    def test_strict(self):
        self.run_command("check", "two.cam:front", "--strict")
        _, err = self.run_command("check", "two.cam:folded", "--strict", code=1)
        self.assertIn("camera 'folded' has ", err)
        (report,) = self.reports("two.cam:folded", "--strict", code=1)
        self.assertIn("fold", [finding["kind"] for finding in report["findings"]])
        self.run_command("check", "my.cam:half", "--strict", code=1)

    def test_a_good_file_without_what_is_asked_for(self):
        for words, says in ((("two.cam:foo",), "'foo'"), (("panorama:foo",), "'foo'"),
                            (("two.cam", "--set", "nothing=1"), "'nothing'")):
            self.refused("check", *words, code=1, says=says)
            (entry,) = self.json_of("check", *words, code=1)["files"]
            self.assertFalse(entry["good"])

    def test_a_map_in_degrees_without_deg(self):
        (self.folder / "round.cam").write_text("""
camera turns(u = 180deg, v = 90deg) { aspect 2 map u = u .. -u, v = -v .. v eye sphere(1) }
camera seen(u = 45) { map u = u .. -u, v = square eye point toward sphere(1) }
camera formula(u = 180) { map u = -u .. u, v = -1 .. 1
    eye surface(a, b) = [cos(a), sin(a), b] warp rotate(0) }
camera tall(v = 60) { map u = 30deg .. -30deg, v = -v .. v eye cylinder(1) }
camera flat { map u = 180 .. -180, v = square eye plane look normal }
camera unused { map u = 30deg .. -30deg, v = -60 .. 60 eye circle(1) look tangent }
""")
        for words, says in (
                (("turns", "--set", "u=180*1rad", "--set", "v=90*1rad"),
                 "u covers 57.3 turns and v covers 28.6 turns"),
                (("turns", "--set", "u=180*1rad"), "u covers 57.3 turns"),
                (("turns", "--set", "v=90*1rad"), "v covers 28.6 turns"),
                (("seen",), "u covers 14.3 turns and v covers 8.06 turns"),
                (("formula",), "u covers 57.3 turns")):
            (report,) = self.reports(f"round.cam:{words[0]}", *words[1:])
            first, *others = report["findings"]
            self.assertEqual((first["kind"], first["message"]), ("repeated", says))
            self.assertTrue(first["defect"])
            self.assertIn("append deg", first["remedy"])
            self.assertNotIn("repeated", [finding["kind"] for finding in others])
        # Lengths are none, nor what the rays do not depend on, nor a turn or four.
        for words in (("turns",), ("turns", "--set", "u=720deg"), ("seen", "--set", "u=3"),
                      ("tall",), ("flat",), ("unused",)):
            (report,) = self.reports(f"round.cam:{words[0]}", *words[1:])
            self.assertNotIn("append deg", str(report["findings"]), words)

    def test_rays_in_the_plane_that_they_start_from(self):
        (self.folder / "planes.cam").write_text("""
camera inside { map u = 1 .. -1, v = square eye point(3, 2, 1) toward plane((3, 0, 0)) }
camera slide { map u = 1 .. -1, v = square eye plane((3, 0, 0)) toward plane((3, 5, 1)) }
camera unused { map u = 1 .. -1, v = square eye circle(1) look tangent }
""")
        for name, says in (("inside", "all rays lie in one plane"),
                           ("slide", "all rays lie in one plane"),
                           ("unused", "do not use")):
            (report,) = self.reports(f"planes.cam:{name}")
            (finding,) = report["findings"]
            self.assertEqual((finding["kind"], finding["share"]), ("singular", 1))
            self.assertIn(says, finding["remedy"])

    def test_a_lens_is_named(self):
        (self.folder / "lens.cam").write_text("""
camera without { map u = 1 .. -1, v = square eye point toward plane((1, 0, 0)) }
camera with { map u = 1 .. -1, v = square eye point toward plane((1, 0, 0)) lens(0.1, focus = 2) }
""")
        for name, has_lens in (("without", False), ("with", True)):
            (report,) = self.reports(f"lens.cam:{name}")
            self.assertIs(report["lens"], has_lens)
            out, _ = self.run_command("check", f"lens.cam:{name}")
            self.assertEqual("only the rays through its centre" in out, has_lens)

    def test_in_a_scene(self):
        (report,) = self.reports("two.cam:front", "--scene", "scene.obj")
        self.assertEqual(report["in_scene"],
                         {"scene": "scene.obj", "never_seen": [], "starts_inside": [],
                          "meets_nothing": None, "scale": None})
        # The wall is 6 away, the triangle before it 5; more of the rays meet the wall.
        self.assertAlmostEqual(report["distance"], 6, places=5)
        (self.folder / "box.obj").write_text(box(0.5, 3))
        (report,) = self.reports("two.cam:front", "--scene", "box.obj", "--strict", code=1)
        (start,) = report["in_scene"]["starts_inside"]
        self.assertEqual(start["object"], "box")
        # Origins from -2 to 2, of which those right of 0.5.
        self.assertAlmostEqual(start["share"], 1.5 / 4, delta=0.02)
        # The box comes first, so that its numbers of vertices are right.
        tip = "o tip\nv -1 -1 0\nv 1 -1 0\nv 0 1 0\nf -3 -2 -1\n"
        (self.folder / "aside.obj").write_text(box(90, 99) + tip)
        out, _ = self.run_command("check", "two.cam:front", "--scene", "aside.obj", "--strict")
        self.assertRegex(out, r"never seen +1 object: box\n")
        (self.folder / "aside.obj").write_text(box(90, 99))
        out, _ = self.run_command("check", "two.cam:front", "--scene", "aside.obj", "--strict",
                                  code=1)
        self.assertRegex(out, r"meets nothing +no ray meets anything: they start outside the scene")
        self.assertNotIn("never seen", out)
        self.refused("check", "two.cam", "--scene", "none.obj", code=1, says="'none.obj'")
        self.refused("check", "two.cam", "--scene", "my.cam", code=1,
                     says="'my.cam' is a camera, not a scene")

    def test_maps(self):
        kinds = ("magnification", "anisotropy", "orientation", "validity", "seams", "repeated",
                 "origins")
        words = [word for kind in kinds for word in ("--map", kind, f"{kind}.png")]
        out, _ = self.run_command("check", "two.cam:folded", *words)
        for kind in kinds:
            self.assertRegex(out, rf"map +{kind}.png\n")
            width, height = png_size(self.folder / f"{kind}.png")
            self.assertGreaterEqual(width, 800)
            self.assertGreater(height, width // 2)

    def test_mistakes(self):
        one = ("check", "two.cam:front")
        self.refused(*one, "--map", "seam", "a.png", code=2, says="'seam'", helps="'seams'")
        self.refused(*one, "--map", "scale", "a.png", code=2, says="needs a scene",
                     helps="--scene")
        self.refused(*one, "--map", "scale", "a.png", "--scene", "scene.obj", code=2,
                     says="--map scale: 'front' has no scale", helps="aspect (WIDTH, HEIGHT)")
        self.refused(*one, "--map", "seams", "a.gif", code=2, says="'a.gif'", helps=".png")
        self.refused("check", "two.cam", "--map", "seams", "a.png", code=2, says="several",
                     helps="two.cam:NAME")
        self.refused(*one, "--distance", "0", code=2, says="--distance")
        self.refused(*one, "--size", "0x9", code=2, says="--size")
        (self.folder / "cam.png").write_text(CAMERAS)
        self.refused("check", "cam.png:front", "--map", "seams", "cam.png", code=2,
                     says="'cam.png' is read here and would be overwritten")
        self.run_command(*one, "--map", "seams", "nowhere/a.png", code=3)
        for again in ("a.png", "./a.png", "../" + self.folder.name + "/a.png",
                      str(self.folder / "a.png")):
            self.refused(*one, "--map", "seams", "a.png", "--map", "origins", again, code=2,
                         says=f"'{again}'", helps="a different file for each")
        self.assertNotIn("a.png", self.files())
        os.mkfifo(self.folder / "pipe.png")
        self.run_command(*one, "--map", "seams", "pipe.png", code=3)
        self.assertTrue((self.folder / "pipe.png").is_fifo())

    def test_a_picture_larger_than_any_memory(self):
        out, _ = self.run_command("check", "two.cam:front", "--size", "1000000x1000000", "--scene",
                                  "scene.obj", "--map", "magnification", "large.png")
        self.assertIn("1000000 x 1000000 pixels", out)
        width, height = png_size(self.folder / "large.png")
        self.assertLess(width * height, 1e8)


if __name__ == "__main__":
    support.main()
