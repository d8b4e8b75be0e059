// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/bent_rays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace balcony::render {

embree::Ray ray_of(const rays::RayBatch::Part& part, float time) {
    constexpr double rounding = 4.0 * std::numeric_limits<float>::epsilon();
    const Imath::V3d& o = part.origin;
    const double size = std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z), part.length});
    return {.origin = Imath::V3f(part.origin),
            .direction = Imath::V3f(part.direction),
            .farthest = static_cast<float>(part.length + rounding * size),
            .time = time};
}

FirstHit first_hit(const embree::Accelerator& accelerator, const rays::RayBatch& rays,
                   std::size_t i, float time) {
    FirstHit first;
    for (std::size_t number = 0; number < rays.part_count(); ++number) {
        const rays::RayBatch::Part part = rays.part(i, number);
        if (part.length > 0.0) {
            first = {number, accelerator.intersect(ray_of(part, time))};
            if (first.hit.any()) {
                break;
            }
        }
    }
    return first;
}

double length_before(const rays::RayBatch& rays, std::size_t i, std::size_t part) {
    double length = 0.0;
    for (std::size_t number = 0; number < part; ++number) {
        length += rays.part(i, number).length;
    }
    return length;
}

}  // namespace balcony::render
