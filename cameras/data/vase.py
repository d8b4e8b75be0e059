#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes vase.obj: a profile turned round the y axis, with normals and texture co-ordinates.

Usage: vase.py > vase.obj

u goes once round counter-clockwise as seen from above, v from the foot to the lip.
"""

import math

ROUND, HIGH, HEIGHT = 32, 20, 2.0


def radius(v):
    """A foot, a belly, a neck and a lip."""
    return 0.45 + 0.3 * math.sin(2.0 * math.pi * (0.9 * v - 0.07)) + 0.15 * v ** 8


def vertex(i, j):
    angle, v = 2.0 * math.pi * i / ROUND, j / HIGH
    slope = (radius(v + 1e-6) - radius(v - 1e-6)) / 2e-6 / HEIGHT
    normal = (math.cos(angle), -slope, -math.sin(angle))
    length = math.sqrt(sum(x * x for x in normal))
    return ((radius(v) * math.cos(angle), HEIGHT * v, -radius(v) * math.sin(angle)),
            tuple(x / length for x in normal), (i / ROUND, v))


def line(keyword, numbers):
    print(keyword, *(f"{round(number, 5) + 0.0:g}" for number in numbers))


print("# Written by vase.py: a vase with y up, for the examples of the stage 'mesh'.")
print("o vase")
for j in range(HIGH + 1):
    for i in range(ROUND + 1):
        for keyword, numbers in zip(("v", "vn", "vt"), vertex(i, j)):
            line(keyword, numbers)
for j in range(HIGH):
    for i in range(ROUND):
        first = j * (ROUND + 1) + i + 1
        corners = (first, first + 1, first + ROUND + 2, first + ROUND + 1)
        print("f", *(f"{corner}/{corner}/{corner}" for corner in corners))
