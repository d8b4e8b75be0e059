# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony solve: parameters of a camera by what its picture is to show."""

import math

import support

CAMERA = """// A photo of the facade.
camera photo(fov = 60deg from 10deg to 150deg,  // across
             yaw = 0deg, px = 0, count = 3) {
    let half = tan(fov/2)
    map    u = half .. -half, v = square
    eye    point(px, 0, 0)
    toward plane((1, 0, 0))
    move   rotate(z, yaw + 0deg*count)
}
"""

# A camera with fov = 80deg and yaw = 20deg shows these where they are demanded.
TURN = math.radians(20)
HALF = math.tan(math.radians(40))


def position(point):
    x = math.cos(TURN) * point[0] + math.sin(TURN) * point[1]
    y = -math.sin(TURN) * point[0] + math.cos(TURN) * point[1]
    return 200 * (1 - y / x / HALF), 150 - 200 * point[2] / x / HALF


POINTS = {"door": (10, 2, -1), "gable": (10, 6, 3), "sign": (8, 1, 1)}


def marks(**changes):
    rows = {"size": "[400, 300]", "unknowns": "[fov, yaw]",
            "marks": "{" + ", ".join(f"{name}: [{x}, {y}, {z}]"
                                     for name, (x, y, z) in POINTS.items()) + "}",
            "constraints": "".join(
                "\n  - {at: %s, position: [%.9f, %.9f], deviation: 0.5}" % (name, *position(point))
                for name, point in POINTS.items())}
    rows.update(changes)
    return "".join(f"{name}: {row}\n" for name, row in rows.items() if row)


