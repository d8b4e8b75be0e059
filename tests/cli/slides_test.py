# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Slides that look undistorted from a seat: rendered, thrown on the backdrop, seen from the seat."""

import base64
import json
import math
import struct

import support

PROJECTOR, AIM, THROW = (-3.0, 4.0, 3.0), (10.0, 0.0, 0.0), math.radians(34.0)
SQUARES, TEXELS, DARK, LIGHT = 32, 16, 70, 170


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return tuple(x / math.sqrt(dot(a, a)) for x in a)


AHEAD = unit(minus(AIM, PROJECTOR))
RIGHT = unit(cross(AHEAD, (0, 0, 1)))
UP = cross(RIGHT, AHEAD)


def slide_position(point):
    """Where the projector's slide has a point of the backdrop, as fractions from its top left."""
    way = minus(point, PROJECTOR)
    half = math.tan(THROW / 2) * dot(way, AHEAD)
    return 0.5 + 0.5 * dot(way, RIGHT) / half, 0.5 - 0.5 * 1.5 * dot(way, UP) / half


def write_checker(path):
    side = SQUARES * TEXELS
    rows = [bytes(LIGHT if (x // TEXELS + y // TEXELS) % 2 else DARK for x in range(side))
            for y in range(side)]
    support.write_png(path, rows, 1)


def write_scene(path, triangles, image):
    """Triangles of corners ((x, y, z), (s, t)) with z up, which glow with an image."""
    corners = [corner for triangle in triangles for corner in triangle]
    places = [(x, z, -y) for (x, y, z), _ in corners]
    data = (b"".join(struct.pack("<3f", *p) for p in places)
            + b"".join(struct.pack("<2f", *st) for _, st in corners))
    count = len(corners)
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    path.write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1},
                                    "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
                       "doubleSided": True, "extensions": {"KHR_materials_unlit": {}}}],
        "extensionsUsed": ["KHR_materials_unlit"],
        "textures": [{"source": 0, "sampler": 0}], "images": [{"uri": image}],
        "samplers": [{"wrapS": 33071, "wrapT": 33071}],
        "buffers": [{"byteLength": len(data), "uri": uri}],
        "bufferViews": [{"buffer": 0, "byteLength": 12 * count},
                        {"buffer": 0, "byteOffset": 12 * count, "byteLength": 8 * count}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3",
                       "min": [min(p[k] for p in places) for k in range(3)],
                       "max": [max(p[k] for p in places) for k in range(3)]},
                      {"bufferView": 1, "componentType": 5126, "count": count, "type": "VEC2"}]}))


def divided(triangle, parts):
    """Small triangles, on which the slide's position is nearly linear."""
    a, b, c = triangle

    def at(i, k):
        return tuple(p + (q - p) * i / parts + (r - p) * k / parts for p, q, r in zip(a, b, c))

    for i in range(parts):
        for k in range(parts - i):
            yield at(i, k), at(i + 1, k), at(i, k + 1)
            if i + k + 2 <= parts:
                yield at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)


def quad(a, b, d):
    c = tuple(x + y - z for x, y, z in zip(b, d, a))
    return [(a, b, c), (a, c, d)]


def flat():
    turn = math.radians(20.0)
    left = (-7 * math.sin(turn), 7 * math.cos(turn), 0)
    corner = (10 + left[0], left[1], -5)
    return quad(corner, (10 - left[0], -left[1], -5), (*corner[:2], 5)), 40


def curved():
    points = [(2 + 8 * math.cos(a), 8 * math.sin(a))
              for a in (math.radians(50 - i) for i in range(101))]
    return [t for p, q in zip(points, points[1:])
            for z in range(-5, 5) for t in quad((*p, z), (*q, z), (*p, z + 1))], 4


def folded():
    points = [(9, 5), (11, 2), (9, 0), (11, -2), (9, -5)]
    return [t for p, q in zip(points, points[1:]) for t in quad((*p, -5), (*q, -5), (*p, 5))], 24


def mesh():
    points, triangles = [], []
    for line in (support.REPOSITORY / "cameras/data/backdrop.obj").read_text().splitlines():
        words = line.split()
        if words[0] == "v":
            x, y, z = map(float, words[1:])
            points.append((x, -z, y))
        elif words[0] == "f":
            corners = [points[int(word.split("/")[0]) - 1] for word in words[1:]]
            triangles += [(corners[0], p, q) for p, q in zip(corners[1:], corners[2:])]
    return triangles, 4


class Slides(support.CommandTest):
    def rendered(self, scene, camera, size):
        self.run_command("render", scene, "--camera", camera, "--no-fit", "--size", size, "-s", "9",
                         "--integrator", "direct", "--exposure", "0", "--view-transform", "standard",
                         "-o", "out.png", *(["--set", "fov=40deg"] if camera == "pinhole" else []))
        return self.folder / "out.png"

    def test_look_undistorted_on_every_kind_of_backdrop(self):
        write_checker(self.folder / "checker.png")
        world = [((30, 32, -32), (0, 1)), ((30, -32, -32), (1, 1)), ((30, -32, 32), (1, 0)),
                 ((30, 32, 32), (0, 0))]
        write_scene(self.folder / "world.gltf", [world[:3], [world[0], world[2], world[3]]],
                    "checker.png")
        width, height, wanted = support.png_pixels(
            self.rendered("world.gltf", "pinhole", "192x128"))
        for camera, backdrop in (("slide_flat", flat), ("slide_curved", curved),
                                 ("slide_folded", folded), ("slide_mesh", mesh)):
            self.rendered("world.gltf", camera, "600x400").rename(self.folder / "slide.png")
            triangles, parts = backdrop()
            lit = []
            for triangle in (small for large in triangles for small in divided(large, parts)):
                corners = [(p, slide_position(p)) for p in triangle]
                if all(0.02 < s < 0.98 and 0.02 < t < 0.98 for _, (s, t) in corners):
                    lit.append(corners)
            write_scene(self.folder / "stage.gltf", lit, "slide.png")
            _, _, seen = support.png_pixels(self.rendered("stage.gltf", "pinhole", "192x128"))
            errors = []
            for y in range(2, height - 2):
                for x in range(2, width - 2):
                    around = [(wanted[y + j][x + i][0], seen[y + j][x + i][3])
                              for i in range(-2, 3) for j in range(-2, 3)]
                    values = {value for value, _ in around}
                    # Off the edges of the checker and of the slide.
                    if max(values) - min(values) <= 2 and all(a == 255 for _, a in around):
                        errors.append(abs(seen[y][x][0] - wanted[y][x][0]) / 255)
            self.assertGreater(len(errors), 0.25 * width * height, camera)
            self.assertLess(sum(errors) / len(errors), 0.01, camera)

    def test_a_projector_that_misses_the_backdrop_is_an_error(self):
        self.refused("render", "scene.obj", "--camera", "slide_folded", "--set", "aim=(-10, 4, 3)",
                     "-o", "out.png", code=1, says="the backdrop cannot be seen from there",
                     helps="turn the projector")

    def test_corners_of_no_wall_are_an_error(self):
        self.refused("render", "scene.obj", "--camera", "cave_wall", "--set",
                     "upper_left=(1.5, 0.3, 0)", "-o", "out.png", code=1, says="span no plane",
                     helps="the upper left corner")
        self.refused("render", "scene.obj", "--camera", "cave", "--set",
                     "walls=[(2, 1, 0, 2, -1, 0, 2, 0.8, 2)]", "-o", "out.png", code=1,
                     says="not those of a rectangle", helps="in this order")


if __name__ == "__main__":
    support.main()
