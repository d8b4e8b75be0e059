// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/solving/missed_rows.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace balcony::app {

namespace {

constexpr double most_deviations = 5.0;  // Of a row that is not missed by far.
constexpr std::size_t most_warnings = 5;
// Of more rows, those that are missed most are the wrong ones.
constexpr std::size_t few_rows = 200;

bool all_seen(const SolveReport& report, const solve::Constraint& row) {
    return std::all_of(row.marks.begin(), row.marks.end(),
                       [&](std::size_t mark) { return report.solution.seen[mark].has_value(); });
}

// The rows that are missed by far, the worst first.
std::vector<std::size_t> far_missed(const SolveReport& report) {
    std::vector<std::size_t> rows;
    for (const std::size_t i : worst_constraints(report)) {
        const solve::Constraint& row = report.problem.constraints[i];
        if (report.solution.misses[i].deviations > most_deviations && !row.tolerance &&
            all_seen(report, row)) {
            rows.push_back(i);
        }
    }
    return rows;
}

// The rows that are missed by far when each counts less and less beyond its deviation, if they are
// less than half of all: the camera that meets most rows misses only these. Tolerances fall in
// steps, so that the search does not end at the first few rows that are met by chance.
std::vector<std::size_t> rows_against_most(const SolveReport& report,
                                           const solve::CameraMaker& make,
                                           const std::stop_token& stop) {
    constexpr double step = 3.0;
    Result<solve::Solution> other = report.solution;
    double tolerance = report.solution.misses[worst_constraints(report).front()].deviations;
    while (other && tolerance > 1.0) {
        tolerance = std::max(tolerance / step, 1.0);
        solve::Problem tolerant = report.problem;
        for (solve::Constraint& row : tolerant.constraints) {
            row.tolerance = std::min(row.tolerance.value_or(tolerance), tolerance);
        }
        for (std::size_t i = 0; i < tolerant.unknowns.size(); ++i) {
            tolerant.unknowns[i].value = other->values[i];
        }
        for (std::size_t i = 0; i < tolerant.targets.size(); ++i) {
            tolerant.targets[i].start = other->poses[i];
        }
        other = solve::solve(make, static_cast<double>(report.width),
                             static_cast<double>(report.height), tolerant, {}, stop);
    }
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; other && i < other->misses.size(); ++i) {
        if (other->misses[i].deviations > most_deviations &&
            !report.problem.constraints[i].tolerance) {
            rows.push_back(i);
        }
    }
    return 2 * rows.size() < report.problem.constraints.size() ? rows : std::vector<std::size_t>();
}

}  // namespace

Diagnostics warn_of_misses(const SolveReport& report, const solve::CameraMaker& make,
                           const std::stop_token& stop) {
    std::vector<std::size_t> rows = far_missed(report);
    Diagnostics found;
    if (rows.empty()) {
        return found;
    }
    const std::vector<std::size_t> wrong = report.problem.constraints.size() <= few_rows
                                               ? rows_against_most(report, make, stop)
                                               : std::vector<std::size_t>();
    const bool is_told = !wrong.empty() && wrong.size() <= most_warnings;
    rows = is_told ? wrong : rows;
    rows.resize(std::min(rows.size(), most_warnings));
    for (const std::size_t i : rows) {
        found.push_back(warning(
            is_told ? fmt::format("'{}' contradicts the other constraints, which can be met "
                                  "without {}",
                                  report.labels[i], rows.size() == 1 ? "it" : "these")
                    : fmt::format("'{}' is missed by {:.3g} standard deviations: the constraints "
                                  "contradict each other, or the camera cannot fulfil them",
                                  report.labels[i], report.solution.misses[i].deviations),
            report.problem.constraints[i].written,
            "correct the row, raise its deviation, give it a tolerance, or free more parameters"));
    }
    return found;
}

}  // namespace balcony::app
