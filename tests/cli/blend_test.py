# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""balcony blend: meshes and masks of projectors on a dome."""

import support

# Two projectors at the rim of a dome of radius 5, as an eye in its centre sees their light.
DOME = """camera beam(side = 1) {
    let half_width = tan(38deg)
    map    u = half_width .. -half_width, v = square
    eye    point(0, 0, 0)
    toward {
        object plane((1, 0, 0))
        move   rotate(y, -35deg), rotate(z, -side*55deg), translate(0, 4*side, 0),
               project((0, 4*side, 0), onto = sphere(5))
    }
}
camera left { morph beam(side = 1) .. beam(side = 1), amount = 0 }
camera right { morph beam(side = -1) .. beam(side = -1), amount = 0 }
"""


class Blend(support.CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "dome.cam").write_text(DOME)
        (self.folder / "out").mkdir()

    def mesh(self, name):
        lines = (self.folder / "out" / name).read_text().splitlines()
        self.assertEqual(lines[0], "2")
        columns, rows = map(int, lines[1].split())
        nodes = [tuple(map(float, line.split())) for line in lines[2:]]
        self.assertEqual(len(nodes), columns * rows)
        return columns, rows, nodes

    def mask(self, name):
        rows = support.png_pixels(self.folder / "out" / name, (16, 2))[2]
        return [[256 * pixel[0] + pixel[1] for pixel in row] for row in rows]

    def test_meshes_and_masks(self):
        words = ("blend", "dome.cam:left", "dome.cam:right", "--from", "fulldome", "--size",
                 "80x60", "-o", "out", "--columns", "17")
        out, err = self.run_command(*words)
        self.assertEqual(err, "")
        self.assertRegex(out, r"^out/left.data and out/left.png, \d+ of 4800 pixels blended\n")
        columns, rows, nodes = self.mesh("left.data")
        self.assertEqual((columns, rows), (17, 13))
        self.assertAlmostEqual(nodes[0][0], -80 / 60)
        # The meshes mirror each other, as the projectors do.
        for number, (x, y, u, v, i) in enumerate(nodes):
            row, column = divmod(number, columns)
            other = self.mesh("right.data")[2][row * columns + columns - 1 - column]
            if min(i, other[4]) < 0:
                continue
            self.assertEqual(i, 1)
            for here, there in ((x, -other[0]), (y, other[1]), (u, 1 - other[2]), (v, other[3])):
                self.assertAlmostEqual(here, there, 6)
        # The masks, too, which fall towards the side of the other.
        left, right = self.mask("left.png"), self.mask("right.png")
        self.assertEqual((len(left), len(left[0])), (60, 80))
        for one, other in zip(left, right, strict=True):
            for here, there in zip(one, reversed(other), strict=True):
                self.assertLessEqual(abs(here - there), 1)
        self.assertLess(left[30][5], left[30][40])
        self.assertEqual(left[30][75], 65535)

    def test_masks_are_for_a_projector_of_a_gamma(self):
        words = ("blend", "dome.cam:left", "dome.cam:right", "--from", "fulldome", "--size", "40x30",
                 "-o", "out", "--gamma")
        self.run_command(*words, "1")
        linear = self.mask("left.png")
        out, _ = self.run_command(*words, "2")
        for shares, levels in zip(linear, self.mask("left.png"), strict=True):
            for share, level in zip(shares, levels, strict=True):
                self.assertAlmostEqual((level / 65535) ** 2, share / 65535, delta=1e-4)
        blended = sum(0 < share < 65535 for shares in linear for share in shares)
        self.assertIn(f"left.png, {blended} of 1200 pixels blended", out)

    def test_one_file_for_each(self):
        words = ("blend", "dome.cam:left", "dome.cam:right", "--from", "fulldome", "--size", "40x30",
                 "-o", "out", "--only-mesh")
        self.run_command(*words)
        self.assertEqual(sorted(file.name for file in (self.folder / "out").iterdir()),
                         ["left.data", "right.data"])
        shares = {node[4] for node in self.mesh("left.data")[2]}
        self.assertTrue(any(0 < share < 1 for share in shares))
        document = self.json_of(*words)
        self.assertEqual([one["camera"] for one in document["projectors"]], ["left", "right"])

    def test_refusals(self):
        words = ("--from", "fulldome", "--size", "40x30", "-o", "out")
        self.refused("blend", "dome.cam:left", "dome.cam:left", *words, code=2,
                     says="two projectors have the name 'left'")
        self.refused("blend", "dome.cam:left", "dome.cam:right", *words[:-1], "none", code=3,
                     says="there is no folder")
        (self.folder / "apart.cam").write_text(
            "camera a { morph pinhole(px = 1) .. pinhole(px = 1), amount = 0 }\n")
        self.refused("blend", "dome.cam:left", "apart.cam:a", *words, code=1,
                     says="see from different places", helps="project(projector")
        self.refused("blend", "--from", "fulldome", "-o", "out", code=2, says="CAMERA")
        self.assertEqual(list((self.folder / "out").iterdir()), [])


if __name__ == "__main__":
    support.main()
