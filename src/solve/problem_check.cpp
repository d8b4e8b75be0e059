// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "solve/problem_check.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "camera/catalogue/parameter_text.hpp"

namespace balcony::solve {

namespace {

bool is_finite(const V3d& v) { return std::isfinite(v.x + v.y + v.z); }

Diagnostic numbered(std::string_view what, std::size_t i, std::string_view problem) {
    return error(fmt::format("{} {} {}", what, i + 1, problem));
}

bool is_out_of_range(const std::optional<double>& deviation) {
    return deviation && !camera::contains(deviation_range, *deviation);
}

std::string out_of_range(std::string_view what) {
    return fmt::format("has a {} that is not between {:g} and {:g}", what, deviation_range.minimum,
                       deviation_range.maximum);
}

bool are_corners(const std::array<V2d, 2>& corners, const ConstraintKindInfo& kind) {
    const auto [first, last] = corners;
    const bool are_finite = std::isfinite(first.x + first.y + last.x + last.y);
    return are_finite && (kind.corners == "box"    ? first.x < last.x && first.y < last.y
                          : kind.corners == "line" ? first != last
                                                   : false);
}

void check_constraint(const Constraint& constraint, std::size_t i, const Problem& problem,
                      Diagnostics& found) {
    const ConstraintKindInfo& kind = constraint_kinds()[static_cast<std::size_t>(constraint.kind)];
    const auto wrong = [&](std::string_view what) {
        found.push_back(numbered("constraint", i, fmt::format("('{}') {}", kind.name, what)));
    };
    if (constraint.marks.size() != kind.marks) {
        wrong(
            fmt::format("takes {}, not {}", counted(kind.marks, "mark"), constraint.marks.size()));
    }
    const bool is_of_outline = constraint.outline && *constraint.outline < problem.outlines.size();
    if (is_of_outline != kind.is_of_outline) {
        wrong(kind.is_of_outline ? "is about no outline" : "is about an outline");
    }
    if (constraint.corners ? !are_corners(*constraint.corners, kind)
                           : !kind.corners.empty() && !kind.may_lack_corners) {
        wrong("has corners that are no box or line");
    }
    for (const std::size_t mark : constraint.marks) {
        if (mark >= problem.marks.size()) {
            wrong(fmt::format("names mark {} of {}", mark + 1, problem.marks.size()));
        }
    }
    if (is_out_of_range(constraint.deviation)) {
        wrong(out_of_range("deviation"));
    }
    if (is_out_of_range(constraint.tolerance)) {
        wrong(out_of_range("tolerance"));
    }
    if (constraint.distance && !(*constraint.distance > 0.0)) {
        wrong("has a distance that is not above 0");
    }
    if (!std::isfinite(constraint.position.x + constraint.position.y + constraint.value)) {
        wrong("has a number that is not finite");
    }
    if (constraint.kind == ConstraintKind::magnification && !(constraint.value > 0.0)) {
        wrong("has a value that is not above 0");
    }
}

}  // namespace

Diagnostics problems_of(const Problem& problem) {
    Diagnostics found;
    if (problem.unknowns.empty() && problem.targets.empty()) {
        found.push_back(error("nothing is unknown", {}, "name a parameter to be found"));
    }
    if (problem.constraints.empty()) {
        found.push_back(error("there is no constraint", {}, "say what the picture is to show"));
    }
    for (std::size_t i = 0; i < problem.unknowns.size(); ++i) {
        const Unknown& unknown = problem.unknowns[i];
        if (!std::isfinite(unknown.value) || !camera::contains(unknown.range, unknown.value)) {
            found.push_back(numbered("unknown", i,
                                     fmt::format("('{}') begins at {}, outside its range",
                                                 unknown.input, unknown.value)));
        }
        if (is_out_of_range(unknown.deviation)) {
            found.push_back(numbered("unknown", i, out_of_range("deviation")));
        }
    }
    for (std::size_t i = 0; i < problem.targets.size(); ++i) {
        const Pose start = problem.targets[i].start.value_or(Pose{});
        if (!is_finite(start.rotation) || !is_finite(start.translation)) {
            found.push_back(numbered("target", i, "begins at a pose that is not finite"));
        }
    }
    for (std::size_t i = 0; i < problem.marks.size(); ++i) {
        const Mark& mark = problem.marks[i];
        if (!is_finite(mark.place) || (mark.at_infinity && !(mark.place.length2() > 0.0))) {
            found.push_back(numbered("mark", i, "is at no place"));
        }
        if (mark.target && (*mark.target >= problem.targets.size() || mark.at_infinity)) {
            found.push_back(numbered("mark", i, "is a point of no target"));
        }
    }
    for (std::size_t i = 0; i < problem.outlines.size(); ++i) {
        const std::vector<V3d>& points = problem.outlines[i].points;
        if (points.empty() || !std::all_of(points.begin(), points.end(), is_finite)) {
            found.push_back(numbered("outline", i, "has no points, or some at no place"));
        }
    }
    for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
        check_constraint(problem.constraints[i], i, problem, found);
    }
    return found;
}

}  // namespace balcony::solve
