// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How a ray passes a point, and how this changes with the picture position.

#include "balcony/rays.hpp"

namespace balcony::rays {

/// The offset of the point from the nearest point of the ray, and the derivatives with respect to
/// picture x and y of that nearest point; all perpendicular to the ray.
struct Approach {
    double distance;  ///< Along the ray; negative behind its origin.
    V3d offset;
    V3d by_x, by_y;

    Approach(const Ray& ray, const V3d& point) {
        const V3d from_origin = point - ray.origin;
        distance = from_origin.dot(ray.direction);
        const auto across = [&](const V3d& v) { return v - v.dot(ray.direction) * ray.direction; };
        offset = across(from_origin);
        by_x = across(ray.origin_by_x + distance * ray.direction_by_x);
        by_y = across(ray.origin_by_y + distance * ray.direction_by_y);
    }

    /// The step in the picture that brings the ray closest to the given offset, to first order:
    /// that of Newton's iteration. In singular directions, the step is short instead of arbitrary,
    /// because of Levenberg damping. The damping is negligible unless one of the derivatives, or
    /// its component perpendicular to the other, is ten million times smaller than the other.
    [[nodiscard]] V2d step_to(const V3d& to) const {
        const double xx = by_x.length2();
        const double yy = by_y.length2();
        const double xy = by_x.dot(by_y);
        const double damping = 1e-15 * (xx + yy);
        const double determinant = (xx + damping) * (yy + damping) - xy * xy;
        if (!(determinant > 0.0)) {
            return {0.0, 0.0};
        }
        const double x = by_x.dot(to);
        const double y = by_y.dot(to);
        return {((yy + damping) * x - xy * y) / determinant,
                ((xx + damping) * y - xy * x) / determinant};
    }

    [[nodiscard]] V3d after(const V2d& step) const {
        return offset - step.x * by_x - step.y * by_y;
    }
};

}  // namespace balcony::rays
