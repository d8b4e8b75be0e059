# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Several scenes, standard output, and the formats of pictures."""

import support

SMALL = ("--size", "8x6", "-s", "1")


class Outputs(support.CommandTest):
    def test_formats_have_their_signatures(self):
        for name, signature in (("p.jpg", b"\xff\xd8\xff"), ("p.JPEG", b"\xff\xd8\xff"),
                                ("p.webp", b"RIFF"), ("p.tif", b"II*\0"), ("p.tiff", b"II*\0")):
            self.run_command("render", "scene.obj", *SMALL, "-o", name)
            self.assertTrue((self.folder / name).read_bytes().startswith(signature), name)
        self.refused("render", "scene.obj", "-o", "p.bmp", code=2, says="not a picture format",
                     helps=".png, .jpg, .jpeg, .webp, .tif, .tiff, or .exr")
        self.refused("render", "scene.obj", "--size", "20000x2", "-o", "p.webp", code=2,
                     says="at most 16383 pixels")

    def test_jpeg_says_that_it_loses_transparency(self):
        _, err = self.run_command("render", "scene.obj", *SMALL, "-c", "my.cam:above", "-o", "p.jpg",
                                  "--background", "transparent")
        self.assertIn("has no transparency", err)
        self.assertIn("--background", err)
        _, err = self.run_command("render", "scene.obj", *SMALL, "-c", "my.cam:above", "-o", "p.jpg",
                                  "--background", "white")
        self.assertEqual(err, "")

    def test_standard_output_is_a_png(self):
        self.run_command("render", "scene.obj", *SMALL, "-o", "p.png")
        with self.start("render", "scene.obj", *SMALL, "-o", "-") as process:
            out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0)
        self.assertEqual(out, (self.folder / "p.png").read_bytes())
        self.assertIn(b"standard output: 8 x 6 pixels", err)
        said = self.json_of("render", "scene.obj", "-o", "-", code=2)["diagnostics"]
        self.assertIn("exclude each other", said[0]["message"])
        with open("/dev/full", "wb") as full:
            self.run_command("render", "scene.obj", *SMALL, "-o", "-", code=3, stdout=full)

    def test_several_scenes(self):
        out, _ = self.run_command("render", "scene.obj", "room.glb", *SMALL)
        self.assertIn("scene.png: 8 x 6", out)
        self.assertIn("room.png: 8 x 6", out)
        (self.folder / "pictures").mkdir()
        self.run_command("render", "*.obj", "r*.glb", *SMALL, "-o", "pictures/{scene}-8.webp")
        self.assertEqual(sorted(path.name for path in (self.folder / "pictures").iterdir()),
                         ["room-8.webp", "scene-8.webp"])
        self.refused("render", "scene.obj", "room.glb", "-o", "p.png", code=2,
                     says="would both be 'p.png'", helps="{scene}")
        self.refused("render", "scene.obj", "./scene.obj", code=2, says="would both be")
        self.refused("render", "lost*.obj", code=1, says="there is no file 'lost*.obj'")

    def test_a_scene_that_fails_does_not_stop_the_others(self):
        (self.folder / "bad.obj").write_text("nothing")
        out, err = self.run_command("render", "bad.obj", "scene.obj", *SMALL, code=1)
        self.assertIn("nothing to render in 'bad.obj'", err)
        self.assertIn("scene.png: 8 x 6", out)
        out, _ = self.run_command("render", "bad.obj", "scene.obj", *SMALL, "--json", code=1)
        bad, good = support.json.loads(out)["pictures"]
        self.assertEqual((bad["scene"], good["scene"]), ("bad.obj", "scene.obj"))
        self.assertEqual(bad["diagnostics"][0]["severity"], "error")
        self.assertEqual(good["output"], "scene.png")


if __name__ == "__main__":
    support.main()
