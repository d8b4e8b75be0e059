# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Reads PNG files with 8 bits per channel."""

import struct
import zlib


def read(file):
    """The rows of an RGB or RGBA picture, each a list of pixels."""
    data = file.read_bytes()
    position, packed, header = 8, b"", None
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position:position + 8])
        body = data[position + 8:position + 8 + length]
        header = struct.unpack(">IIBB", body[:10]) if kind == b"IHDR" else header
        packed += body if kind == b"IDAT" else b""
        position += 12 + length
    width, height, bits, color = header
    assert bits == 8 and color in (2, 6), "an RGB or RGBA picture with 8 bits"
    size = 3 if color == 2 else 4
    raw, stride = zlib.decompress(packed), size * width
    rows, above = [], bytearray(stride)
    for y in range(height):
        line = raw[y * (stride + 1):(y + 1) * (stride + 1)]
        row = bytearray(line[1:])
        for i in range(stride):
            left = row[i - size] if i >= size else 0
            corner = above[i - size] if i >= size else 0
            up = above[i]
            estimate = left + up - corner
            nearest = min((left, up, corner), key=lambda value: abs(estimate - value))
            row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[line[0]]) & 255
        rows.append([tuple(row[i:i + size]) for i in range(0, stride, size)])
        above = row
    return rows
