// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/solving/contradictions.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace balcony::app {

namespace {

using solve::Constraint;
using solve::ConstraintKind;

// Why no camera can fulfil both rows of a mark; empty if one can.
std::string contradiction(const Constraint& a, const Constraint& b, const std::string& mark) {
    constexpr double far = 6.0;  // Deviations.
    if (a.kind == ConstraintKind::at && b.kind == ConstraintKind::at) {
        const double apart = (a.position - b.position).length();
        return apart > far * (a.deviation + b.deviation)
                   ? fmt::format("the mark '{}' is to appear at two positions, {:.3g} pixels apart",
                                 mark, apart)
                   : "";
    }
    const auto both = std::minmax(a.kind, b.kind);
    return both.first == ConstraintKind::inside && both.second == ConstraintKind::outside
               ? fmt::format("the mark '{}' is to be inside and outside the picture", mark)
               : "";
}

}  // namespace

Diagnostics contradictions_of(const solve::Problem& problem) {
    Diagnostics found;
    std::map<std::size_t, std::vector<const Constraint*>> of_mark;
    for (const Constraint& row : problem.constraints) {
        if (row.marks.size() != 1 || row.tolerance) {
            continue;
        }
        std::vector<const Constraint*>& others = of_mark[row.marks.front()];
        for (const Constraint* const other : others) {
            std::string why = contradiction(row, *other, problem.marks[row.marks.front()].name);
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
