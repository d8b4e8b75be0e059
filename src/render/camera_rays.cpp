// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/camera_rays.hpp"

#include <cmath>
#include <limits>

namespace balcony::render {

namespace {

std::array<expr::Expr, 3> turned(const std::array<expr::Expr, 3>& v, Axes from, Axes to) {
    if (from == to) {
        return v;
    }
    return to == Axes::y_up ? std::array{v[0], v[2], -v[1]} : std::array{v[0], -v[2], v[1]};
}

bool fits_float(const V3d& v) {
    constexpr double most = std::numeric_limits<float>::max();
    return std::abs(v.x) <= most && std::abs(v.y) <= most && std::abs(v.z) <= most;
}

}  // namespace

void RayGrid::resize(std::size_t points) {
    for (std::vector<double>& values : values_) {
        values.resize(points);
    }
}

std::array<double*, RayGrid::root_count> RayGrid::roots() {
    std::array<double*, root_count> pointers{};
    for (std::size_t root = 0; root < root_count; ++root) {
        pointers[root] = values_[root].data();
    }
    return pointers;
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

program::Program compile_camera(const camera::Camera& camera, Axes scene_axes, std::size_t width,
                                std::size_t height) {
    expr::Graph graph;
    const camera::RayExpressions ray =
        camera.emit(graph, static_cast<double>(width), static_cast<double>(height));
    const Axes axes = camera.parts().axes;
    const auto origin = turned({ray.origin.x, ray.origin.y, ray.origin.z}, axes, scene_axes);
    const auto direction =
        turned({ray.direction.x, ray.direction.y, ray.direction.z}, axes, scene_axes);
    const std::array<expr::Expr, RayGrid::root_count> roots = {
        origin[0],    origin[1], origin[2],        direction[0],    direction[1],
        direction[2], ray.valid, ray.parameters.u, ray.parameters.v};
    return program::Program(roots);
}

}  // namespace balcony::render
