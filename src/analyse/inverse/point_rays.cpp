// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/inverse/point_rays.hpp"

#include <cmath>

namespace balcony::analyse {

void PointRays::Batch::place(std::size_t i, const V2d& at) {
    x_[i] = at.x;
    y_[i] = at.y;
}

void PointRays::Batch::run(std::size_t count) {
    work_.go_on();
    rays_->program_.run({std::span(x_).first(count), std::span(y_).first(count), rays_->time_},
                        scratch_, batch_);
}

Ray PointRays::Batch::ray(std::size_t i) const {
    Ray ray = batch_.ray_of_part(i, rays_->part_);
    ray.valid = ray.valid && (!rays_->is_bent() || batch_.part(i, rays_->part_).length > 0.0);
    const double size = ray.origin_by_x.length2() + ray.origin_by_y.length2() +
                        ray.direction_by_x.length2() + ray.direction_by_y.length2();
    ray.valid = ray.valid && std::isfinite(size);
    return ray;
}

PointRays::Batch::Path PointRays::Batch::path(std::size_t i) const {
    Path path{batch_.origin(i), {}, 0.0, batch_.part(i, rays_->part_).length};
    for (std::size_t part = 0; part < rays_->part_; ++part) {
        path.before += batch_.part(i, part).length;
        path.turns.push_back(batch_.part(i, part + 1).origin);
    }
    return path;
}

}  // namespace balcony::analyse
