// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Prints how fast points in space are found in the pictures of the standard cameras.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>

#include <fmt/core.h>

#include "balcony/inverse.hpp"
#include "balcony/lang.hpp"
#include "balcony/ray_roots.hpp"
#include "bench_case.hpp"

namespace balcony::bench {

namespace {

using analyse::Locator;
using analyse::V3d;

constexpr double picture_side = 500.0;
constexpr std::size_t point_count = 10'000;
constexpr int inverse_passes = 5;

// Points on rays of random places, at distances from a tenth to ten times the distance of the
// farthest origin.
std::vector<V3d> points_seen(const camera::Camera& camera, double width, double height) {
    expr::Graph graph;
    const auto ray = camera.emit(graph, width, height);
    const Axes axes = camera.parts().axes;
    const std::vector<expr::Expr> roots = rays::ray_roots(ray, false, false, axes, axes);
    std::mt19937_64 random(1996);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<std::array<V3d, 2>> rays;
    double size = 0.0;
    while (rays.size() < point_count) {
        const auto v =
            expr::evaluate(roots, {width * unit(random), height * unit(random), 0.0, {}});
        if (v[6] == 1.0) {
            rays.push_back({V3d(v[0], v[1], v[2]), V3d(v[3], v[4], v[5])});
            size = std::max(size, rays.back()[0].length());
        }
    }
    std::vector<V3d> points;
    for (const auto& [origin, direction] : rays) {
        const double distance = std::pow(10.0, 2.0 * unit(random) - 1.0);
        points.push_back(origin + (size > 0.0 ? size : 1.0) * distance * direction);
    }
    return points;
}

template <class Function>
double seconds(Function function) {
    const auto start = std::chrono::steady_clock::now();
    function();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

void print_inverse() {
    fmt::print(
        "\nthousand points a second found in a picture {} pixels high, one core\n"
        "(missed: how many of {} points are not found)\n\n",
        picture_side, point_count);
    fmt::print("{:<24}{:>12}{:>10}{:>14}{:>10}\n", "camera", "points", "patches", "to make, ms",
               "missed");
    for (const std::string& name : lang::built_in_cameras()) {
        const auto camera = lang::make_camera(name, "");
        // Not pictures of several cameras, and not more than a hundred maps.
        if (!camera || lang::family_of(name) == "maps") {
            continue;
        }
        const double width = std::round(picture_side * camera->parts().aspect);
        const std::vector<V3d> points = points_seen(*camera, width, picture_side);
        double making = std::numeric_limits<double>::infinity();
        double finding = making;
        std::size_t patches = 0;
        std::size_t missed = 0;
        for (int pass = 0; pass < inverse_passes; ++pass) {
            Result<Locator> locator;
            making = std::min(
                making, seconds([&] { locator = Locator::make(*camera, width, picture_side); }));
            std::size_t found = 0;
            const double time = seconds([&] { found = locator->locate(points).size(); });
            finding = std::min(finding, time);
            missed = point_count - std::min(found, point_count);
            patches = locator->patch_count();
        }
        fmt::print("{:<24}{:>12.0f}{:>10}{:>14.1f}{:>10}\n", name,
                   1e-3 * static_cast<double>(point_count) / finding, patches, 1e3 * making,
                   missed);
    }
}

}  // namespace balcony::bench
