// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/camera_rays.hpp"

#include <cmath>

namespace balcony::render {

bool traceable(const rays::RayBatch& rays, std::size_t i) {
    const V3d d = rays.direction(i);
    return rays.valid(i) && embree::in_range(rays.origin(i)) && std::abs(d.length2() - 1.0) < 1e-6;
}

V2f parameters(const rays::RayBatch& rays, std::size_t i) {
    const V2f p(rays.parameters(i));
    return {std::isfinite(p.x) ? p.x : 0.0F, std::isfinite(p.y) ? p.y : 0.0F};
}

float magnification(const rays::RayBatch& rays, std::size_t i, const V3d& point) {
    if (!rays.has_footprints()) {
        return 0.0F;
    }
    const double length = (point - rays.origin(i)).length();
    const V3d by_x = rays.origin_by_x(i) + length * rays.direction_by_x(i);
    const V3d by_y = rays.origin_by_y(i) + length * rays.direction_by_y(i);
    const double area = std::abs(by_x.cross(by_y).dot(rays.direction(i)));  // Of a pixel.
    const auto pixels = static_cast<float>(1.0 / std::sqrt(area));
    return std::isfinite(pixels) ? pixels : 0.0F;
}

RayDifferentials differentials(const rays::RayBatch& rays, std::size_t i, double part) {
    RayDifferentials d;
    const auto set = [part](const V3d& origin_by, const V3d& direction_by, V3f& origin,
                            V3f& direction) {
        const V3d moved = part * origin_by;
        const V3d turned = part * direction_by;
        if (embree::in_range(moved) && embree::in_range(turned)) {
            origin = V3f(moved);
            direction = V3f(turned);
        }
    };
    set(rays.origin_by_x(i), rays.direction_by_x(i), d.origin_x, d.direction_x);
    set(rays.origin_by_y(i), rays.direction_by_y(i), d.origin_y, d.direction_y);
    return d;
}

}  // namespace balcony::render
