// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace balcony::bridge {

/// The functions of a C text that find the position whose ray passes a point. The words of its
/// dialect stand for themselves; GIVEN are the parameters behind the point, and PASSED the
/// arguments behind x and y.
inline constexpr std::string_view c_inverse = R"(
// The distance of a point along a ray; m is what leads from there to the point.
static REAL @_across(const REAL point[3], const REAL o[3], const REAL d[3], REAL m[3]) {
    const REAL z =
        (point[0] - o[0]) * d[0] + (point[1] - o[1]) * d[1] + (point[2] - o[2]) * d[2];
    for (int k = 0; k < 3; ++k) {
        m[k] = point[k] - o[k] - z * d[k];
    }
    return z;
}

// How far a ray misses a point: the sine of the angle, and 2 minus it for a point behind the ray.
static REAL @_miss(const REAL point[3], const REAL o[3], const REAL d[3]) {
    REAL m[3];
    const REAL z = @_across(point, o, d, m);
    const REAL a = sqrt~(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    const REAL r = sqrt~(a * a + z * z);
    return !(r > 0) ? 2 : z > 0 ? a / r : 2 - a / r;
}

// @_find_from() looks for the position in a picture whose ray passes a point by Newton's iteration
// from a given position, with the exact derivatives of the ray; a step that leads away from the
// point is halved. It returns 1 with the position, to TOLERANCE pixels, and the distance along the
// ray, or 0.
int @_find_from(const REAL point[3], GIVEN,
        REAL position[2], REAL* distance) {
    REAL o[3], d[3], s[4][3];
    if (!@_slopes(position[0], position[1], PASSED, o, d, s)) {
        return 0;
    }
    for (int i = 0; i < 60; ++i) {
        const REAL miss = @_miss(point, o, d);
        REAL m[3], a[3], b[3];
        const REAL z = @_across(point, o, d, m);
        REAL ad = 0, bd = 0, aa = 0, bb = 0, ab = 0, am = 0, bm = 0;
        for (int k = 0; k < 3; ++k) {
            a[k] = s[0][k] + z * s[2][k];
            b[k] = s[1][k] + z * s[3][k];
            ad += a[k] * d[k];
            bd += b[k] * d[k];
        }
        for (int k = 0; k < 3; ++k) {
            a[k] -= ad * d[k];
            b[k] -= bd * d[k];
            aa += a[k] * a[k];
            bb += b[k] * b[k];
            ab += a[k] * b[k];
            am += a[k] * m[k];
            bm += b[k] * m[k];
        }
        const REAL determinant = aa * bb - ab * ab;
        REAL dx = (bb * am - ab * bm) / determinant;
        REAL dy = (aa * bm - ab * am) / determinant;
        if (!isfinite(dx + dy)) {
            return 0;
        }
        if (fabs~(dx) + fabs~(dy) < (REAL)TOLERANCE) {
            *distance = z;
            return z >= 0 && position[0] >= 0 && position[0] < width && position[1] >= 0 &&
                   position[1] < height;
        }
        int nearer = 0;
        for (int halvings = 0; halvings < 16 && !nearer; ++halvings) {
            const REAL px = position[0] + dx, py = position[1] + dy;
            REAL o2[3], d2[3], s2[4][3];
            nearer = @_slopes(px, py, PASSED, o2, d2, s2) && @_miss(point, o2, d2) < miss;
            if (nearer) {
                position[0] = px;
                position[1] = py;
                for (int k = 0; k < 3; ++k) {
                    o[k] = o2[k];
                    d[k] = d2[k];
                    for (int j = 0; j < 4; ++j) {
                        s[j][k] = s2[j][k];
                    }
                }
            }
            dx /= 2;
            dy /= 2;
        }
        if (!nearer) {
            // Rounding hides what is left.
            *distance = z;
            return miss < (REAL)ROUNDING && z >= 0 && position[0] >= 0 && position[0] < width &&
                   position[1] >= 0 && position[1] < height;
        }
    }
    return 0;
}

// @_find() does the same from the best 8 of 40 x 40 positions, one after the other. A point that the
// picture shows at several positions is found at one of them.
int @_find(const REAL point[3], GIVEN,
        REAL position[2], REAL* distance) {
    REAL best[8][3];
    int count = 0;
    for (int i = 0; i < 40 * 40; ++i) {
        const REAL px = ((REAL)(i % 40) + (REAL)0.5) * width / 40;
        const REAL py = ((REAL)(i / 40) + (REAL)0.5) * height / 40;
        REAL o[3], d[3];
        if (!@_ray(px, py, PASSED, o, d)) {
            continue;
        }
        const REAL miss = @_miss(point, o, d);
        int k = count;
        for (; k > 0 && miss < best[k - 1][0]; --k) {
            for (int j = 0; j < 3 && k < 8; ++j) {
                best[k][j] = best[k - 1][j];
            }
        }
        if (k < 8) {
            best[k][0] = miss;
            best[k][1] = px;
            best[k][2] = py;
            count += count < 8;
        }
    }
    for (int k = 0; k < count; ++k) {
        position[0] = best[k][1];
        position[1] = best[k][2];
        if (@_find_from(point, PASSED_ON, position, distance)) {
            return 1;
        }
    }
    return 0;
}
)";

}  // namespace balcony::bridge
