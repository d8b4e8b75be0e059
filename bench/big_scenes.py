#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes large scenes, to measure memory and time: 10 million triangles in 1,000 instances of one
mesh, and 10,000 objects with a mesh of their own.

    bench/big_scenes.py FOLDER
    /usr/bin/time -v balcony render FOLDER/instances.gltf -o instances.png
"""

import base64
import json
import math
import struct
import sys
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


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    instances = document(1, placed(1000, lambda i: 0), 100, 50)
    (folder / "instances.gltf").write_text(json.dumps(instances))
    objects = document(10_000, placed(10_000, lambda i: i), 8, 4)
    (folder / "objects.gltf").write_text(json.dumps(objects))


if __name__ == "__main__":
    main()
