# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The light that render adds to a scene: environments, skies, and what it chooses by itself."""

import json

import support


def hdr(width, height, rgbe):
    """A Radiance picture of one colour, without compression."""
    header = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n"
    return header.encode() + bytes(rgbe) * (width * height)


class Light(support.CommandTest):
    def facts(self, *words, code=0):
        out, _ = self.run_command("render", "scene.obj", "--size", "16x16", "--samples", "1",
                                  "--integrator", "path", "-o", "p.png", "--json", *words, code=code)
        return json.loads(out)

    def refuses(self, option, *values):
        for value in values:
            with self.subTest(option=option, value=value):
                self.refused("render", "scene.obj", f"{option}={value}", "-o", "p.png", code=2,
                             says=option)

    def test_numbers_out_of_range(self):
        self.refuses("--environment-rotation", "nan", "inf", "left", "1e9")
        self.refuses("--environment-strength", "-1", "nan", "1e39", "bright")
        self.refuses("--sun-angle", "-1", "181", "nan", "wide")
        self.refuses("--environment", "sky:elevation", "sky:elevation=high", "sky:height=3",
                     "sky:elevation=91", "sky:turbidity=0", "sky:turbidity=11", "sky:azimuth=nan")

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
                                  "-o", "p.png")
        self.assertIn("lit by a sky without sun", out)

    def test_the_environment_is_the_background_unless_it_is_hidden(self):
        for words, share in (((), 1.0), (("--background", "auto"), 1.0)):
            self.facts(*words)
            self.assertEqual(share, support.opaque_share(self.folder / "p.png"))
        self.facts("--background", "transparent", "--environment", "sky")
        self.assertLess(support.opaque_share(self.folder / "p.png"), 1.0)

    def test_files(self):
        (self.folder / "meadow.hdr").write_bytes(hdr(4, 2, (128, 128, 128, 129)))
        facts = self.facts("--environment", "meadow.hdr", "--environment-rotation", "90deg",
                           "--environment-strength", "2")
        self.assertIn("meadow.hdr", facts["light"])
        self.assertEqual([], facts["diagnostics"])
        self.refused("render", "scene.obj", "--environment", "nowhere.hdr", "-o", "q.png", code=1,
                     says="nowhere.hdr")
        (self.folder / "text.exr").write_bytes(b"no picture")
        self.refused("render", "scene.obj", "--environment", "text.exr", "-o", "q.png", code=1,
                     says="text.exr")
        (self.folder / "black.hdr").write_bytes(hdr(4, 2, (0, 0, 0, 0)))
        facts = self.facts("--environment", "black.hdr")
        self.assertIn("black", facts["diagnostics"][0]["message"])
        self.assertNotIn("q.png", self.files())


if __name__ == "__main__":
    support.main()
