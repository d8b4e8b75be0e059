#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes a glTF room in which renderers are compared.

Usage: room.py OUT.glb [--triangles COUNT]

A room of 6 x 4 x 3 metres with a lamp below the ceiling, a glossy floor, coloured side walls, a
sphere of glass, one of metal, a textured picture, and seven heads (spheres with bumps) that share
the given number of triangles.
"""
import argparse
import json
import math
import struct
import zlib


def png(width, height, pixel):
    """The bytes of an RGB image: pixel(x, y) gives three bytes."""
    rows = b"".join(b"\0" + b"".join(bytes(pixel(x, y)) for x in range(width))
                    for y in range(height))

    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data
                + struct.pack(">I", zlib.crc32(kind + data)))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9))
            + chunk(b"IEND", b""))


def picture_pixel(x, y):
    """A chequerboard in a frame, under a sun."""
    if not (16 <= x < 240 and 16 <= y < 240):
        return 60, 35, 15
    if (x - 170) ** 2 + (y - 80) ** 2 < 30 ** 2:
        return 250, 210, 60
    return (200, 90, 70) if (x // 16 + y // 16) % 2 else (70, 120, 200)


class Glb:
    """A binary glTF file in the making."""

    def __init__(self):
        self.data = bytearray()
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}],
                     "nodes": [], "meshes": [], "materials": [], "accessors": [],
                     "bufferViews": [], "extensionsUsed": ["KHR_materials_emissive_strength",
                                                           "KHR_materials_transmission",
                                                           "KHR_materials_ior",
                                                           "KHR_materials_specular",
                                                           "KHR_materials_volume"]}

    def view(self, data):
        self.data += b"\0" * (-len(self.data) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data),
                                         "byteLength": len(data)})
        self.data += data
        return len(self.json["bufferViews"]) - 1

    def accessor(self, values, kind, component=5126):
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[kind]
        flat = [number for value in values for number in (value if width > 1 else (value,))]
        accessor = {"bufferView": self.view(struct.pack(f"<{len(flat)}"
                                                        f"{'f' if component == 5126 else 'I'}",
                                                        *flat)),
                    "componentType": component, "count": len(values), "type": kind}
        if kind == "VEC3":
            accessor["min"] = [min(v[i] for v in values) for i in range(3)]
            accessor["max"] = [max(v[i] for v in values) for i in range(3)]
        self.json["accessors"].append(accessor)
        return len(self.json["accessors"]) - 1

    def material(self, name, color, roughness=1.0, metallic=0.0, **more):
        base = {"baseColorFactor": [*color, 1.0], "roughnessFactor": roughness,
                "metallicFactor": metallic}
        texture = more.pop("texture", None)
        if texture is not None:
            base["baseColorTexture"] = {"index": texture}
        self.json["materials"].append({"name": name, "pbrMetallicRoughness": base,
                                       "doubleSided": True, **more})
        return len(self.json["materials"]) - 1

    def texture(self, data):
        self.json["images"] = [{"bufferView": self.view(data), "mimeType": "image/png"}]
        self.json["textures"] = [{"source": 0}]
        return 0

    def mesh(self, name, mesh, material):
        positions, normals, points, triangles = mesh
        primitive = {"attributes": {"POSITION": self.accessor(positions, "VEC3"),
                                    "NORMAL": self.accessor(normals, "VEC3"),
                                    "TEXCOORD_0": self.accessor(points, "VEC2")},
                     "indices": self.accessor([i for t in triangles for i in t], "SCALAR", 5125),
                     "material": material}
        self.json["meshes"].append({"name": name, "primitives": [primitive]})
        self.json["nodes"].append({"name": name, "mesh": len(self.json["meshes"]) - 1})
        self.json["scenes"][0]["nodes"].append(len(self.json["nodes"]) - 1)

    def make_matt(self):
        """Takes the highlights from opaque surfaces and makes metals mirrors, so that every surface is
        one that glTF 2.0 and Blender's Principled BSDF describe alike."""
        for material in self.json["materials"]:
            base, more = material["pbrMetallicRoughness"], material.setdefault("extensions", {})
            if base["metallicFactor"] > 0:
                base["roughnessFactor"] = 0.0
            elif "KHR_materials_transmission" not in more:
                more["KHR_materials_specular"] = {"specularFactor": 0.0}

    def write(self, file):
        self.data += b"\0" * (-len(self.data) % 4)
        self.json["buffers"] = [{"byteLength": len(self.data)}]
        text = json.dumps(self.json).encode()
        text += b" " * (-len(text) % 4)
        with open(file, "wb") as out:
            out.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(self.data)))
            out.write(struct.pack("<I4s", len(text), b"JSON") + text)
            out.write(struct.pack("<I4s", len(self.data), b"BIN\0") + self.data)


