// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/rays.hpp"

namespace balcony::rays {

Ray RayBatch::operator[](std::size_t i) const {
    Ray ray{origin(i), direction(i), valid(i), parameters(i)};
    if (footprints_) {
        ray.origin_by_x = origin_by_x(i);
        ray.origin_by_y = origin_by_y(i);
        ray.direction_by_x = direction_by_x(i);
        ray.direction_by_y = direction_by_y(i);
    }
    return ray;
}

std::span<double* const> RayBatch::reserve(std::size_t size, bool footprints) {
    size_ = size;
    footprints_ = footprints;
    const std::size_t count = footprints ? values_count_ : origin_by_x_;
    return values_.reserve(count, size);
}

}  // namespace balcony::rays
