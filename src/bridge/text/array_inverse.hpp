// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace balcony::bridge {

/// The functions of a Python text that find positions whose rays pass points. $ is the camera's
/// name, FIND how the names of functions begin, SEARCH a decorator, and LIB the library of arrays.
inline constexpr std::string_view array_inverse = R"(

def _across(points, o, d):
    """The distances of points along rays, and what leads from there to the points."""
    to = points - o
    z = (to * d).sum(-1)
    return z, to - z[..., None] * d


def _miss(points, o, d):
    """How far rays miss points: the sine of the angle, and 2 minus it for a point behind a ray."""
    z, m = _across(points, o, d)
    a = LIB.sqrt((m * m).sum(-1))
    r = LIB.hypot(a, z)
    return LIB.where(r > 0, LIB.where(z > 0, a / r, 2 - a / r), 2.0)


def _step(z, m, d, slopes):
    """The step in the picture that brings rays nearest to points, if slopes stay as they are."""
    a = slopes[:, 0] + z[:, None] * slopes[:, 2]
    b = slopes[:, 1] + z[:, None] * slopes[:, 3]
    a = a - (a * d).sum(-1)[:, None] * d
    b = b - (b * d).sum(-1)[:, None] * d
    aa, bb, ab = (a * a).sum(-1), (b * b).sum(-1), (a * b).sum(-1)
    am, bm = (a * m).sum(-1), (b * m).sum(-1)
    step = LIB.stack([bb * am - ab * bm, aa * bm - ab * am], -1)
    return step / (aa * bb - ab * ab)[:, None]


SEARCHdef FIND_find_from(points, positions, width, height, /, *more, **parameters):
    """The positions in a picture whose rays pass points (n, 3), from given positions (n, 2).

    Newton's iteration with the exact derivatives of the rays; a step that leads away from a point
    is halved. What is behind height is as in $_ray(). Returns positions, to 1e-7 pixels, and the
    distances along the rays; both are NaN where the iteration does not arrive.
    """
    points, at = _doubles(points, positions)
    found, far = LIB.full_like(at, float("nan")), LIB.full_like(at[:, 0], float("nan"))
    o, d, valid, slopes = $_slopes(
        at[:, 0], at[:, 1], width, height, *more, **parameters)
    index = _indices(valid)  # Of the points that are still looked for.
    points, at, o, d, slopes = (a[index] for a in (points, at, o, d, slopes))
    for _ in range(60):
        if len(index) == 0:
            break
        z, m = _across(points, o, d)
        step = _step(z, m, d, slopes)
        miss = _miss(points, o, d)
        left = LIB.isfinite(step).all(-1)
        arrived = left & (LIB.abs(step).sum(-1) < 1e-7)
        left = left & ~arrived
        moved = LIB.zeros_like(left)
        for _ in range(16):
            i = _indices(left & ~moved)
            if len(i) == 0:
                break
            next_at = at[i] + step[i]
            next_o, next_d, valid, next_slopes = $_slopes(
                next_at[:, 0], next_at[:, 1], width, height, *more, **parameters)
            nearer = valid & (_miss(points[i], next_o, next_d) < miss[i])
            i, k = i[nearer], _indices(nearer)
            at[i], o[i], d[i], slopes[i] = next_at[k], next_o[k], next_d[k], next_slopes[k]
            moved[i] = True
            step = step / 2
        arrived = arrived | (left & ~moved & (miss < 1e-10))  # Rounding hides what is left.
        seen = arrived & (z >= 0) & (at >= 0).all(-1) & (at[:, 0] < width) & (at[:, 1] < height)
        found[index[seen]], far[index[seen]] = at[seen], z[seen]
        index, points, at, o, d, slopes = (
            a[moved] for a in (index, points, at, o, d, slopes))
    return found, far


SEARCHdef FIND_find(points, width, height, /, *more, **parameters):
    """The positions in a picture whose rays pass points, an array of shape (..., 3).

    Looks for each from the best 8 of 40 x 40 positions, one after the other, by $_find_from().
    A point that the picture shows at several positions is found at one of them. Returns positions
    (..., 2) and the distances along the rays; both are NaN where the picture shows no point.
    """
    points, = _doubles(points)
    flat = points.reshape(-1, 3)
    found, far = LIB.full_like(flat[:, :2], float("nan")), LIB.full_like(flat[:, 0], float("nan"))
    k = _count(1600, flat)
    x, y = (k % 40 + 0.5) * (width / 40), (k // 40 + 0.5) * (height / 40)
    o, d, valid = $_ray(x, y, width, height, *more, **parameters)
    seeds, o, d = LIB.stack([x, y], -1)[valid], o[valid], d[valid]
    for begin in range(0, len(flat) if len(seeds) else 0, 1000):
        some = flat[begin:begin + 1000]
        best = _order(_miss(some[:, None], o, d))[:, :8]
        for k in range(best.shape[1]):
            left = _indices(LIB.isnan(far[begin:begin + 1000]))
            if len(left) == 0:
                break
            found[begin + left], far[begin + left] = FIND_find_from(
                some[left], seeds[best[left, k]], width, height, *more, **parameters)
    return found.reshape(points.shape[:-1] + (2,)), far.reshape(points.shape[:-1])
)";

}  // namespace balcony::bridge
