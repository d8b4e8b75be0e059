// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/rays.hpp"

#include <limits>

namespace balcony::rays {

Ray RayBatch::operator[](std::size_t i) const {
    Ray ray{origin(i), direction(i), valid(i), has_parameters() ? parameters(i) : V2d(0.0),
            has_times() ? std::optional(time(i)) : std::nullopt};
    if (has_footprints()) {
        ray.origin_by_x = origin_by_x(i);
        ray.origin_by_y = origin_by_y(i);
        ray.direction_by_x = direction_by_x(i);
        ray.direction_by_y = direction_by_y(i);
    }
    return ray;
}

RayBatch::Part RayBatch::part(std::size_t i, std::size_t number) const {
    const V3d begin = number == 0 ? origin(i) : of_bend(i, number);
    if (number == roots_.knots) {
        return {begin, number == 0 ? direction(i) : of_bend(i, 0),
                std::numeric_limits<double>::infinity()};
    }
    const V3d way = of_bend(i, number + 1) - begin;
    const double length = way.length();
    return {begin, number == 0 ? direction(i) : way / length, length};
}

Ray RayBatch::ray_of_part(std::size_t i, std::size_t number) const {
    Ray ray = (*this)[i];
    if (number == 0) {
        return ray;
    }
    const Part at = part(i, number);
    ray.origin = at.origin;
    ray.direction = at.direction;
    if (has_footprints()) {
        const auto set = [&](Slope slope, V3d& origin_by, V3d& direction_by) {
            origin_by = of_bend(i, number, slope);
            if (number == roots_.knots) {
                direction_by = of_bend(i, 0, slope);
            } else {
                const V3d turn = (of_bend(i, number + 1, slope) - origin_by) / at.length;
                direction_by = turn - turn.dot(at.direction) * at.direction;
            }
        };
        set(Slope::by_x, ray.origin_by_x, ray.direction_by_x);
        set(Slope::by_y, ray.origin_by_y, ray.direction_by_y);
    }
    return ray;
}

std::span<double* const> RayBatch::reserve(std::size_t size, const Roots& roots) {
    size_ = size;
    roots_ = roots;
    return values_.reserve(roots.count(), size);
}

}  // namespace balcony::rays
