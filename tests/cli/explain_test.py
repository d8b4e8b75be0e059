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

    def test_json(self):
        document = self.json_of("explain", "pinhole", "--size", "100x50")
        self.assertEqual(document["camera"], "pinhole")
        self.assertEqual([step["statement"] for step in document["steps"]][:2], ["map", "eye"])
        self.assertIn("direction_z = ", document["formulas"])

    def test_mistakes(self):
        self.refused("explain", "none.cam", code=1, says="'none.cam'")
        self.refused("explain", "my.cam:closup", code=1, says="'closup'", helps="closeup")
        self.refused("explain", "pinhole", "--size", "big", code=2, says="--size")
        self.refused("explain", "pinhole", "--set", "gamma", code=1, says="--set gamma")


if __name__ == "__main__":
    support.main()
