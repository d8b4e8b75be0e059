// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/bends/straight_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include <Imath/ImathVec.h>
#include <fmt/format.h>

#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

using Imath::V3d;
using Polyline = std::vector<V3d>;

CentralRay copied(const CentralRay& ray, Graph& graph) {
    return CentralRay::of(expr::substitute(graph, ray.values(), {}));
}

/// The paths of the trial points that are finite.
std::vector<std::optional<Polyline>> trial_paths(std::span<const Imath::V2d> points,
                                                 std::span<const ObjectPoint> knots,
                                                 const Emitter& emit) {
    std::vector<Expr> values;
    for (const ObjectPoint& knot : knots) {
        values.insert(values.end(), {knot.x, knot.y, knot.z});
    }
    std::vector<std::optional<Polyline>> paths;
    for (const Imath::V2d& point : points) {
        const std::vector<double> xyz = emit.trial(values, point.x, point.y);
        const bool finite =
            std::all_of(xyz.begin(), xyz.end(), [](double one) { return std::isfinite(one); });
        paths.emplace_back();
        if (finite) {
            paths.back().emplace();
            for (std::size_t i = 0; i < xyz.size(); i += 3) {
                paths.back()->emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
            }
        }
    }
    return paths;
}

double distance_from_segment(const V3d& p, const V3d& a, const V3d& b) {
    const V3d way = b - a;
    const double square = way.length2();
    const double part = square > 0.0 ? std::clamp((p - a).dot(way) / square, 0.0, 1.0) : 0.0;
    return (p - (a + part * way)).length();
}

/// The farthest that a path is from one with fewer parts.
double deviation(const Polyline& coarse, const Polyline& fine) {
    const std::size_t parts = coarse.size() - 1;
    const std::size_t ratio = (fine.size() - 1) / parts;
    double farthest = 0.0;
    for (std::size_t i = 0; i < fine.size(); ++i) {
        const std::size_t part = std::min(i / ratio, parts - 1);
        farthest =
            std::max(farthest, distance_from_segment(fine[i], coarse[part], coarse[part + 1]));
    }
    return farthest;
}

}  // namespace

std::vector<Imath::V2d> trial_points(const CentralRay& ray, const Emitter& emit) {
    constexpr int side = 5;
    constexpr double margin = 0.01;
    const std::array extent{ray.picture.size.width, ray.picture.size.height};
    const std::vector<double> size = emit.trial(extent, 0.0, 0.0);
    std::vector<Imath::V2d> points;
    for (int i = 0; i < side * side; ++i) {
        const auto along = [&](int k) { return margin + (1.0 - 2.0 * margin) * k / (side - 1.0); };
        points.emplace_back(along(i % side) * size[0], along(i / side) * size[1]);
    }
    return points;
}

std::vector<StageParameter> division_parameters() {
    return {{.name = "tolerance",
             .type = NumberParameter{.default_value = Division().tolerance,
                                     .range = {.minimum = 0.0, .excludes_minimum = true},
                                     .constant = true},
             .meaning = "the farthest that the straight parts may be from the curve, in scene "
                        "units"},
            {.name = "parts",
             .type = CountParameter{.default_value = 0.0,
                                    .range = {.minimum = 0.0, .maximum = max_straight_parts}},
             .meaning = "the number of straight parts; 0 is as many as the tolerance needs"}};
}

Division division_of(const Arguments& a) { return {a.constant("tolerance"), a.count("parts")}; }

std::size_t straight_parts(const Division& division, const CentralRay& ray,
                           const KnotsOfParts& knots, Emitter& emit) {
    if (division.parts > 0) {
        return division.parts;
    }
    // Fewer samples could miss that a path turns to and fro.
    constexpr std::size_t fewest_samples = 16;
    std::optional<double> error_of_most;
    const auto is_finite = [](const std::optional<Polyline>& path) { return path.has_value(); };
    for (const std::size_t parts :
         std::array<std::size_t, 16>{1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256}) {
        Graph graph;
        Emitter trial = emit.into(graph);
        const CentralRay central = copied(ray, graph);
        const std::vector<Imath::V2d> points = trial_points(central, trial);
        const std::size_t ratio = std::max<std::size_t>(2, (fewest_samples + parts - 1) / parts);
        const auto coarse = trial_paths(points, knots(central, parts, trial), trial);
        const auto fine = trial_paths(points, knots(central, ratio * parts, trial), trial);
        std::optional<double> farthest;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (coarse[i] && fine[i]) {
                farthest = std::max(farthest.value_or(0.0), deviation(*coarse[i], *fine[i]));
            }
        }
        if (farthest && *farthest <= division.tolerance) {
            const auto lost = std::count_if(coarse.begin(), coarse.end(), is_finite) -
                              std::count_if(fine.begin(), fine.end(), is_finite);
            if (lost > 0) {
                emit.report(warning(
                    fmt::format("on {} of {} rays over the picture, the numbers of this bend are "
                                "not finite between the ends of its straight parts",
                                lost, points.size()),
                    {}, "let its formula be defined along the rays, or write a number of parts"));
            }
            return parts;
        }
        error_of_most = farthest;
    }
    if (!error_of_most) {
        return max_straight_parts;  // No path is finite, which its camera reports.
    }
    emit.report(error(
        fmt::format("this bend needs more than {} straight parts to be within {:g} of its curve: "
                    "with so many it is {:.3g} away",
                    max_straight_parts, division.tolerance, *error_of_most),
        {}, "write a larger tolerance, a shorter path, or a number of parts"));
    return 1;
}

void report_unsteady_paths(std::size_t parts, const CentralRay& ray, const KnotsOfParts& knots,
                           Emitter& emit) {
    constexpr double noticeable = 0.01;
    Graph graph;
    Emitter trial = emit.into(graph);
    const CentralRay central = copied(ray, graph);
    const std::vector<Imath::V2d> points = trial_points(central, trial);
    const auto coarse = trial_paths(points, knots(central, parts, trial), trial);
    const auto fine = trial_paths(points, knots(central, 2 * parts, trial), trial);
    std::size_t unsteady = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!coarse[i] || !fine[i]) {
            unsteady += coarse[i] ? 1 : 0;
            continue;
        }
        double length = 0.0;
        double farthest = 0.0;
        for (std::size_t k = 1; k <= parts; ++k) {
            length += ((*fine[i])[2 * k] - (*fine[i])[2 * k - 2]).length();
            farthest = std::max(farthest, ((*fine[i])[2 * k] - (*coarse[i])[k]).length());
        }
        unsteady += farthest <= noticeable * length ? 0 : 1;
    }
    if (unsteady > 0) {
        emit.report(warning(
            fmt::format("on {} of {} rays over the picture, the path of this bend is another one "
                        "by more than {:.0f} % of its length if it has twice as many parts",
                        unsteady, points.size(), 100.0 * noticeable),
            {}, "write more parts, a shorter path, or a field that changes less quickly"));
    }
}

}  // namespace balcony::camera
