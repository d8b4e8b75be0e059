// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace balcony::bridge {

/// The functions of a Python text that find positions whose rays pass points. @ is the camera's
/// name.
inline constexpr std::string_view numpy_inverse = R"(

def _across(points, o, d):
    """The distances of points along rays, and what leads from there to the points."""
    to = points - o
    z = np.sum(to * d, axis=-1)
    return z, to - z[..., np.newaxis] * d


def _miss(points, o, d):
    """How far rays miss points: the sine of the angle, and 2 minus it for a point behind a ray."""
    z, m = _across(points, o, d)
    a = np.sqrt(np.sum(m * m, axis=-1))
    r = np.hypot(a, z)
    with np.errstate(all="ignore"):
        return np.where(r > 0, np.where(z > 0, a / r, 2 - a / r), 2.0)


def @_find_from(points, positions, width, height, /, *more, **parameters):
    """The positions in a picture whose rays pass points (n, 3), from given positions (n, 2).

    Newton's iteration with the exact derivatives of the rays; a step that leads away from a point
    is halved. What is behind height is as in @_ray(). Returns positions, to 1e-7 pixels, and the
    distances along the rays; both are NaN where the iteration does not arrive.
    """
    points, at = np.array(points, float), np.array(positions, float)
    found, far = np.full(at.shape, np.nan), np.full(len(at), np.nan)
    o, d, valid, slopes = @_slopes(
        at[:, 0], at[:, 1], width, height, *more, **parameters)
    index = np.flatnonzero(valid)  # Of the points that are still looked for.
    points, at, o, d, slopes = (a[index] for a in (points, at, o, d, slopes))
    for _ in range(60):
        if len(index) == 0:
            break
        z, m = _across(points, o, d)
        a = slopes[:, 0] + z[:, np.newaxis] * slopes[:, 2]
        b = slopes[:, 1] + z[:, np.newaxis] * slopes[:, 3]
        a -= np.sum(a * d, axis=1)[:, np.newaxis] * d
        b -= np.sum(b * d, axis=1)[:, np.newaxis] * d
        aa, bb, ab = np.sum(a * a, axis=1), np.sum(b * b, axis=1), np.sum(a * b, axis=1)
        am, bm = np.sum(a * m, axis=1), np.sum(b * m, axis=1)
        with np.errstate(all="ignore"):
            step = np.stack([bb * am - ab * bm, aa * bm - ab * am], -1)
            step /= (aa * bb - ab * ab)[:, np.newaxis]
        miss = _miss(points, o, d)
        left = np.isfinite(step).all(axis=1)
        arrived = left & (np.abs(step).sum(axis=1) < 1e-7)
        left &= ~arrived
        moved = np.zeros(len(index), bool)
        for _ in range(16):
            i = np.flatnonzero(left & ~moved)
            if len(i) == 0:
                break
            next_at = at[i] + step[i]
            next_o, next_d, valid, next_slopes = @_slopes(
                next_at[:, 0], next_at[:, 1], width, height, *more, **parameters)
            with np.errstate(all="ignore"):
                nearer = valid & (_miss(points[i], next_o, next_d) < miss[i])
            i, k = i[nearer], np.flatnonzero(nearer)
            at[i], o[i], d[i], slopes[i] = next_at[k], next_o[k], next_d[k], next_slopes[k]
            moved[i] = True
            step /= 2
        arrived |= left & ~moved & (miss < 1e-10)  # Rounding hides what is left.
        seen = arrived & (z >= 0) & (at >= 0).all(axis=1) & (at < [width, height]).all(axis=1)
        found[index[seen]], far[index[seen]] = at[seen], z[seen]
        index, points, at, o, d, slopes = (
            a[moved] for a in (index, points, at, o, d, slopes))
    return found, far


def @_find(points, width, height, /, *more, **parameters):
    """The positions in a picture whose rays pass points, an array of shape (..., 3).

    Looks for each from the best 8 of 40 x 40 positions, one after the other, by @_find_from().
    A point that the picture shows at several positions is found at one of them. Returns positions
    (..., 2) and the distances along the rays; both are NaN where the picture shows no point.
    """
    points = np.asarray(points, float)
    flat = points.reshape(-1, 3)
    found, far = np.full((len(flat), 2), np.nan), np.full(len(flat), np.nan)
    y, x = ((np.indices((40, 40)) + 0.5).reshape(2, -1) * [[height / 40], [width / 40]])
    o, d, valid = @_ray(x, y, width, height, *more, **parameters)
    seeds, o, d = np.stack([x, y], -1)[valid], o[valid], d[valid]
    for begin in range(0, len(flat) if len(seeds) else 0, 1000):
        some = flat[begin:begin + 1000]
        best = np.argsort(_miss(some[:, np.newaxis], o, d), axis=1, kind="stable")[:, :8]
        for k in range(best.shape[1]):
            left = np.flatnonzero(np.isnan(far[begin:begin + 1000]))
            if len(left) == 0:
                break
            found[begin + left], far[begin + left] = @_find_from(
                some[left], seeds[best[left, k]], width, height, *more, **parameters)
    return found.reshape(points.shape[:-1] + (2,)), far.reshape(points.shape[:-1])
)";

}  // namespace balcony::bridge
