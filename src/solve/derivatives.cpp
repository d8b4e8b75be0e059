// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Derivatives of what a picture shows, by the inputs of its camera.

#include <algorithm>
#include <cmath>

#include "balcony/solve.hpp"
#include "base/parallel_for.hpp"
#include "rays/approach.hpp"
#include "solve/input_rays.hpp"

namespace balcony::solve {

namespace {

constexpr std::size_t points_at_once = 1024;

// put(i, ray, change, numbers, step): the numbers of point i by one input; number n is numbers[n *
// step].
template <class Put>
Derivatives derivatives(const InputRays& rays, std::span<const V2d> points,
                        std::span<const double> values, std::size_t numbers, const Put& put) {
    const std::size_t inputs = values.size();
    Derivatives made{std::vector<std::uint8_t>(points.size()),
                     std::vector<double>(points.size() * numbers * inputs)};
    const auto fill = [&](std::size_t first) {
        const std::size_t count = std::min(points_at_once, points.size() - first);
        const std::vector<InputRay> part = rays.at(points.subspan(first, count), values, true);
        for (std::size_t i = 0; i < count; ++i) {
            const std::span<double> own(made.values.data() + (first + i) * numbers * inputs,
                                        numbers * inputs);
            for (std::size_t j = 0; part[i].ray.valid && j < inputs; ++j) {
                put(first + i, part[i].ray, part[i].by_input[j], own.data() + j, inputs);
            }
            const bool valid =
                part[i].ray.valid && std::all_of(own.begin(), own.end(),
                                                 [](double value) { return std::isfinite(value); });
            made.valid[first + i] = valid ? 1 : 0;
            if (!valid) {
                std::fill(own.begin(), own.end(), 0.0);
            }
        }
    };
    parallel_for((points.size() + points_at_once - 1) / points_at_once,
                 [&](std::size_t part) { fill(part * points_at_once); });
    return made;
}

}  // namespace

Derivatives Solver::ray_derivatives(std::span<const V2d> points,
                                    std::span<const double> values) const {
    return derivatives(*rays_, points, values, 6,
                       [](std::size_t, const rays::Ray&, const RayChange& change, double* numbers,
                          std::size_t step) {
                           for (int axis = 0; axis < 3; ++axis) {
                               numbers[static_cast<std::size_t>(axis) * step] = change.origin[axis];
                               numbers[static_cast<std::size_t>(axis + 3) * step] =
                                   change.direction[axis];
                           }
                       });
}

// The nearest point of the ray stays where it is: by_x dx + by_y dy is what the input moves it by,
// negated.
Derivatives Solver::position_derivatives(std::span<const V3d> points, std::span<const V2d> seen,
                                         std::span<const double> values) const {
    return derivatives(*rays_, seen, values, 2,
                       [&](std::size_t i, const rays::Ray& ray, const RayChange& change,
                           double* numbers, std::size_t step) {
                           const rays::Approach approach(ray, points[i]);
                           const V3d moved = change.origin + approach.distance * change.direction;
                           const V2d by_input = approach.step_to(-moved);
                           numbers[0] = by_input.x;
                           numbers[step] = by_input.y;
                       });
}

}  // namespace balcony::solve
