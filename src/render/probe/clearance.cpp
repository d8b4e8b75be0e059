// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/clearance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "balcony/progress.hpp"
#include "base/parallel_for.hpp"
#include "render/probe/triangles.hpp"

namespace balcony::render {

namespace {

using Imath::V3d;

double squared_distance_to_edge(const V3d& p, const V3d& a, const V3d& b) {
    const V3d way = b - a;
    const double length2 = way.length2();
    const double along = length2 > 0.0 ? std::clamp((p - a).dot(way) / length2, 0.0, 1.0) : 0.0;
    return (p - a - along * way).length2();
}

// To the foot of the perpendicular if it is in the triangle, otherwise to the nearest edge.
double squared_distance(const V3d& p, const std::array<V3d, 3>& corners) {
    const auto& [a, b, c] = corners;
    const V3d normal = (b - a).cross(c - a);
    const auto is_within = [&](const V3d& from, const V3d& to) {
        return (to - from).cross(p - from).dot(normal) >= 0.0;
    };
    if (normal.length2() > 0.0 && is_within(a, b) && is_within(b, c) && is_within(c, a)) {
        const double height = (p - a).dot(normal);
        return height * height / normal.length2();
    }
    return std::min({squared_distance_to_edge(p, a, b), squared_distance_to_edge(p, b, c),
                     squared_distance_to_edge(p, c, a)});
}

}  // namespace

Result<std::vector<double>> clearances(const scene::Scene& scene,
                                       std::span<const Imath::V3d> points, Axes axes,
                                       const std::stop_token& stop) {
    std::vector<double> found(points.size());
    parallel_for(points.size(), [&](std::size_t i) {
        if (stop.stop_requested()) {
            return;
        }
        const V3d point = turned(points[i], axes, Axes::z_up);
        double nearest = std::numeric_limits<double>::infinity();
        for_each_triangle(scene, {}, [&](const std::array<V3d, 3>& corners) {
            nearest = std::min(nearest, squared_distance(point, corners));
        });
        found[i] = std::sqrt(nearest);
    });
    if (stop.stop_requested()) {
        return stopped();
    }
    return found;
}

}  // namespace balcony::render
