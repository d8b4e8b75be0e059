// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/inverse/point_rays.hpp"

#include <cmath>

namespace balcony::analyse {

namespace {

program::Program compile(const camera::RayExpressions& ray) {
    const camera::RayFootprint footprint = camera::footprint(ray);
    std::vector<expr::Expr> roots;
    const auto add = [&roots](const auto& vector) {
        roots.insert(roots.end(), {vector.x, vector.y, vector.z});
    };
    add(ray.origin);
    add(ray.direction);
    add(footprint.origin_by_x);
    add(footprint.origin_by_y);
    add(footprint.direction_by_x);
    add(footprint.direction_by_y);
    roots.push_back(ray.valid);
    return program::Program(roots, program::Sampling::points);
}

}  // namespace

PointRays::PointRays(const camera::RayExpressions& ray, double time)
    : program_(compile(ray)), time_(time) {}

PointRays::Batch::Batch(const PointRays& rays) : rays_(&rays), values_(rays.program_.root_count()) {
    for (auto& values : values_) {
        results_.push_back(values.data());
    }
}

void PointRays::Batch::place(std::size_t i, const V2d& at) {
    x_[i] = at.x;
    y_[i] = at.y;
}

void PointRays::Batch::run(std::size_t count) {
    const program::Points points{std::span(x_).first(count), std::span(y_).first(count),
                                 rays_->time_};
    program::run(rays_->program_, points, scratch_, results_);
}

Ray PointRays::Batch::ray(std::size_t i) const {
    const auto vector = [&](std::size_t number) {
        const std::size_t root = 3 * number;
        return V3d(values_[root][i], values_[root + 1][i], values_[root + 2][i]);
    };
    Ray ray;
    ray.origin = vector(0);
    ray.direction = vector(1);
    ray.origin_by_x = vector(2);
    ray.origin_by_y = vector(3);
    ray.direction_by_x = vector(4);
    ray.direction_by_y = vector(5);
    const double size = ray.origin_by_x.length2() + ray.origin_by_y.length2() +
                        ray.direction_by_x.length2() + ray.direction_by_y.length2();
    ray.valid = values_[18][i] == 1.0 && std::isfinite(size);
    return ray;
}

}  // namespace balcony::analyse
