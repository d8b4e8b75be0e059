// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/ray_difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace balcony::rays {

namespace {

V3d without_part_along(const V3d& unit, const V3d& v) { return v - (v ^ unit) * unit; }

// The part of a point on the ray, or of its change, that counts at a distance.
V3d seen_at(double distance, const V3d& origin, const V3d& direction) {
    return std::isinf(distance) ? direction : origin + distance * direction;
}

}  // namespace

// The solution (a, b) of a p_x + b p_y = e by least squares: e is the difference of the two points
// and p_x and p_y are the footprint there, all across the exact ray. If p_x and p_y are parallel,
// the longer one alone measures e.
double pixels_between(const Ray& exact, const Ray& other, double distance) {
    const V3d& along = exact.direction;
    const auto across = [&](const V3d& origin, const V3d& direction) {
        return without_part_along(along, seen_at(distance, origin, direction));
    };
    const V3d by_x = across(exact.origin_by_x, exact.direction_by_x);
    const V3d by_y = across(exact.origin_by_y, exact.direction_by_y);
    const V3d apart = across(other.origin - exact.origin, other.direction - exact.direction);
    if (apart.length2() == 0.0) {
        return 0.0;
    }
    const double xx = by_x.length2();
    const double yy = by_y.length2();
    const double xy = by_x ^ by_y;
    const double determinant = xx * yy - xy * xy;
    constexpr double parallel = 1e-12;
    if (determinant > parallel * xx * yy) {
        const double a = (yy * (by_x ^ apart) - xy * (by_y ^ apart)) / determinant;
        const double b = (xx * (by_y ^ apart) - xy * (by_x ^ apart)) / determinant;
        return std::hypot(a, b);
    }
    const double pixel = std::sqrt(std::max(xx, yy));
    return pixel > 0.0 ? apart.length() / pixel : std::numeric_limits<double>::infinity();
}

}  // namespace balcony::rays
