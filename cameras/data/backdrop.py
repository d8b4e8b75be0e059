#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes backdrop.obj: a draped cloth, 14 wide and 8 high, about 10 in front of the origin.

Usage: backdrop.py > backdrop.obj

The file has y up. u goes from the left to the right as seen from the origin, v from the bottom to the
top.
"""

import math

WIDE, HIGH = 24, 14


def vertex(i, j):
    u, v = i / WIDE, j / HIGH
    left, up = 7.0 - 14.0 * u, 8.0 * v - 4.0
    folds = 0.6 * math.sin(3.0 * math.pi * u + 0.6) * (1.0 - 0.35 * v)
    ahead = 10.0 + folds + 0.25 * math.cos(math.pi * v) - 0.03 * left * left
    return (ahead, up, -left), (u, v)


def line(keyword, numbers):
    print(keyword, *(f"{round(number, 4) + 0.0:g}" for number in numbers))


print("# Written by backdrop.py: a draped cloth with y up, for the camera slide_mesh.")
print("o backdrop")
for j in range(HIGH + 1):
    for i in range(WIDE + 1):
        for keyword, numbers in zip(("v", "vt"), vertex(i, j)):
            line(keyword, numbers)
for j in range(HIGH):
    for i in range(WIDE):
        first = j * (WIDE + 1) + i + 1
        corners = (first, first + 1, first + WIDE + 2, first + WIDE + 1)
        print("f", *(f"{corner}/{corner}" for corner in corners))
