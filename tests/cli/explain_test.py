# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony explain: a camera in words and formulas."""

import support


class Explain(support.CommandTest):
    def test_words_and_formulas(self):
        out, err = self.run_command("explain", "my.cam:above", "--set", "size=2")
        self.assertEqual(err, "")
        self.assertIn("above: Rays start", out)
        self.assertIn("size = 2\n", out)
        self.assertRegex(out, r"\n    map     u = ")
        self.assertRegex(out, r"\norigin_x = ")

    def test_what_has_the_name_of_a_stage_and_is_none(self):
        (self.folder / "names.cam").write_text("""let line = (0, 0, 1)
camera names {
    map  u = 180deg .. -180deg, v = -60deg .. 60deg
    eye  product(superellipse(1, 1, 1/4, by = arc_length), arc_length(circle, to = 360deg))
    move translate(line), repeat(2, scale(2))
    look blend(normal(inward), along(-z), weight(u, v) = [v])
}
camera choice {
    map  u = 180deg .. -180deg, v = -60deg .. 60deg
    eye  product(circle, superellipse(1, 1, 1/4, by = arc_length))
}
""")
        steps = {step["statement"]: [said.split(":")[0] for said in step["meanings"]]
                 for step in self.json_of("explain", "names.cam:names")["steps"]}
        self.assertEqual(steps["eye"], ["product", "superellipse", "arc_length", "circle"])
        self.assertEqual(steps["move"], ["translate", "repeat", "scale"])
        self.assertEqual(steps["look"], ["blend", "normal", "along"])
        self.assertNotIn("arc_length:", self.run_command("explain", "names.cam:choice")[0])

    def test_intermediate_values_are_named_by_stage(self):
        out = self.run_command("explain", "superelliptic", "--set", "pz=1")[0]
        for line in ("u = x * ", "eye_1 = ", "look_1 = ", "origin_x = "):
            self.assertIn(f"\n{line}", out)
        # Both curves belong to the eye object.
        self.assertNotRegex(out, r"\ns[0-9]+ = .*lookup")
        self.assertIn("let half_width = tan(fov/2)\n", self.run_command("explain", "pinhole")[0])

    def test_json(self):
        document = self.json_of("explain", "pinhole", "--size", "100x50")
        self.assertEqual(document["camera"], "pinhole")
        self.assertEqual([step["statement"] for step in document["steps"]][:2], ["map", "eye"])
        self.assertIn("direction_z = ", document["formulas"])
        self.assertEqual(document["definitions"], ["half_width = tan(fov/2)"])

    def test_pictures(self):
        (self.folder / "poster.cam").write_text(
            'import "my.cam"\n'
            "picture pair { layer above(size = 2) layer half { clip ellipse frame } }\n"
            "picture poster(width = 2) 300 x 200 {\n"
            "    layer pair\n"
            "    layer above(size = width) { place (0, 0) .. (1/2, 1/2) }\n"
            "    layer above(size = 1)\n"
            "    layer pair\n"
            "}\n")
        out, err = self.run_command("explain", "poster.cam")
        self.assertEqual(err, "")
        self.assertTrue(out.startswith("poster: A picture of 300 x 200 pixels in 4 layers.\n"
                                       "    width = 2\n"), out)
        # Each layer where it stands; a picture in the picture is further in, and said once.
        self.assertRegex(out, r"\n    1  pair\n +A picture in 2 layers.*\n\n +1\.1  above")
        self.assertRegex(out, r"\n    4  pair\n +the picture of layer 1 again\n")
        self.assertEqual(out.count("ellipse:"), 1)
        # Each camera once for the same parameters.
        self.assertIn("\nabove, layers 1.1, 2: Rays start", out)
        self.assertIn("\nabove, layer 3: Rays start", out)
        self.assertEqual(out.count("\nhalf, "), 1)
        # Formulas of every layer.
        for name in ("layer_1_1_origin_x", "layer_1_2_frame_coverage", "layer_2_coverage",
                     "layer_4_2_valid"):
            self.assertEqual(out.count(f"\n{name} = "), 1, name)

    def test_picture_as_json(self):
        (self.folder / "two.cam").write_text(
            'import "my.cam"\npicture two { layer half layer above(size = 9) { alpha 0.5 } }\n')
        document = self.json_of("explain", "two.cam")
        self.assertEqual(document["picture"], "two")
        self.assertEqual([layer["written"] for layer in document["layers"]],
                         ["half", "above(size = 9)"])
        self.assertEqual(document["layers"][1]["steps"][0]["statement"], "alpha")
        shown = document["shown"][document["layers"][1]["shows"]]
        self.assertEqual((shown["camera"], shown["parameters"][0]["value"]), ("above", "9"))
        self.assertEqual(document["width"] / document["height"], 16 / 9)

    def test_mistakes(self):
        self.refused("explain", "none.cam", code=1, says="'none.cam'")
        self.refused("explain", "my.cam:closup", code=1, says="'closup'", helps="closeup")
        self.refused("explain", "pinhole", "--size", "big", code=2, says="--size")
        self.refused("explain", "pinhole", "--set", "gamma", code=1, says="--set gamma")


if __name__ == "__main__":
    support.main()
