// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <Imath/ImathVec.h>

#include "shading/geometry/circle.hpp"

namespace balcony::render {

/// Axes x and y that make a right-handed frame with a unit z: Duff et al., "Building an Orthonormal
/// Basis, Revisited" (2017).
struct Frame {
    explicit Frame(const Imath::V3f& normal) : z(normal) {
        const float sign = std::copysign(1.0F, z.z);
        const float a = -1.0F / (sign + z.z);
        const float b = z.x * z.y * a;
        x = {1.0F + sign * z.x * z.x * a, sign * b, -sign * z.x};
        y = {b, sign + z.y * z.y * a, -z.y};
    }

    [[nodiscard]] Imath::V3f to_local(const Imath::V3f& v) const {
        return {v.dot(x), v.dot(y), v.dot(z)};
    }
    [[nodiscard]] Imath::V3f to_world(const Imath::V3f& v) const {
        return v.x * x + v.y * y + v.z * z;
    }

    Imath::V3f x, y, z;
};

/// On the unit hemisphere about z, with density cosine over pi.
[[nodiscard]] inline Imath::V3f sample_cosine(float u, float v) {
    const float radius = std::sqrt(u);
    const Imath::V2f around = on_circle(v);
    return {radius * around.x, radius * around.y, std::sqrt(1.0F - u)};
}

}  // namespace balcony::render
