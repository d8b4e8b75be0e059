# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony locate: positions of points in space."""

import math
import struct
import subprocess

import support

# Parallel rays that come three times through y = 0.
FOLD = """camera fold {
    map u = 1.5 .. -1.5, v = -1 .. 1
    eye    surface(u, v) = [0, u^3 - u, v]
    toward surface(u, v) = [1, u^3 - u, v]
}
"""


class Locate(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "fold.cam").write_text(FOLD)

    def located(self, *words):
        return self.json_of("locate", *words)["points"]

    def test_the_pinhole_as_in_the_textbook(self):
        (point,) = self.located("pinhole", "--set", "fov=90deg", "--size", "400x200", "--point",
                                "4,1,-0.5")
        self.assertEqual(point["point"], [4, 1, -0.5])
        (seen,) = point["sightings"]
        self.assertAlmostEqual(seen["x"], 150)
        self.assertAlmostEqual(seen["y"], 125)
        self.assertAlmostEqual(seen["distance"], math.sqrt(17.25))

    def test_quiet_leaves_the_mistakes(self):
        words = ("locate", "panorama", "-q", "--point")
        self.assertEqual(self.run_command(*words, "1,2,3"), ("", ""))
        self.refused(*words, "1,2", code=2, says="'1,2'")

    def test_several_places_and_none(self):
        several, none = self.located("fold.cam", "--size", "300x200", "--point", "5,0,0",
                                     "--point", "-5,0,0")
        for seen, x in zip(several["sightings"], (50, 150, 250), strict=True):
            self.assertAlmostEqual(seen["x"], x, 5)
        self.assertEqual(none["sightings"], [])
        out, err = self.run_command("locate", "fold.cam", "--size", "300x200", "--point", "5,0,0",
                                    "--point", "-5,0,0")
        self.assertEqual(err, "")
        self.assertEqual(out.count("distance 5"), 3)
        self.assertIn("(-5, 0, 0) is not in the picture\n", out)

    def test_layers_of_a_picture(self):
        (self.folder / "two.cam").write_text(
            "picture two 400 x 100 {\n"
            "    layer panorama { place (0, 0) .. (0.5, 1) }\n"
            "    layer pinhole(fov = 90deg) { place (0.5, 0) .. (1, 1) alpha 0.5 }\n"
            "}\n")
        document = self.json_of("locate", "two.cam", "--point", "4,1,0")
        self.assertEqual(document["layers"], ["panorama", "pinhole"])
        self.assertEqual((document["width"], document["height"]), (400, 100))
        (left, right) = document["points"][0]["sightings"]
        self.assertEqual((left["layer"], right["layer"]), (0, 1))
        self.assertAlmostEqual(left["x"], 100 - 100 * math.atan2(1, 4) / math.pi)
        self.assertAlmostEqual(right["x"], 275)
        out, _ = self.run_command("locate", "two.cam", "--point", "4,1,0")
        self.assertIn("in layer 1, panorama\n", out)
        self.assertIn("in layer 2, pinhole\n", out)
        self.assertNotIn(" in ", self.run_command("locate", "pinhole", "--point", "4,1,0")[0])

    def test_layers_have_the_numbers_of_explain(self):
        (self.folder / "nested.cam").write_text(
            "picture pair { layer panorama { alpha 0.5 } layer pinhole { alpha 0.5 } }\n"
            "picture all 400 x 100 {\n"
            "    layer pinhole { frame alpha 0.5 }\n"
            "    layer pair { alpha 0.5 leader (0.1, 0.1) .. (0.2, 0.2) }\n"
            "    layer panorama { alpha 0.5 }\n"
            "}\n")
        document = self.json_of("locate", "nested.cam", "--point", "4,0.1,0")
        self.assertEqual(document["layer_numbers"], ["1", "2.1", "2.2", "3"])
        self.assertEqual(document["layers"],
                         ["pinhole", "pair/panorama", "pair/pinhole", "panorama"])
        out, _ = self.run_command("locate", "nested.cam", "--point", "4,0.1,0")
        explained, _ = self.run_command("explain", "nested.cam")
        for number, name in zip(document["layer_numbers"], document["layers"], strict=True):
            self.assertIn(f"in layer {number}, {name}\n", out)
            self.assertRegex(explained, rf"(?m)^ *{number}  ")
        self.assertEqual(self.json_of("locate", "pinhole", "--point", "4,1,0")["layer_numbers"],
                         ["1"])

    def test_a_picture_of_several_axes(self):
        (self.folder / "mixed.cam").write_text(
            "camera up { axes y_up map u = 1 .. -1, v = square eye point(0, 0, 0) "
            "toward plane((1, 0, 0)) }\npicture mixed { layer panorama layer up }")
        self.refused("locate", "mixed.cam", "--point", "4,1,0", code=1, says="different axes",
                     helps="y_up or z_up")
        self.located("mixed.cam", "--point", "4,1,0", "--axes", "z_up")

    def test_hidden_in_a_scene(self):
        words = ("my.cam:above", "--scene", "scene.obj", "--size", "120x60")
        wall, beside, tip = self.located(*words, "--point", "0,0,-1", "--point", "1.8,0.5,-1",
                                         "--point", "0,0,0")
        self.assertEqual(wall["sightings"][0]["hidden_by"], {"object": "tip", "distance": 5})
        self.assertEqual(wall["sightings"][0]["distance"], 6)
        self.assertIsNone(beside["sightings"][0]["hidden_by"])
        self.assertIsNone(tip["sightings"][0]["hidden_by"])
        out, _ = self.run_command("locate", *words, "--point", "0,0,-1", "--point", "0,0,0")
        self.assertIn("distance 6   hidden by tip at distance 5\n", out)
        self.assertIn("distance 5   seen\n", out)
        (bare,) = self.located("my.cam:above", "--point", "0,0,-1")
        self.assertNotIn("hidden_by", bare["sightings"][0])

    def test_layers_of_some_objects(self):
        (self.folder / "some.cam").write_text(
            'import "my.cam"\npicture some { layer above { hide objects("t?p") } }\n')
        words = ("--scene", "scene.obj", "--size", "120x60", "--point", "0,0,-1")
        (wall,) = self.located("some.cam", *words)
        self.assertIsNone(wall["sightings"][0]["hidden_by"])
        (self.folder / "none.cam").write_text(
            'import "my.cam"\npicture none { layer above { show objects("tap") } }\n')
        self.refused("locate", "none.cam", *words, code=1, says="layer 1 shows 'tap'",
                     helps="did you mean 'tip'?")

    def test_points_are_in_the_axes_of_the_scene(self):
        # The pinhole's own axes have z up, the scene's have y up: x is forward for both.
        (self.folder / "upright.obj").write_text(
            "o door\nv 5 -1 -9\nv 5 9 -9\nv 5 9 1\nv 5 -1 1\nf 1 2 3 4\n")
        words = ("pinhole", "--set", "fov=90deg", "--size", "200")
        (own,) = self.located(*words, "--point", "10,1,2")
        scene = ("--scene", "upright.obj", "--no-fit")
        for point, axes in (("10,2,-1", ()), ("10,2,-1", ("--axes", "y_up")),
                            ("10,1,2", ("--axes", "z_up"))):
            (same,) = self.located(*words, *scene, "--point", point, *axes)
            (seen,) = same["sightings"]
            self.assertAlmostEqual(seen["x"], own["sightings"][0]["x"])
            self.assertAlmostEqual(seen["y"], own["sightings"][0]["y"])
            self.assertEqual(seen["hidden_by"]["object"], "door")
            self.assertAlmostEqual(seen["hidden_by"]["distance"], seen["distance"] / 2, 5)
        # As far to the other side, past the door's edge at z = 1.
        (free,) = self.located(*words, *scene, "--point", "10,2,3")
        self.assertIsNone(free["sightings"][0]["hidden_by"])

    def test_axes_of_the_points(self):
        words = ("pinhole", "--size", "400", "--point")
        own = self.located(*words, "5,1,2")[0]["sightings"]
        self.assertEqual(own, self.located(*words, "5,2,-1", "--axes", "y_up")[0]["sightings"])
        self.assertEqual(own, self.located(*words, "5,1,2", "--axes", "z_up")[0]["sightings"])

    def test_says_in_which_axes_it_reads(self):
        for words, text, name in (((), "z up (axes of the camera)", "z_up"),
                                  (("--axes", "y_up"), "y up (by --axes)", "y_up"),
                                  (("--scene", "scene.obj"), "y up (axes of the scene)", "y_up")):
            out, _ = self.run_command("locate", "pinhole", "--point", "5,0,0", *words)
            self.assertIn(f"points are read with {text}\n", out)
            document = self.json_of("locate", "pinhole", "--point", "5,0,0", *words)
            self.assertEqual(document["axes"], name)

    def test_says_why_no_point_is_in_the_picture(self):
        # A camera that looks up: what is above with y up is in front with z up.
        (self.folder / "up.cam").write_text(
            "camera up { map u = 0.5 .. -0.5, v = square eye point(0, 0, 0)\n"
            "toward plane((0, 0, 1), (0, 1, 0), (1, 0, 0)) look relative }")
        _, err = self.run_command("locate", "up.cam", "--point", "0,9,0", "--point", "0,0,50")
        self.assertEqual(err, "")
        _, err = self.run_command("locate", "up.cam", "--point", "0,9,0.1", "--point", "0,-9,0")
        self.assertIn("read with z up; with y up, 1 of 2 is", err)
        self.assertIn("add --axes y_up", err)
        _, err = self.run_command("locate", "pinhole", "--point", "-7,0.1,0.1", "--point", "-9,0,0")
        self.assertIn("all points lie behind the camera, the nearest at a distance of 7.", err)
        # Beside the picture, but in front.
        _, err = self.run_command("locate", "pinhole", "--point", "1,7,7")
        self.assertEqual(err, "")

    def test_time(self):
        (self.folder / "turning.cam").write_text(
            "camera a { map u = 45deg .. -45deg, v = square eye point(0, 0, 0) toward sphere(1) "
            "move rotate(z, t*10deg) }")
        (point,) = self.located("turning.cam", "--size", "900", "--time", "2", "--point", "5,0,0")
        self.assertAlmostEqual(point["sightings"][0]["x"], 650, 5)

    def test_points_from_a_file_and_from_standard_input(self):
        text = "x,y,z\n5,0,0\n# a comment\n\n5 1 0.5\n"
        (self.folder / "points.csv").write_text(text)
        from_file = self.run_command("locate", "pinhole", "--points", "points.csv")[0]
        self.assertEqual(from_file.count("is visible at"), 2)
        with self.start("locate", "pinhole", "--points", "-", stdin=subprocess.PIPE) as process:
            out, _ = process.communicate(text.encode(), timeout=60)
        self.assertEqual(out.decode(), from_file)

    def npy(self, name, shape, numbers, descr="<f8", fortran=False):
        header = f"{{'descr': '{descr}', 'fortran_order': {fortran}, 'shape': {shape}, }}"
        header += " " * (117 - len(header)) + "\n"
        body = struct.pack(f"{descr[0]}{len(numbers)}{'d' if descr[2] == '8' else 'f'}", *numbers)
        data = b"\x93NUMPY\x01\0" + struct.pack("<H", len(header)) + header.encode() + body
        (self.folder / name).write_bytes(data)
        return data

    def rows(self, name, columns):
        data = (self.folder / name).read_bytes()
        size = struct.unpack("<H", data[8:10])[0] + 10
        self.assertEqual(size % 64, 0)
        count = (len(data) - size) // (8 * columns)
        self.assertIn(f"'shape': ({count}, {columns})".encode(), data[:size])
        numbers = struct.unpack(f"<{count * columns}d", data[size:])
        return [numbers[i:i + columns] for i in range(0, len(numbers), columns)]

    def test_arrays_of_numpy(self):
        points = [5, 0, 0, -5, 0, 0, 5, 0.25, 0.5]
        wanted = self.located("fold.cam", "--size", "300x200", "--point", "5,0,0", "--point",
                              "-5,0,0", "--point", "5,0.25,0.5")
        wanted = [(number, one["x"], one["y"], one["layer"], one["distance"])
                  for number, point in enumerate(wanted) for one in point["sightings"]]
        columns = [points[i + j] for j in range(3) for i in (0, 3, 6)]
        for words in (((3, 3), points), ((3, 3), points, ">f8"), ((3, 3), points, "<f4"),
                      ((3, 3), columns, "<f8", True)):
            self.npy("points.npy", *words)
            out, err = self.run_command("locate", "fold.cam", "--size", "300x200", "--points",
                                        "points.npy", "-o", "seen.npy")
            self.assertEqual((out, err), ("seen.npy: 6 sightings of 3 points\n", ""))
            self.assertEqual(self.rows("seen.npy", 5), wanted)
        data = self.npy("points.npy", (3, 3), points)
        text = self.run_command("locate", "fold.cam", "--points", "points.npy")[0]
        with self.start("locate", "fold.cam", "--points", "-", stdin=subprocess.PIPE) as process:
            self.assertEqual(process.communicate(data, timeout=60)[0].decode(), text)
        self.assertEqual(text.count("distance 5"), 6)
        # With a scene there is a column more.
        self.npy("two.npy", (2, 3), [0, 0, -1, 0, 0, 0])
        self.run_command("locate", "my.cam:above", "--scene", "scene.obj", "--points", "two.npy",
                         "-o", "hidden.npy")
        self.assertEqual([(row[0], row[5]) for row in self.rows("hidden.npy", 6)], [(0, 1), (1, 0)])

    def test_more_points_than_are_read_at_a_time(self):
        count = 200000
        text = "x y z\n" + "".join(f"5 {i % 7} 0\n" for i in range(count))
        (self.folder / "many.txt").write_text(text)
        out, _ = self.run_command("locate", "pinhole", "--set", "fov=120deg", "--size", "900",
                                  "--points", "many.txt", "-o", "many.npy")
        self.assertEqual(out, f"many.npy: {count} sightings of {count} points\n")
        rows = self.rows("many.npy", 5)
        self.assertEqual([int(row[0]) for row in rows], list(range(count)))
        for i in range(0, count, 999):
            self.assertAlmostEqual(rows[i][1], 450 * (1 - (i % 7) / 5 / math.tan(math.pi / 3)))
        # What is wrong is found at its line; lines before it have been answered.
        (self.folder / "many.txt").write_text(text + "1 2\n")
        _, err = self.run_command("locate", "pinhole", "--points", "many.txt", "-o", "no.npy", code=1)
        self.assertIn(f"many.txt:{count + 2}:1: error: this row is not a point", err)
        self.assertNotIn("no.npy", self.files())

    def test_arrays_that_are_refused(self):
        whole = self.npy("points.npy", (3, 3), range(9))
        for data, says in (
                (whole[:-1], "ends before its 3 points do"),
                (whole[:60], "truncated"),
                (self.npy("points.npy", (9,), range(9)), "has the shape (9)"),
                (self.npy("points.npy", (0, 3), []), "has no numbers"),
                (whole.replace(b"<f8", b"<i8"), "are not floats")):
            (self.folder / "points.npy").write_bytes(data)
            self.refused("locate", "pinhole", "--points", "points.npy", code=1, says=says)
        self.npy("points.npy", (3, 3), range(9), fortran=True)
        with self.start("locate", "pinhole", "--points", "-", stdin=subprocess.PIPE,
                        stderr=subprocess.PIPE) as process:
            _, err = process.communicate((self.folder / "points.npy").read_bytes(), timeout=60)
        self.assertIn(b"column by column", err)
        self.refused("locate", "pinhole", "--point", "5,0,0", "-o", "p.csv", code=2, says="'p.csv'",
                     helps=".npy")
        self.refused("locate", "pinhole", "--points", "points.npy", "-o", "points.npy", code=2,
                     says="points.npy")

    def test_mistakes(self):
        self.refused("locate", "pinhole", code=2, says="no point", helps="--point")
        for point in ("1,2", "1,2,3,4", "1,2,x", "1,,3", "nan,0,0", ""):
            self.refused("locate", "pinhole", f"--point={point}", code=2, says="--point")
        self.refused("locate", "pinhole", "--point", "1,2,3", "--axes", "up", code=2, says="--axes")
        self.refused("locate", "pinhole", "--points", "none.csv", code=1, says="none.csv")
        (self.folder / "bad.csv").write_text("1,2,3\n4,5\n")
        self.refused("locate", "pinhole", "--points", "bad.csv", code=1, says="bad.csv:2:1")
        self.refused("locate", "pinhole", "--points", ".", code=1, says="'.' is a folder")
        with open("/dev/zero", "rb") as endless:
            _, err = self.run_command("locate", "pinhole", "--points", "-", code=1, stdin=endless)
        self.assertIn("'standard input' is neither a text nor an array of NumPy", err)
        self.refused("locate", "pinhole", "--point", "1,2,3", "--scene", "none.glb", code=1,
                     says="none.glb")
        self.refused("locate", "pinhole", "--point", "1,2,3", "--scene", "my.cam", code=1,
                     says="'my.cam' is a camera, not a scene")
        self.refused("locate", "none.cam", "--point", "1,2,3", code=1, says="none.cam")
        self.json_of("locate", "none.cam", "--point", "1,2,3", code=1)
        self.json_of("locate", "pinhole", code=2)


if __name__ == "__main__":
    support.main()
