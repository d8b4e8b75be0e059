// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/measure/jacobian.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::analyse {

bool Jacobian::regular() const {
    constexpr double min_ratio = 1e-4;
    return std::isfinite(maximum) && maximum > 0.0 && std::abs(minimum) >= min_ratio * maximum;
}

Jacobian jacobian(const Ray& ray, const std::optional<double>& distance) {
    const auto seen = [&](const V3d& origin_by, const V3d& direction_by) {
        const V3d moved = distance ? origin_by + *distance * direction_by : direction_by;
        return moved - moved.dot(ray.direction) * ray.direction;
    };
    Jacobian made{seen(ray.origin_by_x, ray.direction_by_x),
                  seen(ray.origin_by_y, ray.direction_by_y)};
    // For a 2 x 2 matrix with the columns a and b, the sum of the squares of both singular values
    // is |a|^2 + |b|^2, their product is the determinant. x runs to the right and y down, so that
    // the two and the direction make a right-handed frame where nothing is mirrored.
    const double sum = made.by_x.length2() + made.by_y.length2();
    const double product = made.by_x.cross(made.by_y).dot(ray.direction);
    const double plus = std::sqrt(std::max(sum + 2.0 * product, 0.0));
    const double minus = std::sqrt(std::max(sum - 2.0 * product, 0.0));
    made.maximum = 0.5 * (plus + minus);
    made.minimum = made.maximum > 0.0 ? product / made.maximum : 0.0;
    return made;
}

}  // namespace balcony::analyse
