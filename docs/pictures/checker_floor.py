#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Usage: checker_floor.py FOLDER

Writes a glowing checker floor twice: textured.obj with an image, and squares.obj made of squares.
"""

import pathlib
import sys

SQUARES = 64
TEXELS = 32  # Of a square.
SIDE = 40.0
MATERIAL = "newmtl checker\nKd 0 0 0\nKe 1 1 1\n"


def corners(x, z, size):
    """The corners of a rectangle of the floor, counterclockwise from above."""
    square = SIDE / SQUARES
    left, near, length = x * square - SIDE / 2, z * square, size * square
    return [(left, -near), (left + length, -near), (left + length, -near - length),
            (left, -near - length)]


def write_obj(file, rectangles):
    lines = [f"mtllib {file.stem}.mtl", "usemtl checker", "vt 0 0", "vt 1 0", "vt 1 1", "vt 0 1"]
    for number, rectangle in enumerate(rectangles):
        lines += [f"v {x} 0 {z}" for x, z in rectangle]
        lines.append("f " + " ".join(f"{4 * number + k}/{k}" for k in range(1, 5)))
    file.write_text("\n".join(lines) + "\n")


def write_tga(file):
    side = SQUARES * TEXELS
    header = bytes([0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0]) + side.to_bytes(2, "little") * 2 + bytes(
        [8, 0])
    rows = [bytes(255 * ((x // TEXELS + y) % 2 == 0) for x in range(side)) for y in range(2)]
    file.write_bytes(header + b"".join(rows[y // TEXELS % 2] for y in range(side)))


folder = pathlib.Path(sys.argv[1])
folder.mkdir(parents=True, exist_ok=True)
(folder / "textured.mtl").write_text(MATERIAL + "map_Ke checker.tga\n")
(folder / "squares.mtl").write_text(MATERIAL)
write_tga(folder / "checker.tga")
write_obj(folder / "textured.obj", [corners(0, 0, SQUARES)])
write_obj(folder / "squares.obj", [corners(x, z, 1) for x in range(SQUARES)
                                   for z in range(SQUARES) if (x + z) % 2 == 0])
