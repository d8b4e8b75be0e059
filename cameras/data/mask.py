#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes mask.png: a keyhole, white on black, for the clip shape image.

Usage: mask.py > mask.png

A pixel's grey is the part of it that lies in the hole, from 4 x 4 points.
"""

import struct
import sys
import zlib

WIDTH, HEIGHT, PARTS = 160, 120, 4


def inside(x, y):
    """A disc, and a wedge that grows from its middle to the foot; y counts down."""
    round_part = (x - 80.0) ** 2 + (y - 40.0) ** 2 < 30.0 ** 2
    wedge = 40.0 < y < 112.0 and abs(x - 80.0) < 8.0 + 0.25 * (y - 40.0)
    return round_part or wedge


def grey(column, row):
    points = [(column + (i + 0.5) / PARTS, row + (j + 0.5) / PARTS)
              for i in range(PARTS) for j in range(PARTS)]
    return round(255 * sum(inside(x, y) for x, y in points) / len(points))


def chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))


rows = b"".join(b"\0" + bytes(grey(x, y) for x in range(WIDTH)) for y in range(HEIGHT))
sys.stdout.buffer.write(
    b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 0, 0, 0, 0))
    + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))
