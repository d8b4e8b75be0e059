# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Stereo pictures: --stereo and what belongs to it."""

import support

STEREO = """camera an_eye {
    map  u = -1 .. 1, v = square
    eye  surface(u, v) = [u, v, 5]
    toward point(0, 0, -5)
    stereo(side = -1)
}
camera plain {
    map  u = -1 .. 1, v = square
    eye  surface(u, v) = [u, v, 5]
    toward point(0, 0, -5)
}
// Its right eye looks at the scene, and its left eye past it.
camera beside {
    axes y_up
    map  u = -1 .. 1, v = square
    eye  surface(u, v) = [u - 50, v, 5]
    look along(-z)
}
picture mixed { layer plain layer an_eye { place (0, 0) .. (1/2, 1/2) } }
"""
WIDTH, HEIGHT = 64, 32


def middle_of(rows):
    """The mean column of what is not transparent."""
    columns = [x for row in rows for x, pixel in enumerate(row) if pixel[3] > 0]
    return sum(columns) / len(columns)


class Stereo(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "filmed.gltf").write_text(support.gltf_text_with_cameras())
        (self.folder / "stereo.cam").write_text(STEREO)

    def render(self, form, *words, size=(WIDTH, HEIGHT)):
        """The rows of the picture in a form. The triangle is at a distance of 3."""
        self.run_command("render", "filmed.gltf", "--camera", "scene:Front", "--integrator", "direct",
                         "--samples", "1", "--exposure", "0", "--no-dither", "--separation", "0.5",
                         "--convergence", "6", "--size", f"{size[0]}x{size[1]}", "--stereo", form,
                         *words, "-o", f"{form}.png")
        if form == "files":
            return [support.png_pixels(self.folder / f"files.{eye}.png")[2]
                    for eye in ("left", "right")]
        return support.png_pixels(self.folder / f"{form}.png")[2]

    def test_halves_are_the_two_files(self):
        left, right = self.render("files")
        self.assertNotEqual(left, right)
        self.assertEqual(self.render("left"), left)
        self.assertEqual(self.render("right"), right)
        both = self.render("side_by_side", size=(2 * WIDTH, HEIGHT))
        crossed = self.render("cross_eyed", size=(2 * WIDTH, HEIGHT))
        tower = self.render("top_bottom", size=(WIDTH, 2 * HEIGHT))
        # The pixel filter mixes the pixels on both sides of the seam.
        seam = 2
        for y in range(HEIGHT):
            self.assertEqual(both[y][:WIDTH - seam], left[y][:-seam])
            self.assertEqual(both[y][WIDTH + seam:], right[y][seam:])
            self.assertEqual(crossed[y][:WIDTH - seam], right[y][:-seam])
        for y in range(HEIGHT - seam):
            self.assertEqual(tower[y], left[y])
            self.assertEqual(tower[HEIGHT + seam + y], right[seam + y])

    def test_near_things_are_to_the_right_in_the_left_picture(self):
        left, right = self.render("files")
        # On the plane at the distance 6, the eyes see it 0.5 (6/3 - 1) apart, where 32 pixels are 12.
        self.assertAlmostEqual(middle_of(left) - middle_of(right), 0.5 * 32 / 12, delta=0.6)

    def test_an_anaglyph_has_the_channels_of_both(self):
        left, right = self.render("files", "--background", "black", "--view-transform", "standard")
        mixed = self.render("anaglyph_color", "--background", "black")
        self.assertEqual(mixed, [[(a[0], b[1], b[2], 255) for a, b in zip(one, other)]
                                 for one, other in zip(left, right)])
        grey = self.render("anaglyph_grey", "--background", "black")
        self.assertTrue(all(pixel[1] == pixel[2] for row in grey for pixel in row))
        self.render("anaglyph")

    def test_eyes_have_the_size_of_the_picture(self):
        for form, width, height in (("side_by_side", 2, 1), ("top_bottom", 1, 2), ("anaglyph", 1, 1)):
            self.run_command("render", "filmed.gltf", "--camera", "scene:Front", "--stereo", form, "-H",
                             "32", "-s", "1", "-o", "p.png")
            size = support.png_pixels(self.folder / "p.png")[:2]
            self.assertEqual(size, (32 * width // height, 32), form)

    def test_both_files_have_the_exposure_of_the_first(self):
        words = ("render", "room.glb", "scene.obj", "--size", "16x16", "--integrator", "direct",
                 "--ambient", "1000", "--camera", "stereo.cam:beside", "--separation", "100", "-o",
                 "{scene}.png")
        facts = self.json_of(*words, "--stereo", "files")["pictures"]
        self.assertEqual([picture["output"] for picture in facts],
                         ["room.left.png", "room.right.png", "scene.left.png", "scene.right.png"])
        self.assertEqual([picture["exposure"] for picture in facts], [0, 0, 0, 0])
        alone = self.json_of(*words, "--stereo", "right")["pictures"]
        self.assertTrue(all(picture["exposure"] < -5 for picture in alone))

    def test_wrong_words(self):
        for option, values in (("--separation", ("0", "-1", "nan", "wide")),
                               ("--convergence", ("0", "-2", "inf")),
                               ("--baseline", ("fix",)),
                               ("--merge", ("75,60", "60", "60,91", "a,b", "-1,5"))):
            for value in values:
                with self.subTest(option=option, value=value):
                    self.refused("render", "room.glb", "--stereo", "anaglyph", f"{option}={value}", "-o",
                                 "p.png", code=2, says=option)
            self.refused("render", "room.glb", f"{option}={values[0]}", "-o", "p.png", code=2,
                         says=f"{option} needs --stereo")
        self.refused("render", "room.glb", "--stereo", "side-by-side", "-o", "p.png", code=2,
                     says="--stereo", helps="side_by_side")

    def test_wrong_combinations(self):
        for name in ("an_eye", "mixed"):
            self.refused("render", "scene.obj", "--camera", f"stereo.cam:{name}", "--stereo",
                         "anaglyph", "-o", "p.png", code=1, says="is a view of a stereo pair already")
        self.refused("render", "room.glb", "--stereo", "files", "-o", "-", code=2, says="--output -")
        self.refused("render", "room.glb", "--stereo", "files", "--watch", "-o", "p.png", code=2,
                     says="--stereo files makes two")
        self.assertNotIn("p.png", self.files())

    def test_completion(self):
        out, _ = self.run_command("complete", "render", "--stereo", "top")
        self.assertIn("top_bottom", out)


if __name__ == "__main__":
    support.main()
