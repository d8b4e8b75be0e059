// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/ray_difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace balcony::rays {

namespace {

/// A change of a ray: of its origin, in units of the distance, and of its direction.
struct RayChange {
    V3d origin, direction;
};

double dot(const RayChange& a, const RayChange& b) {
    return (a.origin ^ b.origin) + (a.direction ^ b.direction);
}

}  // namespace

// The solution (a, b) of a p_x + b p_y = e by least squares: e is the difference of the rays, p_x
// and p_y are the footprint. If p_x and p_y are parallel, the longer one alone measures e.
double pixels_between(const Ray& exact, const Ray& other, double distance) {
    const auto change = [distance](const V3d& origin, const V3d& direction) {
        return RayChange{std::isinf(distance) ? V3d(0.0) : origin / distance, direction};
    };
    const RayChange by_x = change(exact.origin_by_x, exact.direction_by_x);
    const RayChange by_y = change(exact.origin_by_y, exact.direction_by_y);
    const RayChange apart = change(other.origin - exact.origin, other.direction - exact.direction);
    const double square = dot(apart, apart);
    if (square == 0.0) {
        return 0.0;
    }
    const double xx = dot(by_x, by_x);
    const double yy = dot(by_y, by_y);
    const double longer = std::max(xx, yy);
    if (longer == 0.0) {
        return std::numeric_limits<double>::infinity();
    }
    const double xy = dot(by_x, by_y);
    const double ex = dot(by_x, apart);
    const double ey = dot(by_y, apart);
    const double determinant = xx * yy - xy * xy;
    constexpr double parallel = 1e-12;
    double a = xx == longer ? ex / xx : 0.0;
    double b = xx == longer ? 0.0 : ey / yy;
    if (determinant > parallel * longer * longer) {
        a = (yy * ex - xy * ey) / determinant;
        b = (xx * ey - xy * ex) / determinant;
    }
    const double remains = std::max(0.0, square - a * ex - b * ey);
    return std::hypot(a, b) + std::sqrt(remains / longer);
}

}  // namespace balcony::rays
