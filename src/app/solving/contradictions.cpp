// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/solving/contradictions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace balcony::app {

namespace {

using solve::Constraint;
using solve::ConstraintKind;

std::string two_values(const Constraint& a, const Constraint& b, std::string_view what) {
    return fmt::format("{} is to be both {:g} and {:g}", what, b.value, a.value);
}

// Why no camera can fulfil both of two constraints on the same marks; empty if one can.
std::string contradiction(const Constraint& a, const Constraint& b, const solve::Problem& problem) {
    constexpr double far = 6.0;
    const double deviations = far * (a.deviation + b.deviation);
    const auto mark = [&] { return problem.marks[a.marks.front()].name; };
    using enum ConstraintKind;
    switch (const auto both = std::minmax(a.kind, b.kind); both.first) {
        case at: {
            const double apart = (a.position - b.position).length();
            return both.second == at && apart > deviations
                       ? fmt::format(
                             "the mark '{}' is to appear at two positions, {:.3g} pixels apart",
                             mark(), apart)
                       : "";
        }
        case inside:
            return both.second == outside
                       ? fmt::format("the mark '{}' is to be inside and outside the picture",
                                     mark())
                       : "";
        case together:
            return both.second == length && std::max(a.value, b.value) > deviations
                       ? fmt::format("two marks are to appear together and {:g} pixels apart",
                                     std::max(a.value, b.value))
                       : "";
        case length:
            return std::abs(a.value - b.value) > deviations
                       ? two_values(a, b, "the length between two marks")
                       : "";
        case magnification:
            return both.second == magnification && a.position == b.position &&
                           a.distance == b.distance &&
                           std::abs(std::log(a.value / b.value)) > deviations
                       ? two_values(a, b, "a magnification")
                       : "";
        case left:
        case right:
        case top:
        case bottom:
        case wide:
        case high:
            return both.second == both.first && a.outline == b.outline &&
                           std::abs(a.value - b.value) > deviations
                       ? two_values(
                             a, b,
                             fmt::format(
                                 "'{}' of an outline",
                                 solve::constraint_kinds()[static_cast<std::size_t>(a.kind)].name))
                       : "";
        default: return "";
    }
}

// What contradicting constraints are about: marks in any order.
std::vector<std::size_t> subject_of(const Constraint& constraint) {
    std::vector<std::size_t> marks = constraint.marks;
    std::sort(marks.begin(), marks.end());
    return marks;
}

}  // namespace

Diagnostics contradictions_of(const solve::Problem& problem) {
    Diagnostics found;
    std::map<std::vector<std::size_t>, std::vector<const Constraint*>> of_marks;
    for (const Constraint& row : problem.constraints) {
        if (row.tolerance || row.marks.size() > 2) {
            continue;
        }
        std::vector<const Constraint*>& others = of_marks[subject_of(row)];
        for (const Constraint* const other : others) {
            std::string why = contradiction(row, *other, problem);
            if (!why.empty()) {
                found.push_back(error(std::move(why), row.written,
                                      "remove one of the two rows, or give them a tolerance"));
                found.back().notes.push_back({other->written, "the other row"});
            }
        }
        others.push_back(&row);
    }
    return found;
}

}  // namespace balcony::app
