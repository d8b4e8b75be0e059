# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes three scenes as they come from other programs: an attic, a column and a town.

Usage: elsewhere.py FOLDER

attic.glb is an attic, lit by the sun and the sky through its only window. column.ply is the scan of
a leaning, fluted column on its plinth: a rough and open surface far from the origin, z up, with
colours at its corners and without a lamp. town.gltf is a town of houses, trees and a church, which are
instances of five meshes, without a lamp.
"""

import base64
import json
import math
import random
import struct
import sys
from pathlib import Path


def box(low, high):
    """Corners and quads of a box."""
    corners = [tuple((low, high)[i >> axis & 1][axis] for axis in range(3)) for i in range(8)]
    return corners, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def prism(outline, near, far):
    """Corners and faces of an outline, counterclockwise in x and y, between two z."""
    count = len(outline)
    corners = [(x, y, z) for z in (far, near) for x, y in outline]
    sides = [(i, (i + 1) % count, count + (i + 1) % count, count + i) for i in range(count)]
    return corners, [tuple(range(count))[::-1], tuple(range(count, 2 * count)),
                     *(face[::-1] for face in sides)]


def cone(radius, low, high, top=0.0, sides=10):
    """Corners and faces of the side of a cone about the y axis, with or without a tip."""
    turns = [2 * math.pi * i / sides for i in range(sides)]
    corners = [(r * math.cos(a), y, r * math.sin(a))
               for r, y in ((radius, low), (top, high)) for a in turns]
    following = [(i, (i + 1) % sides) for i in range(sides)]
    return corners, [(i, sides + i, sides + j, j) if top else (i, sides, j) for i, j in following]


class Gltf:
    """A scene in the making: y up, metres, one buffer."""

    def __init__(self):
        self.buffer = bytearray()
        self.json = {"asset": {"version": "2.0", "generator": "elsewhere"}, "scene": 0,
                     "scenes": [{"nodes": []}], "nodes": [], "meshes": [], "materials": [],
                     "accessors": [], "bufferViews": []}

    def add(self, key, value):
        self.json[key].append(value)
        return len(self.json[key]) - 1

    def material(self, color, **more):
        return self.add("materials", {
            "pbrMetallicRoughness": {"baseColorFactor": [*color, 1], "metallicFactor": 0,
                                     "roughnessFactor": 0.8}, "doubleSided": True, **more})

    def mesh(self, *parts):
        """A mesh of parts, each ((corners, faces), material)."""
        return self.add("meshes", {"primitives": [
            {"attributes": {"POSITION": self.positions(*shape)}, "material": material}
            for shape, material in parts]})

    def positions(self, corners, faces):
        flat = [corners[i] for face in faces for k in range(1, len(face) - 1)
                for i in (face[0], face[k], face[k + 1])]
        data = struct.pack(f"<{3 * len(flat)}f", *(number for corner in flat for number in corner))
        view = self.add("bufferViews", {"buffer": 0, "byteOffset": len(self.buffer),
                                        "byteLength": len(data)})
        self.buffer += data
        return self.add("accessors", {
            "bufferView": view, "componentType": 5126, "count": len(flat), "type": "VEC3",
            "min": [min(column) for column in zip(*flat)],
            "max": [max(column) for column in zip(*flat)]})

    def place(self, name, mesh, at=(0, 0, 0), turn=0.0, scale=(1, 1, 1)):
        self.json["scenes"][0]["nodes"].append(self.add("nodes", {
            "name": name, "mesh": mesh, "translation": at, "scale": scale,
            "rotation": [0, math.sin(turn / 2), 0, math.cos(turn / 2)]}))

    def write_glb(self, path):
        self.json["buffers"] = [{"byteLength": len(self.buffer)}]
        text = json.dumps(self.json).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text
        chunks += struct.pack("<I4s", len(self.buffer), b"BIN\0") + self.buffer
        path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)

    def write_gltf(self, path):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.buffer).decode()
        self.json["buffers"] = [{"byteLength": len(self.buffer), "uri": uri}]
        path.write_text(json.dumps(self.json))


def attic():
    scene = Gltf()
    plaster, boards, beam = (scene.material(color) for color in
                             ((0.75, 0.7, 0.6), (0.45, 0.28, 0.14), (0.3, 0.18, 0.1)))
    # The attic is 8 m long (z), 5 m wide (x) and 3.2 m high; the window, 1 m wide, is at z = 4.
    gable = [(-2.5, 0), (2.5, 0), (2.5, 1), (0, 3.2), (-2.5, 1)]
    scene.place("floor", scene.mesh((box((-2.6, -0.1, -4.1), (2.6, 0, 4.1)), boards)))
    scene.place("back wall", scene.mesh((prism(gable, -4, -4.1), plaster)))
    for name, outline in (("left of the window", [(-2.5, 0), (-0.5, 0), (-0.5, 2.76), (-2.5, 1)]),
                          ("right of the window", [(0.5, 0), (2.5, 0), (2.5, 1), (0.5, 2.76)]),
                          ("sill", [(-0.5, 0), (0.5, 0), (0.5, 0.9), (-0.5, 0.9)]),
                          ("lintel", [(-0.5, 2), (0.5, 2), (0.5, 2.76), (0, 3.2), (-0.5, 2.76)])):
        scene.place(name, scene.mesh((prism(outline, 4.1, 4), plaster)))
    for side, name in ((-1, "left"), (1, "right")):
        low, high = sorted((2.5 * side, 2.6 * side))
        scene.place(f"{name} wall", scene.mesh((box((low, 0, -4), (high, 1, 4)), plaster)))
        slope = [(2.6 * side, 0.9), (2.6 * side, 1.1), (0, 3.4), (0, 3.2)]
        scene.place(f"{name} roof", scene.mesh((prism(slope, 4.1, -4.1), boards)))
    tie = scene.mesh((box((-1.9, 2.1, -0.08), (1.9, 2.25, 0.08)), beam))
    for k, z in enumerate((-2.4, -0.8, 0.8, 2.4)):
        scene.place(f"tie beam {k + 1}", tie, (0, 0, z))
    for name, low, high, color in (
            ("trunk", (0.9, 0, 0.4), (1.8, 0.6, 1.0), (0.1, 0.2, 0.45)),
            ("wardrobe", (-2.2, 0, -3.8), (-1.2, 1.7, -3.1), (0.5, 0.32, 0.2)),
            ("chimney", (0.4, 0, -3.2), (1.1, 3, -2.5), (0.5, 0.13, 0.09)),
            ("mattress", (-2.3, 0, 1.2), (-1.3, 0.25, 3.2), (0.65, 0.62, 0.55))):
        scene.place(name, scene.mesh((box(low, high), scene.material(color))))
    scene.place("lampshade", scene.mesh((cone(0.3, 0.6, 0.95, 0.15), scene.material((0.7, 0.2, 0.2)))),
                (1.6, 0, 2.2))
    scene.json["extensionsUsed"] = ["KHR_lights_punctual"]
    scene.json["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "directional", "name": "sun", "color": [1, 0.95, 0.85], "intensity": 5}]}}
    # It shines through the window, down to the floor: the lamp's -z axis is (0.25, -0.35, -0.9).
    scene.json["scenes"][0]["nodes"].append(scene.add("nodes", {
        "name": "sun", "rotation": [-0.1799, -0.1285, 0, 0.9753],
        "extensions": {"KHR_lights_punctual": {"light": 0}}}))
    return scene


def column():
    """The bytes of a PLY file."""
    noise = random.Random(1)
    around, along, lean = 160, 140, math.radians(3.5)
    corners, faces = [], []

    def sheet(rows, columns, point):
        first = len(corners)
        corners.extend(point(i, k) for k in range(rows) for i in range(columns))
        return [(first + k * columns + i, first + k * columns + (i + 1) % columns,
                 first + (k + 1) * columns + (i + 1) % columns, first + (k + 1) * columns + i)
                for k in range(rows - 1) for i in range(columns)]

    def stone(x, y, z, shade):
        x, z = x + z * math.sin(lean), z * math.cos(lean)
        weathered = shade * (0.8 + 0.2 * math.sin(3 * z + 2 * x)) + noise.uniform(-12, 12)
        color = [max(0, min(255, int(weathered * tint))) for tint in (1, 0.9, 0.74)]
        return (412.5 + x, -87.25 + y, 131 + z, *color)

    def shaft(i, k):
        turn, height = 2 * math.pi * i / around, 0.6 + 4.4 * k / (along - 1)
        flute = abs(math.sin(10 * turn))
        radius = 0.5 - 0.018 * height + 0.03 * flute + noise.gauss(0, 0.0015)
        return stone(radius * math.cos(turn), radius * math.sin(turn), height, 120 + 90 * flute)

    def plinth(i, k):
        turn = 2 * math.pi * (i + 0.5) / 64
        out, height = ((0.75, 0), (0.75, 0.35), (0.7, 0.4), (0.6, 0.6), (0.5, 0.62))[k]
        square = max(abs(math.cos(turn)), abs(math.sin(turn))) if k < 3 else 1
        return stone(out * math.cos(turn) / square, out * math.sin(turn) / square, height, 190)

    # The scanner missed a patch of the shaft.
    faces += [face for n, face in enumerate(sheet(along, around, shaft))
              if math.hypot(n % around - 60, n // around - 90) > 7]
    faces += sheet(5, 64, plinth)
    header = ("ply\nformat binary_little_endian 1.0\ncomment a scan, in metres\n"
              f"element vertex {len(corners)}\nproperty double x\nproperty double y\n"
              "property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
              f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    return (header.encode() + b"".join(struct.pack("<3d3B", *corner) for corner in corners)
            + b"".join(struct.pack("<B4i", 4, *face) for face in faces))


def town():
    scene, chance = Gltf(), random.Random(2)
    grass, road, plaster, brick, slate, tiles, leaves, bark = (scene.material(color) for color in (
        (0.22, 0.33, 0.12), (0.25, 0.24, 0.23), (0.75, 0.68, 0.52), (0.5, 0.22, 0.15),
        (0.15, 0.17, 0.2), (0.55, 0.2, 0.1), (0.1, 0.25, 0.07), (0.25, 0.16, 0.1)))
    roof = [(-4.5, 5.5), (4.5, 5.5), (0, 9.5)]
    cottage = scene.mesh((box((-4, 0, -5), (4, 5.5, 5)), plaster), (prism(roof, 5.4, -5.4), tiles))
    house = scene.mesh((box((-4, 0, -5), (4, 5.5, 5)), brick), (prism(roof, 5.4, -5.4), slate))
    tree = scene.mesh((cone(0.3, 0, 2.5, 0.25, 6), bark), (cone(2.2, 2, 8), leaves))
    church = scene.mesh((box((-6, 0, -14), (6, 9, 10)), plaster),
                        (prism([(-6.6, 9), (6.6, 9), (0, 16)], 10.5, -14.5), slate),
                        (box((-3.5, 0, 10), (3.5, 22, 17)), plaster),
                        (([(-4, 22, 9.5), (4, 22, 9.5), (4, 22, 17.5), (-4, 22, 17.5), (0, 36, 13.5)],
                          [(0, 4, 1), (1, 4, 2), (2, 4, 3), (3, 4, 0)]), slate))
    scene.place("meadow", scene.mesh((box((-120, -1, -120), (120, 0, 120)), grass)))
    street = scene.mesh((box((-3, 0, -110), (3, 0.05, 110)), road))
    for k, turn in enumerate((0, math.pi / 2)):
        scene.place(f"street {k + 1}", street, turn=turn)
    scene.place("church", church, (-22, 0, -24), 0.3)
    for k in range(48):
        along, side, line = (k // 4 - 5.5) * 17, k % 2 * 2 - 1, k // 2 % 2
        if abs(along) < 12 or (side < 0 and -45 < along < 0):
            continue  # The crossing and the church.
        at = (side * chance.uniform(10, 12), 0, along) if line else (along, 0, side * chance.uniform(10, 12))
        scene.place(f"house {k}", chance.choice((cottage, house)), at,
                    (0, math.pi / 2)[1 - line] + chance.uniform(-0.05, 0.05),
                    (1, chance.uniform(0.9, 1.5), 1))
    for k in range(90):
        x, z = chance.uniform(-115, 115), chance.uniform(-115, 115)
        if min(abs(x), abs(z)) > 20 and math.hypot(x + 22, z + 24) > 24:
            size = chance.uniform(0.7, 1.4)
            scene.place(f"tree {k}", tree, (x, 0, z), chance.uniform(0, 6), (size, size, size))
    return scene


def write(folder):
    """Writes attic.glb, column.ply and town.gltf; returns their paths."""
    attic().write_glb(folder / "attic.glb")
    (folder / "column.ply").write_bytes(column())
    town().write_gltf(folder / "town.gltf")
    return [folder / name for name in ("attic.glb", "column.ply", "town.gltf")]


if __name__ == "__main__":
    write(Path(sys.argv[1]))
