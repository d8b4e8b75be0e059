# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Pictures at true scale: --mm-per-pixel, --unit, and the axes that cameras are fitted to."""

import math
import struct

import support

TILT = math.radians(7)
MIDDLE = (130.0, -60.0, 15.0)


def leaning(x, y, z):
    """A point of an upright object, leaning towards -y."""
    return (x + MIDDLE[0], y * math.cos(TILT) - z * math.sin(TILT) + MIDDLE[1],
            y * math.sin(TILT) + z * math.cos(TILT) + MIDDLE[2])


def write_ply(path, rows, closed):
    """A grid of (x, y, z, grey), of which neighbours are connected."""
    high, wide = len(rows), len(rows[0])
    quads = [(i * wide + j, i * wide + (j + 1) % wide, (i + 1) * wide + (j + 1) % wide,
              (i + 1) * wide + j)
             for i in range(high - 1) for j in range(wide if closed else wide - 1)]
    head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {high * wide}\n"
            "property float x\nproperty float y\nproperty float z\nproperty uchar red\n"
            "property uchar green\nproperty uchar blue\n"
            f"element face {len(quads)}\nproperty list uchar int vertex_indices\nend_header\n")
    path.write_bytes(head.encode()
                     + b"".join(struct.pack("<fff3B", *point, grey, grey, grey)
                                for row in rows for *point, grey in row)
                     + b"".join(struct.pack("<B4i", 4, *quad) for quad in quads))


def marked(angle, height):
    """Dark where a column of 50 mm has its marks: 90 degrees and 40 mm apart."""
    stripe = abs(angle - 60) < 2 or abs(angle - 150) < 2
    ring = abs(height - 30) < 1.5 or abs(height - 70) < 1.5
    return 10 if stripe or ring else 240


