// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "solve/projection_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace balcony::solve {

namespace {

using Eigen::Index;
using ByUnknown = Eigen::Matrix<double, 2, Eigen::Dynamic>;

// Points are this many times as far away as the farthest target if no distance is asked for.
constexpr double far_away = 1e6;

V3d in_target(const Pose& pose, const V3d& place) {
    return Pose{-pose.rotation, V3d(0.0)} * (place - pose.translation);
}

// What the picture shows in the middles of the cells, once for each target.
struct Probes {
    Problem problem;  // Marks alone.
    std::vector<V2d> near;
    std::vector<std::size_t> cells;
};

Probes probes_of(const CameraRays& rays, const Problem& problem, const V2d& size,
                 const std::vector<double>& values, const std::vector<Pose>& poses,
                 const ErrorGrid& grid) {
    double farthest = 0.0;
    for (const Pose& pose : poses) {
        farthest = std::max(farthest, pose.translation.length());
    }
    const bool at_infinity = !grid.distance && poses.empty();
    const double distance = grid.distance.value_or(far_away * farthest);
    Probes made{{problem.unknowns, problem.targets, {}, {}}, {}, {}};
    for (std::size_t cell = 0; cell < grid.columns * grid.rows; ++cell) {
        const V2d at((static_cast<double>(cell % grid.columns) + 0.5) /
                         static_cast<double>(grid.columns) * size.x,
                     (static_cast<double>(cell / grid.columns) + 0.5) /
                         static_cast<double>(grid.rows) * size.y);
        const InputRay there = rays.at({&at, 1}, values, false).front();
        if (!there.ray.valid) {
            continue;
        }
        const V3d place = there.ray.origin + distance * there.ray.direction;
        for (std::size_t k = 0; k < std::max<std::size_t>(poses.size(), 1); ++k) {
            Mark mark;
            mark.at_infinity = at_infinity;
            mark.place = at_infinity     ? there.ray.direction
                         : poses.empty() ? place
                                         : in_target(poses[k], place);
            mark.target = poses.empty() ? std::nullopt : std::optional(k);
            mark.near = at;
            made.problem.marks.push_back(mark);
            made.near.push_back(at);
            made.cells.push_back(cell);
        }
    }
    return made;
}

// The standard deviation in the direction in which it is largest.
double largest_deviation(const ByUnknown& by_unknown, const Spread& spread) {
    constexpr double rounding = 1e-6;  // What terms leave that cancel.
    const Eigen::MatrixXd moved = by_unknown * spread.free;
    const Eigen::MatrixXd terms = by_unknown.cwiseAbs() * spread.free.cwiseAbs();
    if ((moved.array().abs() > rounding * terms.array()).any()) {
        return std::numeric_limits<double>::infinity();
    }
    const Eigen::Matrix2d square = by_unknown * spread.covariance * by_unknown.transpose();
    const double middle = 0.5 * (square(0, 0) + square(1, 1));
    return std::sqrt(middle + std::hypot(0.5 * (square(0, 0) - square(1, 1)), square(0, 1)));
}

}  // namespace

std::vector<std::optional<double>> projection_errors(const CameraRays& rays, const Problem& problem,
                                                     const V2d& size,
                                                     const Eigen::VectorXd& unknowns,
                                                     const Spread& spread, const ErrorGrid& grid) {
    const System whole(rays, problem, size, {});
    const std::vector<Pose> poses = whole.poses_of(unknowns);
    const Probes probes = probes_of(rays, problem, size, whole.inputs_of(unknowns), poses, grid);
    const System system(rays, probes.problem, size, probes.near);
    const auto seen = system.seen(unknowns);
    std::vector<std::optional<double>> made(grid.columns * grid.rows);
    const std::size_t share = std::max<std::size_t>(poses.size(), 1);
    for (std::size_t i = 0; i + share <= seen.size(); i += share) {
        // The mean of the places of the point in all targets.
        ByUnknown mean = ByUnknown::Zero(2, unknowns.size());
        bool is_seen = true;
        for (std::size_t k = i; k < i + share; ++k) {
            is_seen = is_seen && seen[k];
            if (is_seen) {
                mean += seen[k]->by_unknown / static_cast<double>(share);
            }
        }
        if (is_seen) {
            made[probes.cells[i]] = largest_deviation(mean, spread);
        }
    }
    return made;
}

}  // namespace balcony::solve
