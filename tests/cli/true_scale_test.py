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