def dark_middles(values):
    """The middles of the runs of dark values, with the parts of pixels at their ends."""
    light = sorted(values)[len(values) // 2]
    darkness = [1 - value / light for value in values]
    middles, run = [], []
    for i, dark in enumerate([*darkness, 0]):
        if dark > 0.1:
            run.append((i + 0.5, dark))
        elif run:
            middles.append(sum(at * dark for at, dark in run) / sum(dark for _, dark in run))
            run = []
    return middles


class TrueScale(support.CommandTest):
    def column(self, first=0, last=360):
        """A column with the radius 50 and the height 100, or a part of the way around it."""
        closed = last - first == 360
        angles = [first + i * 0.5 for i in range(2 * (last - first) + (0 if closed else 1))]
        rows = [[(*leaning(50 * math.cos(math.radians(a)), 50 * math.sin(math.radians(a)), z / 2),
                  marked(a, z / 2)) for a in angles] for z in range(201)]
        write_ply(self.folder / "column.ply", rows, closed)

    def rollout(self, *words, camera="rollout"):
        facts = self.json_of("render", "column.ply", "--camera", camera, "--unit", "mm",
                             "--mm-per-pixel", "0.5", "--samples", "4", "--exposure", "0",
                             "--integrator", "direct",
                             "-o", "out.png", *words)
        width, height, rows = support.png_pixels(self.folder / "out.png")
        return facts, width, height, [[pixel[0] for pixel in row] for row in rows]

    def test_a_leaning_column_is_straight_and_to_scale(self):
        self.column()
        facts, width, height, rows = self.rollout()
        fitted = {one["name"]: one["value"] for one in facts["fitted"]}
        # The sides of the column leave the cylinder by 50*(1 - cos(0.25 deg)) = 0.0005.
        self.assertAlmostEqual(fitted["tilt"], 7, delta=0.01)
        self.assertAlmostEqual(fitted["tilt_toward"], -90, delta=0.1)
        self.assertAlmostEqual(fitted["radius"], 50, delta=0.01)
        self.assertAlmostEqual(fitted["height"], 100, delta=0.02)
        self.assertEqual((width, height), (round(2 * math.pi * 50 / 0.5), 200))
        self.assertEqual(facts["mm_per_pixel"], 0.5)
        # Rounding the sides to pixels changes lengths by a half in 628 and in 200, the marks are in
        # steps of 0.44 mm and 0.5 mm on the surface, and those of one kind are alike.
        first, last = dark_middles(rows[20])
        self.assertAlmostEqual(0.5 * (last - first), math.pi / 2 * 50, delta=0.2)
        upper, lower = dark_middles([row[300] for row in rows])
        self.assertAlmostEqual(0.5 * (lower - upper), 40, delta=0.2)
        # Straight: the rings are level all around.
        for column in (100, 450, 560):
            for one, other in zip(dark_middles([row[column] for row in rows]), (upper, lower),
                                  strict=True):
                self.assertAlmostEqual(one, other, delta=0.2)

    def test_a_fragment_fills_the_strip(self):
        self.column(30, 130)
        facts, width, _, rows = self.rollout()
        fitted = {one["name"]: one["value"] for one in facts["fitted"]}
        self.assertAlmostEqual(fitted["width"], 100, delta=0.05)
        self.assertAlmostEqual(fitted["radius"], 50, delta=0.05)
        self.assertAlmostEqual(width, math.radians(100) * 50 / 0.5, delta=1)
        # From one edge to the other: the mark is 30 degrees from the left one.
        (mark,) = dark_middles(rows[20])
        self.assertAlmostEqual(0.5 * mark, math.radians(30) * 50, delta=0.5)

    def test_a_mural_is_unrolled_around_its_bend(self):
        self.column(30, 130)
        facts, width, height, rows = self.rollout(camera="cylinder")
        fitted = {one["name"]: one["value"] for one in facts["fitted"]}
        self.assertAlmostEqual(fitted["yaw"], 80, delta=0.1)
        self.assertAlmostEqual(fitted["tilt"], 7, delta=0.05)
        self.assertAlmostEqual(width, math.radians(100) * 50 / 0.5, delta=1)
        self.assertAlmostEqual(height, 200, delta=1)
        # From inside, the mark is 70 degrees from the left edge.
        (mark,) = dark_middles(rows[20])
        self.assertAlmostEqual(0.5 * mark, math.radians(70) * 50, delta=0.5)

    def test_the_file_says_the_size_of_the_print(self):
        self.column()
        self.rollout("--scale", "50%")
        data = (self.folder / "out.png").read_bytes()
        # A millimetre in a pixel.
        self.assertEqual(struct.unpack_from(">IIB", data, data.index(b"pHYs") + 4), (1000, 1000, 1))
        out, _ = self.run_command("render", "column.ply", "--camera", "rollout", "--unit", "cm",
                                  "--mm-per-pixel", "20", "--samples", "1", "-o", "out.png")
        self.assertIn("  20 mm per pixel: 3140 x 1000 mm\n", out)

    def test_check_says_how_true_the_scale_is(self):
        self.column()
        words = ("check", "rollout", "--scene", "column.ply", "--width", "628")
        scale = self.json_of(*words, "--unit", "mm")["files"][0]["reports"][0]["in_scene"]["scale"]
        self.assertEqual(scale["unit"], "mm")
        self.assertAlmostEqual(scale["nominal"], 2 * math.pi * 50 / 628, delta=1e-4)
        for axis in ("x", "y"):
            for value in scale[axis].values():
                # Chords of the grid's steps are shorter than arcs by less than a thousandth.
                self.assertAlmostEqual(value, 0.5, delta=0.002)
        # Twice as true with half the radius.
        halved = self.json_of(*words, "--set", "radius=25", "--set", "distance=35")
        scale = halved["files"][0]["reports"][0]["in_scene"]["scale"]
        self.assertEqual(scale["unit"], "units")
        self.assertAlmostEqual(scale["x"]["median"], 2 * scale["nominal"], delta=0.002)
        out, _ = self.run_command(*words, "--unit", "mm")
        self.assertRegex(out, r"\n  scale +0\.5003 mm per pixel; on the surface in x 0\.\d+ to")
        out, _ = self.run_command("check", "panorama", "--scene", "column.ply")
        self.assertNotIn("\n  scale ", out)

    def test_a_map_shows_where_the_scale_errs(self):
        # A cone of the radius 30 in the middle, which widens upwards.
        rows = [[((30 + z / 5) * math.cos(a / 40), (30 + z / 5) * math.sin(a / 40), z, 200)
                 for a in range(252)] for z in range(-50, 51, 2)]
        write_ply(self.folder / "cone.ply", rows, True)
        self.run_command("check", "rollout", "--scene", "cone.ply", "--width", "600", "--set",
                         "radius=30", "--set", "tilt=0deg", "--set", "distance=30",
                         "--map", "scale", "scale.png")
        _, _, rows = support.png_pixels(self.folder / "scale.png", (8, 2))
        # Zero is the middle colour; below the middle the surface is smaller, which is darker.
        x = len(rows[0]) // 2
        bright = [sum(row[x]) for row in rows]
        strip = next(y for y, value in enumerate(bright) if value == 3 * 255)
        self.assertGreater(bright[strip // 8], bright[strip // 2])
        self.assertGreater(bright[strip // 2], bright[strip * 7 // 8])

    def test_plans_and_elevations_are_to_scale(self):
        facts = self.json_of("render", "room.glb", "--camera", "orthographic", "--set", "width=4",
                             "--set", "height=3", "--mm-per-pixel", "50", "--samples", "1",
                             "-o", "plan.png")
        self.assertEqual((facts["width"], facts["height"]), (80, 60))
        scale = self.json_of("check", "orthographic", "--scene", "room.glb", "--set", "width=4",
                             "--width", "80")["files"][0]["reports"][0]["in_scene"]["scale"]
        self.assertAlmostEqual(scale["nominal"], 50)
        # The same pictures as of a camera without a height.
        for width, height in ((24, 14), (200, 113), (1464, 824)):
            for side in ("3", "3.7", "0.0231"):
                out = self.json_of("check", "orthographic", "--set", f"width={side}", "--width",
                                   str(width))["files"][0]["reports"][0]
                self.assertEqual(out["height"], height)

    def test_a_scale_bar_has_its_length(self):
        write_ply(self.folder / "column.ply",
                  [[(*leaning(50 * math.cos(a / 20), 50 * math.sin(a / 20), z), 240)
                    for a in range(126)] for z in (0, 100)], True)
        (self.folder / "sheet.cam").write_text(
            "picture sheet { layer rollout { scale_bar(40, at = (0.1, 0.5), height = 0.1) } }\n")
        _, width, height, rows = self.rollout("--fit", camera="sheet.cam")
        # Its dark quarters are 10 mm long and 20 mm apart.
        middles = dark_middles(rows[height // 2])
        self.assertEqual(len(middles), 2)
        self.assertAlmostEqual(middles[0], 0.1 * width + 10, delta=0.5)
        self.assertAlmostEqual(middles[1] - middles[0], 40, delta=0.2)
        dark = [row[round(middles[0])] < 128 for row in rows]
        self.assertAlmostEqual(sum(dark), 0.1 * height, delta=1)
        (self.folder / "none.cam").write_text("picture none { layer panorama { scale_bar(1) } }\n")
        self.refused("render", "scene.obj", "--camera", "none.cam", "-o", "out.exr", code=1,
                     says="no scale", helps="aspect (WIDTH, HEIGHT)")
        text, _ = self.run_command("explain", "sheet.cam")
        self.assertIn("scale_bar_coverage", text)

    def test_what_has_no_scale_is_refused(self):
        words = ("render", "scene.obj", "-o", "out.png", "--mm-per-pixel")
        self.refused(*words, "1", "--camera", "panorama", "--unit", "m", code=2,
                     says="'panorama' has no scale", helps="aspect (WIDTH, HEIGHT)")
        self.refused(*words, "1", "--camera", "rollout", code=2,
                     says="does not say how long its unit is", helps="--unit mm")
        self.refused(*words, "1", "--camera", "rollout", "--unit", "m", "--size", "10", code=2,
                     says="exclude each other", helps="leave out one")
        self.refused(*words, "1e-4", "--camera", "rollout", "--unit", "km", code=2,
                     says="pixels", helps="is --unit right?")
        self.refused(*words, "1", "--camera", "rollout", "--unit", "furlong", code=2,
                     says="--unit", helps="mm")

    def test_a_camera_of_ones_own_has_the_sides_of_its_aspect(self):
        (self.folder / "own.cam").write_text(
            "camera own { aspect (3, 2) map u = -1.5 .. 1.5, v = -1 .. 1\n"
            "  eye surface(u, v) = [u, v, 9] look along(-z) }\n")
        facts = self.json_of("render", "room.glb", "--camera", "own.cam", "--mm-per-pixel", "100",
                             "--samples", "1", "-o", "out.png")
        self.assertEqual((facts["width"], facts["height"]), (30, 20))


if __name__ == "__main__":
    support.main()
