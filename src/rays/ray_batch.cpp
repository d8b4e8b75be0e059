// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/rays.hpp"

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

std::span<double* const> RayBatch::reserve(std::size_t size, const Roots& roots) {
    size_ = size;
    roots_ = roots;
    return values_.reserve(roots.count(), size);
}

}  // namespace balcony::rays
