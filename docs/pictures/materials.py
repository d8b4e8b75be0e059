#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Usage: materials.py FILE.glb

Writes the scene of the picture of docs/materials.md: a sphere of each kind of material in a room.
"""

import json
import math
import pathlib
import struct
import sys
import zlib


def png(side, pixel):
    """An image of `side` x `side` pixels, each of three or four bytes."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + b"".join(bytes(pixel(x, y)) for x in range(side)) for y in range(side))
    kind = 2 if len(pixel(0, 0)) == 3 else 6
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, kind, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def checker(x, y):
    return (235, 225, 205) if (x // 32 + y // 32) % 2 else (60, 90, 120)


def holes(x, y):
    inside = math.hypot(x % 32 - 15.5, y % 32 - 15.5) < 11
    return (240, 150, 60, 0 if inside else 255)


def bumps(x, y):
    """The normals of hemispherical bumps."""
    dx, dy = (x % 32 - 15.5) / 16, (y % 32 - 15.5) / 16
    square = min(dx * dx + dy * dy, 1)
    normal = (dx, -dy, math.sqrt(max(1 - square, 0.2))) if square < 0.8 else (0, 0, 1)
    length = math.sqrt(sum(part * part for part in normal))
    return tuple(round(127.5 + 127.5 * part / length) for part in normal)


class Scene:
    def __init__(self):
        self.buffer = b""
        self.json = {key: [] for key in ("accessors", "bufferViews", "images", "textures", "meshes",
                                         "materials", "nodes")}

    def add(self, key, value):
        self.json[key].append(value)
        return len(self.json[key]) - 1

    def view(self, data):
        self.buffer += bytes(-len(self.buffer) % 4)
        self.buffer += data
        return self.add("bufferViews", {"buffer": 0, "byteOffset": len(self.buffer) - len(data),
                                        "byteLength": len(data)})

    def floats(self, vectors):
        data = b"".join(struct.pack(f"<{len(vector)}f", *vector) for vector in vectors)
        return self.add("accessors", {"bufferView": self.view(data), "componentType": 5126,
                                      "count": len(vectors), "type": f"VEC{len(vectors[0])}"})

    def geometry(self, positions, normals, coordinates, triangles):
        indices = b"".join(struct.pack("<3I", *triangle) for triangle in triangles)
        return {"attributes": {"POSITION": self.floats(positions), "NORMAL": self.floats(normals),
                               "TEXCOORD_0": self.floats(coordinates)},
                "indices": self.add("accessors", {
                    "bufferView": self.view(indices), "componentType": 5125,
                    "count": 3 * len(triangles), "type": "SCALAR"})}

    def texture(self, image):
        source = self.add("images", {"bufferView": self.view(image), "mimeType": "image/png"})
        return self.add("textures", {"source": source})

    def node(self, name, geometry, material, **placement):
        material = self.add("materials", {"name": name, **material})
        mesh = self.add("meshes", {"primitives": [{**geometry, "material": material}]})
        self.add("nodes", {"name": name, "mesh": mesh, **placement})

    def write(self, file):
        self.buffer += bytes(-len(self.buffer) % 4)
        document = {"asset": {"version": "2.0"}, "buffers": [{"byteLength": len(self.buffer)}],
                    "scenes": [{"nodes": list(range(len(self.json["nodes"])))}], "scene": 0,
                    **self.json}
        text = json.dumps(document).encode()
        text += b" " * (-len(text) % 4)
        body = (struct.pack("<I", len(text)) + b"JSON" + text +
                struct.pack("<I", len(self.buffer)) + b"BIN\0" + self.buffer)
        pathlib.Path(file).write_bytes(b"glTF" + struct.pack("<II", 2, 12 + len(body)) + body)


def sphere(scene, columns=96, rows=48):
    places = [(math.pi * row / rows, 2 * math.pi * column / columns)
              for row in range(rows + 1) for column in range(columns + 1)]
    points = [(math.sin(a) * math.cos(b), math.cos(a), -math.sin(a) * math.sin(b))
              for a, b in places]
    corner = lambda row, column: row * (columns + 1) + column
    triangles = []
    for row in range(rows):
        for column in range(columns):
            a, b = corner(row, column), corner(row, column + 1)
            c, d = corner(row + 1, column), corner(row + 1, column + 1)
            # At the poles, one side of a cell is a point.
            triangles += [(a, c, d)] * (row < rows - 1) + [(a, d, b)] * (row > 0)
    return scene.geometry(points, points, [(b / math.pi, a / math.pi) for a, b in places], triangles)


def rectangle(scene, corner, right, up, repeat=(1, 1)):
    cross = (right[1] * up[2] - right[2] * up[1], right[2] * up[0] - right[0] * up[2],
             right[0] * up[1] - right[1] * up[0])
    length = math.sqrt(sum(part * part for part in cross))
    positions = [tuple(c + s * r + t * u for c, r, u in zip(corner, right, up))
                 for s, t in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return scene.geometry(positions, [tuple(part / length for part in cross)] * 4,
                          [(s * repeat[0], t * repeat[1]) for s, t in ((0, 1), (1, 1), (1, 0), (0, 0))],
                          [(0, 1, 2), (0, 2, 3)])


def surface(color, metallic=0, roughness=1, **more):
    return {"pbrMetallicRoughness": {"baseColorFactor": [*color, 1], "metallicFactor": metallic,
                                     "roughnessFactor": roughness}, **more}


def extended(material, **extensions):
    return {**material, "extensions": {f"KHR_materials_{name}": content
                                       for name, content in extensions.items()}}


def spheres(tiles, dots, bumpy):
    checkered = surface((1, 1, 1), 0, 0.5)
    checkered["pbrMetallicRoughness"]["baseColorTexture"] = {
        "index": tiles, "extensions": {"KHR_texture_transform": {"rotation": 0.6, "scale": [2, 2]}}}
    cut_out = surface((1, 1, 1), 0, 0.6, alphaMode="MASK", doubleSided=True)
    cut_out["pbrMetallicRoughness"]["baseColorTexture"] = {
        "index": dots, "extensions": {"KHR_texture_transform": {"scale": [2, 2]}}}
    embossed = surface((0.9, 0.9, 0.92), 1, 0.3, normalTexture={
        "index": bumpy, "extensions": {"KHR_texture_transform": {"scale": [3, 3]}}})
    return {
        "rough": surface((0.7, 0.3, 0.2)),
        "glossy": surface((0.1, 0.25, 0.6), 0, 0.15),
        "textured": checkered,
        "cut out": cut_out,
        "brushed gold": surface((1, 0.72, 0.3), 1, 0.35),
        "mirror": surface((0.95, 0.95, 0.95), 1, 0),
        "embossed": embossed,
        "lacquer": extended(surface((0.6, 0.02, 0.03), 0.6, 0.6),
                            clearcoat={"clearcoatFactor": 1, "clearcoatRoughnessFactor": 0.02}),
        "velvet": extended(surface((0.15, 0.02, 0.2)),
                           sheen={"sheenColorFactor": [0.9, 0.6, 1], "sheenRoughnessFactor": 0.4}),
        "green glass": extended(surface((1, 1, 1), 0, 0), transmission={"transmissionFactor": 1},
                                ior={"ior": 1.5},
                                volume={"thicknessFactor": 2, "attenuationDistance": 1.5,
                                        "attenuationColor": [0.3, 0.9, 0.5]}),
        "bubble": extended(surface((0.95, 0.8, 0.6), 0, 0.1),
                           transmission={"transmissionFactor": 1}),
        "diamond": extended(surface((1, 1, 1), 0, 0), transmission={"transmissionFactor": 1},
                            ior={"ior": 2.4}, volume={"thicknessFactor": 2}),
    }


def main():
    scene = Scene()
    tiles, dots, bumpy = (scene.texture(png(64, pixel)) for pixel in (checker, holes, bumps))
    ball = sphere(scene)
    for i, (name, material) in enumerate(spheres(tiles, dots, bumpy).items()):
        column, row = i % 4, i // 4
        scene.node(name, ball, material,
                   translation=[2.6 * column - 3.9, 1, 2.6 * row - 2.6])
    white = surface((0.75, 0.75, 0.75))
    floor = surface((0.5, 0.5, 0.5), 0, 0.4)
    floor["pbrMetallicRoughness"]["baseColorTexture"] = {"index": tiles}
    scene.node("floor", rectangle(scene, (-9, 0, 14), (18, 0, 0), (0, 0, -20), (9, 10)), floor)
    scene.node("back", rectangle(scene, (-9, 0, -6), (18, 0, 0), (0, 9, 0)), white)
    scene.node("left", rectangle(scene, (-9, 0, 14), (0, 0, -20), (0, 9, 0)),
               surface((0.7, 0.35, 0.25)))
    scene.node("right", rectangle(scene, (9, 0, -6), (0, 0, 20), (0, 9, 0)),
               surface((0.25, 0.4, 0.7)))
    scene.node("front", rectangle(scene, (9, 0, 14), (-18, 0, 0), (0, 9, 0)), white)
    scene.node("ceiling", rectangle(scene, (-9, 9, -6), (18, 0, 0), (0, 0, 20)), white)
    scene.node("lamp", rectangle(scene, (-4, 8.9, -2), (8, 0, 0), (0, 0, 5)),
               extended({**surface((0, 0, 0)), "emissiveFactor": [1, 0.95, 0.85]},
                        emissive_strength={"emissiveStrength": 9}))
    scene.json["cameras"] = [{"type": "perspective", "perspective": {
        "yfov": 0.6, "aspectRatio": 1.6, "znear": 0.01}}]
    # Looks down by 23 degrees.
    scene.add("nodes", {"name": "view", "camera": 0, "translation": [0, 6.2, 12],
                        "rotation": [-math.sin(0.2), 0, 0, math.cos(0.2)]})
    scene.write(sys.argv[1])


if __name__ == "__main__":
    main()
