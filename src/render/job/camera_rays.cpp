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

void RayGrid::resize(std::size_t points, bool footprints) {
    for (std::size_t root = 0; root < (footprints ? root_count : origin_by_x); ++root) {
        values_[root].resize(points);
    }
}

std::span<double* const> RayGrid::roots(std::size_t count) {
    for (std::size_t root = 0; root < count; ++root) {
        roots_[root] = values_[root].data();
    }
    return std::span(roots_).first(count);
}

bool RayGrid::traceable(std::size_t i) const {
    const V3d d = direction(i);
    return values_[valid][i] == 1.0 && fits_float(origin(i)) && std::abs(d.length2() - 1.0) < 1e-6;
}

V2f RayGrid::parameters(std::size_t i) const {
    const V2f p(static_cast<float>(values_[parameter_u][i]),
                static_cast<float>(values_[parameter_v][i]));
    return {std::isfinite(p.x) ? p.x : 0.0F, std::isfinite(p.y) ? p.y : 0.0F};
}

RayDifferentials RayGrid::differentials(std::size_t i, double part) const {
    RayDifferentials d;
    const auto set = [&](std::size_t origin_root, std::size_t direction_root, V3f& origin,
                         V3f& direction) {
        const V3d moved = part * vector(origin_root, i);
        const V3d turned = part * vector(direction_root, i);
        if (fits_float(moved) && fits_float(turned)) {
            origin = V3f(moved);
            direction = V3f(turned);
        }
    };
    set(origin_by_x, direction_by_x, d.origin_x, d.direction_x);
    set(origin_by_y, direction_by_y, d.origin_y, d.direction_y);
    return d;
}

program::Program compile_rays(const camera::RayExpressions& ray, Axes camera_axes, Axes scene_axes,
                              bool footprints) {
    std::vector<expr::Expr> roots;
    const auto add = [&](const auto& v) {
        const auto in_scene = turned(std::array{v.x, v.y, v.z}, camera_axes, scene_axes);
        roots.insert(roots.end(), in_scene.begin(), in_scene.end());
    };
    add(ray.origin);
    add(ray.direction);
    roots.insert(roots.end(), {ray.valid, ray.parameters.u, ray.parameters.v});
    if (footprints) {
        const camera::RayFootprint slopes = camera::footprint(ray);
        add(slopes.origin_by_x);
        add(slopes.origin_by_y);
        add(slopes.direction_by_x);
        add(slopes.direction_by_y);
    }
    return program::Program(roots);
}

program::Program compile_camera(const camera::Camera& camera, Axes scene_axes, std::size_t width,
                                std::size_t height) {
    expr::Graph graph;
    return compile_rays(camera.emit(graph, static_cast<double>(width), static_cast<double>(height)),
                        camera.parts().axes, scene_axes, false);
}

}  // namespace balcony::render
