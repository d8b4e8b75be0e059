#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes rays.npy and lens.exr: the rays of a measured fisheye, and the distortion of a lens.

Usage: maps.py FOLDER

The fisheye looks along x. Its rays meet its axis the further behind the larger their angle is, so
that it has no single viewpoint, and its picture is a disc.
"""

import math
import struct
import sys
from pathlib import Path

WIDTH, HEIGHT = 32, 18


def rays():
    """Six numbers for each pixel; zeros outside the disc."""
    numbers = []
    for row in range(HEIGHT):
        for column in range(WIDTH):
            # To the left and up, in half heights.
            y = (WIDTH / 2 - column - 0.5) / (HEIGHT / 2)
            z = (HEIGHT / 2 - row - 0.5) / (HEIGHT / 2)
            radius = math.hypot(y, z)
            angle = math.radians(88) * radius * (1 - 0.08 * radius * radius)
            if radius > 1.25:
                numbers += [0.0] * 6
            else:
                across = math.sin(angle) / radius
                numbers += [-0.02 * angle * angle, 0, 0, math.cos(angle), across * y, across * z]
    return numbers


def npy(numbers, columns):
    header = (f"{{'descr': '<f4', 'fortran_order': False, "
              f"'shape': ({HEIGHT}, {WIDTH}, {columns}), }}")
    header += " " * (-(len(header) + 11) % 64) + "\n"
    return (b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode()
            + struct.pack(f"<{len(numbers)}f", *numbers))


def distortion():
    """For each pixel the position (s, t) to take: towards the corners, from further outside."""
    positions = []
    for row in range(HEIGHT):
        for column in range(WIDTH):
            s, t = (column + 0.5) / WIDTH, 1 - (row + 0.5) / HEIGHT
            x, y = 2 * s - 1, (2 * t - 1) * HEIGHT / WIDTH
            grow = 1 + 0.25 * (x * x + y * y)
            positions.append((0.5 + (s - 0.5) * grow, 0.5 + (t - 0.5) * grow))
    return positions


def exr(positions):
    """A file with the channels G and R of 32-bit floats, without compression."""
    def attribute(name, kind, value):
        return name + b"\0" + kind + b"\0" + struct.pack("<I", len(value)) + value

    channels = b"".join(name + b"\0" + struct.pack("<IIII", 2, 0, 1, 1) for name in (b"G", b"R"))
    window = struct.pack("<iiii", 0, 0, WIDTH - 1, HEIGHT - 1)
    header = (struct.pack("<II", 20000630, 2) + attribute(b"channels", b"chlist", channels + b"\0")
              + attribute(b"compression", b"compression", b"\0")
              + attribute(b"dataWindow", b"box2i", window)
              + attribute(b"displayWindow", b"box2i", window)
              + attribute(b"lineOrder", b"lineOrder", b"\0")
              + attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1))
              + attribute(b"screenWindowCenter", b"v2f", struct.pack("<ff", 0, 0))
              + attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)) + b"\0")
    line = 8 + 8 * WIDTH
    begin = len(header) + 8 * HEIGHT
    places = struct.pack(f"<{HEIGHT}Q", *(begin + line * row for row in range(HEIGHT)))
    lines = b""
    for row in range(HEIGHT):
        s, t = zip(*positions[row * WIDTH:(row + 1) * WIDTH], strict=True)
        lines += struct.pack(f"<ii{2 * WIDTH}f", row, 8 * WIDTH, *t, *s)
    return header + places + lines


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    (folder / "rays.npy").write_bytes(npy(rays(), 6))
    (folder / "lens.exr").write_bytes(exr(distortion()))
