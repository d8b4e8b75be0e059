// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "solve/outlines.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>

namespace balcony::solve {

namespace {

// Adds a corner behind others, without those that then are none.
void add_corner(std::vector<V2d>& corners, std::size_t first, const V2d& next) {
    const auto turns = [&] {
        const V2d& a = corners[corners.size() - 2];
        return (corners.back() - a).cross(next - a) > 0.0;
    };
    while (corners.size() >= first + 2 && !turns()) {
        corners.pop_back();
    }
    corners.push_back(next);
}

}  // namespace

Problem with_outline_marks(Problem problem) {
    std::vector<std::size_t> first;
    for (const Outline& outline : problem.outlines) {
        first.push_back(problem.marks.size());
        for (const V3d& point : outline.points) {
            problem.marks.push_back({point});
        }
    }
    for (Constraint& constraint : problem.constraints) {
        if (constraint.outline) {
            constraint.marks.resize(problem.outlines[*constraint.outline].points.size());
            std::iota(constraint.marks.begin(), constraint.marks.end(), first[*constraint.outline]);
        }
    }
    return problem;
}

std::vector<std::size_t> outermost(const Constraint& constraint, std::span<const V2d> at) {
    const auto ends = [&](const std::function<double(const V2d&)>& part) {
        const auto [least, greatest] = std::minmax_element(
            at.begin(), at.end(), [&](const V2d& a, const V2d& b) { return part(a) < part(b); });
        return std::array{static_cast<std::size_t>(least - at.begin()),
                          static_cast<std::size_t>(greatest - at.begin())};
    };
    if (constraint.kind == ConstraintKind::touches) {
        const auto [least, greatest] =
            ends([&](const V2d& p) { return distance_from(*constraint.corners, p.x, p.y); });
        return {least, greatest};
    }
    const auto [left, right] = ends([](const V2d& p) { return p.x; });
    const auto [top, bottom] = ends([](const V2d& p) { return p.y; });
    return {left, right, top, bottom};
}

// Andrew's monotone chains: the upper side to the right, the lower one back.
std::vector<V2d> hull_of(std::vector<V2d> at) {
    std::sort(at.begin(), at.end(),
              [](const V2d& a, const V2d& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
    at.erase(std::unique(at.begin(), at.end()), at.end());
    std::vector<V2d> corners;
    for (const V2d& one : at) {
        add_corner(corners, 0, one);
    }
    const std::size_t last = corners.empty() ? 0 : corners.size() - 1;
    for (auto one = at.rbegin(); one != at.rend(); ++one) {
        if (one != at.rbegin()) {
            add_corner(corners, last, *one);
        }
    }
    if (corners.size() > 1) {
        corners.pop_back();  // The first one again.
    }
    return corners;
}

}  // namespace balcony::solve
