#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Usage: write_map_seeds.py FOLDER

Writes small maps of rays and positions, tables and points, for tests/fuzz/map_fuzzer.cpp to start
from.
"""

import pathlib
import struct
import sys

from write_scene_seeds import exr, png

RAY = {f"{name}.{axis}": 0.5 for name in ("origin", "direction") for axis in "XYZ"}


def npy(shape, kind, order="False"):
    """An array of ones; kind is a type as NumPy writes it."""
    header = f"{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}".encode()
    header += b" " * (-(len(header) + 11) % 64) + b"\n"
    count = 1
    for size in shape:
        count *= size
    number = struct.pack(kind[0] + {"f4": "f", "f8": "d"}[kind[1:]], 1.0)
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + count * number


def main():
    folder = pathlib.Path(sys.argv[1])
    seeds = {
        "rays.exr": exr(RAY), "rays.valid.exr": exr(RAY | {"valid.A": 1.0}),
        "positions.exr": exr({"R": 0.25, "G": 0.5, "B": 0.0}),
        "positions.png": png(),
        "rays.npy": npy((2, 2, 6), "<f8"), "rays.valid.npy": npy((2, 1, 7), ">f4"),
        "rays.columns.npy": npy((2, 2, 6), "<f4", "True"), "points.npy": npy((4, 3), "<f8"),
        "table.csv": b"u, v\n0, 1.5deg # the first\n1e-3; 2rad\n\n-.5\t3\n",
        "points.txt": b"0 0 1\n1 2.5 -3e2\n"}
    for name, data in seeds.items():
        (folder / name).write_bytes(data)


if __name__ == "__main__":
    main()
