# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Several scenes, standard output, and the formats of pictures."""

import struct

import support

SMALL = ("--size", "8x6", "-s", "1")


def tiff_tags(data):
    """The numbers of the first directory of a little-endian TIFF file."""
    (at,) = struct.unpack_from("<I", data, 4)
    (count,) = struct.unpack_from("<H", data, at)
    tags = {}
    for i in range(count):
        tag, kind, _, place = struct.unpack_from("<HHII", data, at + 2 + 12 * i)
        if kind == 5:
            part, whole = struct.unpack_from("<II", data, place)
            tags[tag] = part / whole
        else:
            tags[tag] = place & 0xffff if kind == 3 else place
    return tags


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

    def test_dpi(self):
        """The resolution of the print is where each format keeps it."""
        def written(name, *words):
            self.run_command("render", "scene.obj", *SMALL, *words, "-o", name)
            return (self.folder / name).read_bytes()

        for dpi in (72, 300, 84.67):
            words = ("--dpi", str(dpi))
            png = written("p.png", *words)
            at = png.index(b"pHYs") + 4
            # Whole pixels per metre.
            per_metre = round(dpi / 0.0254)
            self.assertEqual(struct.unpack_from(">IIB", png, at), (per_metre, per_metre, 1))
            jpeg = written("p.jpg", *words)
            self.assertEqual(jpeg[6:11], b"JFIF\0")
            # Whole pixels per inch.
            self.assertEqual(struct.unpack_from(">BHH", jpeg, 13), (1, round(dpi), round(dpi)))
            tags = tiff_tags(written("p.tif", *words))
            self.assertEqual(tags[296], 2)
            for tag in (282, 283):
                self.assertAlmostEqual(tags[tag], dpi, delta=1e-5 * dpi)
        # Whole pixels per centimetre are nearer.
        self.assertEqual(struct.unpack_from(">BHH", written("p.jpg", "--dpi", "12.7"), 13), (2, 5, 5))
        self.assertNotIn(b"pHYs", written("p.png"))
        for name in ("p.webp", "p.exr"):
            self.refused("render", "scene.obj", "--dpi", "300", "-o", name, code=2,
                         says="--dpi", helps=".tif")

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
