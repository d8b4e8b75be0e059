// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/camera_rays.hpp"

#include <cmath>
#include <limits>

namespace balcony::render {

bool fits_float(const V3d& v) {
    constexpr double maximum = std::numeric_limits<float>::max();
    return std::abs(v.x) <= maximum && std::abs(v.y) <= maximum && std::abs(v.z) <= maximum;
}

bool traceable(const rays::RayBatch& rays, std::size_t i) {
    const V3d d = rays.direction(i);
    return rays.valid(i) && fits_float(rays.origin(i)) && std::abs(d.length2() - 1.0) < 1e-6;
}

V2f parameters(const rays::RayBatch& rays, std::size_t i) {
    const V2f p(rays.parameters(i));
    return {std::isfinite(p.x) ? p.x : 0.0F, std::isfinite(p.y) ? p.y : 0.0F};
}

RayDifferentials differentials(const rays::RayBatch& rays, std::size_t i, double part) {
    RayDifferentials d;
    const auto set = [part](const V3d& origin_by, const V3d& direction_by, V3f& origin,
                            V3f& direction) {
        const V3d moved = part * origin_by;
        const V3d turned = part * direction_by;
        if (fits_float(moved) && fits_float(turned)) {
            origin = V3f(moved);
            direction = V3f(turned);
        }
    };
    set(rays.origin_by_x(i), rays.direction_by_x(i), d.origin_x, d.direction_x);
    set(rays.origin_by_y(i), rays.direction_by_y(i), d.origin_y, d.direction_y);
    return d;
}

}  // namespace balcony::render