def quad(corner, along, up):
    """A rectangle whose front is the side from which `along` runs to the right of `up`."""
    normal = [along[1] * up[2] - along[2] * up[1], along[2] * up[0] - along[0] * up[2],
              along[0] * up[1] - along[1] * up[0]]
    length = math.sqrt(sum(n * n for n in normal))
    unit = tuple(n / length for n in normal)
    corners = [tuple(corner[i] + a * along[i] + b * up[i] for i in range(3))
               for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return corners, [unit] * 4, [(0, 1), (1, 1), (1, 0), (0, 0)], [(0, 1, 2), (0, 2, 3)]


def sphere(centre, radius, rows, bumps=0.0):
    """A sphere of 4 rows^2 triangles, with waves of a height relative to the radius."""
    def wave(theta, phi):
        return 1 + bumps * math.sin(7 * theta) ** 2 * math.sin(9 * phi)

    def normal(theta, phi):
        """Across the derivatives of the point by both angles; the poles have no waves."""
        if not 1e-3 < theta < math.pi - 1e-3:
            return (0.0, math.copysign(1.0, math.cos(theta)), 0.0)
        r = wave(theta, phi)
        r_theta = 7 * bumps * math.sin(14 * theta) * math.sin(9 * phi)
        r_phi = 9 * bumps * math.sin(7 * theta) ** 2 * math.cos(9 * phi)
        sine, cosine = math.sin(theta), math.cos(theta)
        out = (sine * math.cos(phi), cosine, sine * math.sin(phi))
        down = (cosine * math.cos(phi), -sine, cosine * math.sin(phi))
        along = (-math.sin(phi), 0.0, math.cos(phi))
        across = [r * o - r_theta * d - r_phi / sine * a for o, d, a in zip(out, down, along)]
        length = math.sqrt(sum(a * a for a in across))
        return tuple(a / length for a in across)

    positions, normals, points, triangles = [], [], [], []
    columns = 2 * rows
    for row in range(rows + 1):
        theta = math.pi * row / rows
        for column in range(columns + 1):
            phi = 2 * math.pi * column / columns
            unit = (math.sin(theta) * math.cos(phi), math.cos(theta),
                    math.sin(theta) * math.sin(phi))
            positions.append(tuple(c + radius * wave(theta, phi) * n
                                   for c, n in zip(centre, unit)))
            normals.append(normal(theta, phi))
            points.append((column / columns, row / rows))
    for row in range(rows):
        for column in range(columns):
            a = row * (columns + 1) + column
            b = a + columns + 1
            triangles += [(a, a + 1, b), (a + 1, b + 1, b)]
    return positions, normals, points, triangles


def make_room(triangles):
    glb = Glb()
    white = glb.material("white", (0.8, 0.8, 0.8))
    red = glb.material("red", (0.7, 0.15, 0.1))
    green = glb.material("green", (0.2, 0.55, 0.15))
    floor = glb.material("floor", (0.45, 0.3, 0.2), roughness=0.25)
    metal = glb.material("metal", (0.9, 0.75, 0.4), roughness=0.3, metallic=1.0)
    glass = glb.material("glass", (1, 1, 1), roughness=0.0, extensions={
        "KHR_materials_transmission": {"transmissionFactor": 1.0},
        "KHR_materials_ior": {"ior": 1.5}, "KHR_materials_volume": {"thicknessFactor": 1.0}})
    light = glb.material("light", (0, 0, 0), emissiveFactor=[1.0, 0.9, 0.75], extensions={
        "KHR_materials_emissive_strength": {"emissiveStrength": 12.0}})
    picture = glb.material("picture", (1, 1, 1),
                           texture=glb.texture(png(256, 256, picture_pixel)))
    glb.mesh("floor", quad((-3, 0, 2), (6, 0, 0), (0, 0, -4)), floor)
    glb.mesh("ceiling", quad((-3, 3, -2), (6, 0, 0), (0, 0, 4)), white)
    glb.mesh("back wall", quad((-3, 0, -2), (6, 0, 0), (0, 3, 0)), white)
    glb.mesh("front wall", quad((3, 0, 2), (-6, 0, 0), (0, 3, 0)), white)
    glb.mesh("left wall", quad((-3, 0, 2), (0, 0, -4), (0, 3, 0)), red)
    glb.mesh("right wall", quad((3, 0, -2), (0, 0, 4), (0, 3, 0)), green)
    glb.mesh("lamp", quad((-0.75, 2.7, -0.5), (1.5, 0, 0), (0, 0, 1)), light)
    glb.mesh("picture", quad((0.6, 0.9, -1.99), (1.4, 0, 0), (0, 1.4, 0)), picture)
    glb.mesh("glass sphere", sphere((-0.9, 0.5, -0.4), 0.5, 64), glass)
    glb.mesh("metal sphere", sphere((2.0, 0.45, -0.9), 0.45, 64), metal)
    heads = 7
    rows = max(8, round(math.sqrt(triangles / heads / 4)))
    for i in range(heads):
        angle = 2 * math.pi * i / heads
        head = sphere((1.9 * math.cos(angle), 0.32, 1.4 * math.sin(angle)), 0.3, rows, 0.05)
        glb.mesh(f"head {i + 1}", head, white)
    return glb


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("output")
    parser.add_argument("--triangles", type=int, default=100_000)
    options = parser.parse_args()
    make_room(options.triangles).write(options.output)


if __name__ == "__main__":
    main()
