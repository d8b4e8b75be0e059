#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes large scenes, to measure memory and time: instances of one mesh of 9,896 triangles, 1,000 unless
told otherwise, 10,000 objects with a mesh of their own, a mesh of 2 million triangles, and a wall of
pictures, each with a texture of its own.

    bench/big_scenes.py FOLDER [--instances COUNT] [--textures COUNT] [--texture-side PIXELS]
    /usr/bin/time -v balcony render FOLDER/instances.gltf -o instances.png
    /usr/bin/time -v balcony render --integrator preview FOLDER/textures.gltf -o textures.png
"""

import argparse
import base64
import json
import math
import struct
import zlib
from pathlib import Path


def sphere(columns, rows):
    """Positions and triangles of a unit sphere: 2 * columns * rows of them."""
    points, triangles = [], []
    for row in range(rows + 1):
        for column in range(columns + 1):
            theta, phi = math.pi * row / rows, 2 * math.pi * column / columns
            points.append((math.sin(theta) * math.cos(phi), math.cos(theta),
                           math.sin(theta) * math.sin(phi)))
            if row < rows and column < columns:
                a, b = row * (columns + 1) + column, (row + 1) * (columns + 1) + column
                triangles += [(a, a + 1, b), (a + 1, b + 1, b)]
    return points, triangles


def document(meshes, nodes, columns, rows):
    """A glTF document whose meshes all have the geometry of one sphere."""
    points, triangles = sphere(columns, rows)
    positions = b"".join(struct.pack("<3f", *point) for point in points)
    indices = b"".join(struct.pack("<3I", *triangle) for triangle in triangles)
    data = base64.b64encode(positions + indices).decode()
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}] * meshes,
        "buffers": [{"byteLength": len(positions) + len(indices),
                     "uri": "data:application/octet-stream;base64," + data}],
        "bufferViews": [{"buffer": 0, "byteLength": len(positions)},
                        {"buffer": 0, "byteOffset": len(positions), "byteLength": len(indices)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
                       "min": [-1, -1, -1], "max": [1, 1, 1]},
                      {"bufferView": 1, "componentType": 5125, "count": 3 * len(triangles),
                       "type": "SCALAR"}],
    }


def placed(count, mesh_of):
    """Nodes on a square grid."""
    side = math.ceil(math.sqrt(count))
    return [{"name": f"object {i}", "mesh": mesh_of(i),
             "translation": [2.5 * (i % side), 0, 2.5 * (i // side)]} for i in range(count)]


def png(side, seed):
    """An RGB image of stripes, whose pattern and colours differ by the seed."""
    period = 16 + seed % 48
    row = b"".join(bytes(((x * (3 + seed % 5)) % 256, (x // period * 40 + 31 * seed) % 256,
                          (x * x // 64 + 17 * seed) % 256)) for x in range(side)) * 2
    rows = b"".join(b"\0" + row[3 * (y * (1 + seed % 3) % side):][:3 * side] for y in range(side))

    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data
                + struct.pack(">I", zlib.crc32(kind + data)))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows, 1)) + chunk(b"IEND", b""))


def pictures(count):
    """A wall of pictures of a unit each, and a camera that sees all of them."""
    side = math.ceil(math.sqrt(count))
    data = struct.pack("<12f", 0, 0, 0, 0.9, 0, 0, 0.9, 0.9, 0, 0, 0.9, 0)
    data += struct.pack("<8f", 0, 1, 1, 1, 1, 0, 0, 0) + struct.pack("<6I", 0, 1, 2, 0, 2, 3)
    nodes = [{"name": f"picture {i}", "mesh": i, "translation": [i % side, i // side, 0]}
             for i in range(count)]
    nodes.append({"name": "view", "camera": 0, "translation": [side / 2, side / 2, side]})
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes,
        "cameras": [{"type": "perspective",
                     "perspective": {"yfov": 2 * math.atan(0.5), "aspectRatio": 1, "znear": 0.1}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2,
                                    "material": i}]} for i in range(count)],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": i}}}
                      for i in range(count)],
        "textures": [{"source": i} for i in range(count)],
        "images": [{"uri": f"{i}.png"} for i in range(count)],
        "buffers": [{"byteLength": len(data),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
        "bufferViews": [{"buffer": 0, "byteLength": 48},
                        {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                        {"buffer": 0, "byteOffset": 80, "byteLength": 24}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                       "min": [0, 0, 0], "max": [0.9, 0.9, 0]},
                      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
                      {"bufferView": 2, "componentType": 5125, "count": 6, "type": "SCALAR"}],
    }


def main():
    parser = argparse.ArgumentParser(description="writes large scenes")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--instances", type=int, default=1000, metavar="COUNT")
    parser.add_argument("--textures", type=int, default=500, metavar="COUNT")
    parser.add_argument("--texture-side", type=int, default=2048, metavar="PIXELS")
    options = parser.parse_args()
    folder = options.folder
    folder.mkdir(parents=True, exist_ok=True)
    instances = document(1, placed(options.instances, lambda i: 0), 100, 50)
    (folder / "instances.gltf").write_text(json.dumps(instances))
    objects = document(10_000, placed(10_000, lambda i: i), 8, 4)
    (folder / "objects.gltf").write_text(json.dumps(objects))
    mesh = document(1, placed(1, lambda i: 0), 1000, 1000)
    (folder / "mesh.gltf").write_text(json.dumps(mesh))
    (folder / "textures.gltf").write_text(json.dumps(pictures(options.textures)))
    for i in range(options.textures):
        (folder / f"{i}.png").write_bytes(png(options.texture_side, i))


if __name__ == "__main__":
    main()