class Solve(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "photo.cam").write_text(CAMERA)
        (self.folder / "marks.yml").write_text(marks())

    def solved(self, *words, text=None):
        if text is not None:
            (self.folder / "marks.yml").write_text(text)
        return self.json_of("solve", "photo.cam", "--with", "marks.yml", *words)

    def test_the_camera_that_made_the_marks_is_found(self):
        document = self.solved("-o", "solved.cam")
        self.assertEqual(document["diagnostics"], [])
        fov, yaw = document["parameters"]
        self.assertAlmostEqual(math.degrees(fov["value"]), 80, 6)
        self.assertAlmostEqual(math.degrees(yaw["value"]), 20, 6)
        self.assertEqual(fov["first"], math.radians(60))
        self.assertTrue(0 < fov["deviation"] < 0.01)
        (first, both), (again, second) = document["covariance"]
        self.assertAlmostEqual(first ** 0.5 / fov["deviation"], 1, 12)
        self.assertAlmostEqual(second ** 0.5 / yaw["deviation"], 1, 12)
        self.assertAlmostEqual(both / again, 1, 12)
        self.assertTrue(0 < abs(both) < fov["deviation"] * yaw["deviation"])
        self.assertEqual([row["name"] for row in document["constraints"]],
                         ["at door", "at gable", "at sign"])
        for row in document["constraints"]:
            self.assertLess(row["deviations"], 1e-6)
        # Comments and layout stay, and the new file has the very numbers.
        text = (self.folder / "solved.cam").read_text()
        expected = CAMERA.replace("60deg", fov["written"]).replace(
            "yaw = 0deg", "yaw = " + yaw["written"])
        self.assertEqual(text, expected)
        self.assertEqual(document["text"], expected)
        for point in POINTS.values():
            (found,) = self.json_of("locate", "solved.cam", "--size", "400x300", "--point",
                                    "%s,%s,%s" % point)["points"]
            x, y = position(point)
            self.assertAlmostEqual(found["sightings"][0]["x"], x, 5)
            self.assertAlmostEqual(found["sightings"][0]["y"], y, 5)

    def test_the_table_has_parameters_and_constraints(self):
        out, err = self.run_command("solve", "photo.cam", "--with", "marks.yml")
        self.assertEqual(err, "")
        self.assertIn("photo, 400 x 300 pixels: solved after", out)
        self.assertRegex(out, r"\nfov +80deg +0\.\d+deg +60deg\n")
        self.assertIn("\nat gable ", out)
        self.assertIn("expected uncertainty of projections: ", out)

    def test_values_that_are_set_are_in_the_new_file(self):
        document = self.solved("--set", "px=1/2", "--set", "fov=70deg", "-o", "solved.cam",
                               text=marks(unknowns="[yaw]"))
        self.assertIn("fov = 70deg from", document["text"])
        self.assertIn("px = 1/2", document["text"])

    def test_what_is_unknown(self):
        def names(text):
            return [one["name"] for one in self.solved(text=text)["parameters"]]

        self.assertEqual(names(marks(fixed="[count, px]", unknowns=None)), ["fov", "yaw"])
        self.assertEqual(names(marks(unknowns="[yaw]")), ["yaw"])
        self.assertEqual(names(marks(unknowns="{yaw: {start: 10deg}}", fixed="[count, px]")),
                         ["fov", "yaw"])

    def test_a_render_shows_the_marks(self):
        self.run_command("render", "scene.obj", "--camera", "photo.cam", "--solve", "marks.yml",
                         "--size", "16x12", "-s", "1", "-o", "a.png")
        self.solved("-o", "solved.cam")
        self.run_command("render", "scene.obj", "--camera", "solved.cam", "--size", "16x12", "-s",
                         "1", "-o", "b.png")
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())
        self.refused("render", "scene.obj", "--solve", "marks.yml", code=2,
                     says="--solve needs a camera of a file")
        self.refused("render", "scene.obj", "--camera", "pinhole", "--fit", "--solve", "marks.yml",
                     code=2, says="--solve and a camera that the scene places")

    def test_marks_are_on_objects_of_a_scene(self):
        """The tip is 2 wide and 2 high around (0, 0, 0), the axes of OBJ have y up."""
        (self.folder / "above.cam").write_text(support.CAMERAS.split("// Has no ray left")[0])
        text = ("size: [200, 100]\nscene: scene.obj\nunknowns: [size]\nmarks:\n"
                "  left: {object: tip, part: [-1, 0, 0]}\n  right: {object: tip, part: [1, 0, 0]}\n"
                "constraints: [{length: [left, right], value: 40}]\n")
        (self.folder / "marks.yml").write_text(text)
        document = self.json_of("solve", "above.cam", "--with", "marks.yml")
        # 2 units of 2 * size have 40 pixels of 200.
        self.assertAlmostEqual(document["parameters"][0]["value"], 5, 6)
        seen = [one["seen"] for one in document["marks"]]
        self.assertAlmostEqual(seen[0][0], 80, 6)
        self.assertAlmostEqual(seen[1][0], 120, 6)
        (self.folder / "marks.yml").write_text(text.replace("{object: tip", "{object: top"))
        self.refused("solve", "above.cam", "--with", "marks.yml", code=1,
                     says="'scene.obj' has no object 'top'", helps="did you mean 'tip'?")

    def test_edges_vanish(self):
        """Edges of the box of the tip along the scene's x axis vanish where that axis does."""
        text = ("size: [400, 300]\nscene: scene.obj\naxes: z_up\nunknowns: [yaw]\nmarks:\n"
                "  along: {direction: [left, right]}\n"
                "  left: {object: tip, part: [-1, 0, 1]}\n  right: {object: tip, part: [1, 0, 1]}\n"
                "constraints: [{at: along, position: [%.9f, 150]}]\n"
                % (200 * (1 + math.tan(TURN) / math.tan(math.radians(30)))))
        document = self.solved(text=text)
        self.assertEqual(document["diagnostics"], [])
        self.assertAlmostEqual(math.degrees(document["parameters"][0]["value"]), 20, 6)
        (self.folder / "marks.yml").write_text(text.replace("[1, 0, 1]", "[-1, 0, 1]"))
        self.refused("solve", "photo.cam", "--with", "marks.yml", code=1,
                     says="the marks 'left' and 'right' are at one place",
                     helps="write two marks that are apart")

    def test_numbers_that_a_lens_is_made_of(self):
        """Those of OpenCV's models cannot be inputs; the corners are exact."""
        (self.folder / "lens.cam").write_text(
            "camera photo(fx = 500, k1 = 0) {\n    eye opencv_pinhole(width = 640, height = 480, "
            "fx = fx, cx = 319.5, cy = 239.5, k1 = k1)\n}\n")
        rows = []
        for i in range(12):
            x, y = 0.2 * (i % 4) - 0.3, 0.2 * (i // 4) - 0.2
            far = 1 - 0.1 * (x * x + y * y)
            rows.append((f"p{i}", (1, -x, -y), (319.5 + 620 * x * far, 239.5 + 620 * y * far)))
        (self.folder / "marks.yml").write_text(
            "size: [640, 480]\norigin: pixel_center\nunknowns: [fx, k1]\nmarks:\n" +
            "".join(f"  {name}: [{p[0]}, {p[1]}, {p[2]}]\n" for name, p, _ in rows) +
            "constraints:\n" + "".join(f"  - {{at: {name}, position: [{x!r}, {y!r}]}}\n"
                                       for name, _, (x, y) in rows))
        named = (self.folder / "marks.yml").read_text()
        (self.folder / "marks.yml").write_text(named.replace("unknowns: [fx, k1]\n", ""))
        self.refused("solve", "lens.cam", "--with", "marks.yml", code=1,
                     says="no parameter of the camera 'photo' can be an input of its formulas",
                     helps="unknowns: [fx]")
        (self.folder / "marks.yml").write_text(named)
        document = self.json_of("solve", "lens.cam", "--with", "marks.yml", "-o", "solved.cam")
        self.assertAlmostEqual(document["parameters"][0]["value"], 620, 5)
        self.assertAlmostEqual(document["parameters"][1]["value"], -0.1, 7)
        self.assertIn(document["parameters"][1]["written"],
                      (self.folder / "solved.cam").read_text())
        (self.folder / "marks.yml").write_text(
            "size: [640, 480]\nunknowns: [spot]\nmarks: {p: [1, 0, 0]}\n"
            "constraints: [{at: p, position: [1, 2]}]\n")
        (self.folder / "lens.cam").write_text(
            "camera photo(spot = (1, 2, 3)) {\n    map u = 1 .. -1, v = square\n    eye point(spot)\n"
            "    toward plane((1, 0, 0))\n}\n")
        self.refused("solve", "lens.cam", "--with", "marks.yml", code=1,
                     says="the parameter 'spot' cannot be found, since it is not one number")

    def test_drawings(self):
        self.run_command("solve", "photo.cam", "--with", "marks.yml", "--drawing", "misses.svg")
        svg = (self.folder / "misses.svg").read_text()
        self.assertEqual(svg.count('class="mark"'), 3)
        self.assertEqual(svg.count('class="miss"'), 3)
        self.assertIn(">gable</text>", svg)
        self.run_command("render", "scene.obj", "--camera", "photo.cam", "--size", "400x300", "-s",
                         "1", "-o", "photo.png")
        self.run_command("solve", "photo.cam", "--with", "marks.yml", "--drawing", "over.png",
                         "--over", "photo.png")
        self.assertTrue((self.folder / "over.png").read_bytes().startswith(b"\x89PNG"))
        self.run_command("solve", "photo.cam", "--with", "marks.yml", "--uncertainty", "map.png")
        self.assertTrue((self.folder / "map.png").read_bytes().startswith(b"\x89PNG"))
        self.refused("solve", "photo.cam", "--with", "marks.yml", "--uncertainty", "map.svg",
                     code=2, says="the file extension of 'map.svg' is not that of a picture")
        self.refused("solve", "photo.cam", "--with", "marks.yml", "--drawing", "over.svg", "--over",
                     "photo.png", code=2, says="'over.svg' has no pixels")
        self.refused("solve", "photo.cam", "--with", "marks.yml", "--over", "photo.png", code=2,
                     says="there is no drawing to put over a picture")
        (self.folder / "marks.yml").write_text(marks(size="[401, 300]"))
        self.refused("solve", "photo.cam", "--with", "marks.yml", "--drawing", "over.png", "--over",
                     "photo.png", code=1, says="'photo.png' has 400 x 300 pixels")

    def test_mistakes_have_a_place(self):
        def refused(text, says, place):
            (self.folder / "marks.yml").write_text(text)
            self.refused("solve", "photo.cam", "--with", "marks.yml", code=1, says=says)
            self.refused("solve", "photo.cam", "--with", "marks.yml", code=1, says=place)

        refused(marks(unknowns="[fob]"), "the camera 'photo' has no parameter 'fob'",
                "marks.yml:2:12")
        refused(marks(unknowns="{fov: {start: 50}}"), "'fov' is an angle, but this is a plain",
                "marks.yml:2:25")
        refused(marks(unknowns="{px: {start: 1deg}}"), "'px' is a plain number, but this is an",
                "marks.yml:2:24")
        refused(marks(unknowns="{fov: {start: 9deg}}"),
                "the search for 'fov' begins at 9deg, outside its range", "marks.yml:2:25")
        refused(marks(fixed="[yaw]"), "'yaw' is both unknown and fixed", "marks.yml:")
        refused(marks(unknowns="[yaw]", constraints="[{at: door, position: [1, 2]}]",
                      marks="{door: {point: [-10, 0, 0]}, level: [10, 0, 0]}",
                      axes="y_down"), "there are no axes 'y_down'", "marks.yml:5:7")
        refused(marks(constraints="[{level: [door, back]}]", marks="{door: [10, 0, 0], back: "
                      "[-10, 0, 0]}"), "no ray of the first values meets the mark 'back'",
                "marks.yml:3:27")

    def test_doubts_are_warnings(self):
        def said(text):
            return [one["message"] for one in self.solved(text=text)["diagnostics"]]

        self.assertEqual(said(marks(unknowns="[px]", constraints="[{level: [door, door]}]")),
                         ["the constraints do not determine 'px'"])
        (missed, *_) = said(marks(unknowns="[yaw]"))
        self.assertRegex(missed, r"^'at gable' is missed by \d+\.\d standard deviations")
        wrong = said(marks() + "  - {length: [door, gable], value: 90}\n")
        self.assertEqual(wrong, ["'length door, gable' contradicts the other constraints, which "
                                 "can be met without it"])
        few = said(marks(unknowns="[fov, yaw, px]", constraints="[{at: door, position: [1, 2]}]"))
        self.assertEqual(few[:2], [
            "the constraints are 2 equations, too few for 3 unknown numbers",
            "the constraints do not determine 'fov', 'yaw' and 'px'"])
        self.assertEqual(self.solved()["covariance"], 3 * [3 * [None]])

    def test_outputs(self):
        self.refused("solve", "photo.cam", "--with", "marks.yml", "-o", "photo.cam", code=2,
                     says="photo.cam")
        self.refused("solve", "photo.cam", "--with", "marks.yml", "-o", "solved.txt", code=2,
                     says="the file extension of 'solved.txt' is not that of a camera file")
        self.refused("solve", "photo.cam", "--with", "none.yml", code=1,
                     says="there is no file 'none.yml'")
        self.assertEqual((self.folder / "photo.cam").read_text(), CAMERA)

    def test_says_which_constraint_is_on_a_mark_that_is_not_seen(self):
        text = marks(constraints="[{at: door, position: [155, 147]}, {at: back, position: [9, 9]}]",
                     marks="{door: [10, 0, 0], back: [-10, 0, 0]}")
        (self.folder / "marks.yml").write_text(text)
        out, err = self.run_command("solve", "photo.cam", "--with", "marks.yml")
        self.assertIn("the camera that was found does not show the mark 'back'", err)
        self.assertIn("marks.yml:4:50: note: a constraint on it", err)
        self.assertNotIn("'at back' is missed", err)
        self.assertRegex(out, r"at back +not seen")


if __name__ == "__main__":
    support.main()
