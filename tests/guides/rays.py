# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""How far rays of exported cameras are from our own."""

import math

# Cameras that magnify directions that they compute from sines, and their errors with them: this one
# by `zoom` in its file, tan(30 degrees)*sqrt(12^2 + 7.5^2 - 1)/1.
MAGNIFYING = {"built_in_cylindrical_anamorphosis": 8.2}


def pixels_between(exact, origin, direction, distance=10.0):
    """As rays::pixels_between()."""
    def change(o, d):
        return [a / distance for a in o] + list(d)

    def dot(a, b):
        return sum(p * q for p, q in zip(a, b))

    by_x = change(exact["origin_by_x"], exact["direction_by_x"])
    by_y = change(exact["origin_by_y"], exact["direction_by_y"])
    apart = change([a - b for a, b in zip(origin, exact["origin"])],
                   [a - b for a, b in zip(direction, exact["direction"])])
    xx, yy, xy = dot(by_x, by_x), dot(by_y, by_y), dot(by_x, by_y)
    ex, ey, square = dot(by_x, apart), dot(by_y, apart), dot(apart, apart)
    if square == 0.0:
        return 0.0
    longer, determinant = max(xx, yy), xx * yy - xy * xy
    if determinant > 1e-12 * longer * longer:
        a, b = (yy * ex - xy * ey) / determinant, (xx * ey - xy * ex) / determinant
    else:
        a, b = (ex / xx, 0.0) if xx == longer else (0.0, ey / yy)
    return math.hypot(a, b) + math.sqrt(max(0.0, square - a * ex - b * ey) / longer)
