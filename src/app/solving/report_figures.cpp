// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What a report says in few numbers.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "balcony/median.hpp"
#include "balcony/solving.hpp"

namespace balcony::app {

std::optional<double> position_error(const SolveReport& report) {
    double squares = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < report.problem.constraints.size(); ++i) {
        if (report.problem.constraints[i].kind == solve::ConstraintKind::at) {
            const auto& by = report.solution.misses[i].by;
            squares += by[0] * by[0] + by[1] * by[1];
            ++count;
        }
    }
    return count > 0 ? std::optional(std::sqrt(squares / static_cast<double>(count)))
                     : std::nullopt;
}

std::optional<Uncertainty> uncertainty(const SolveReport& report) {
    std::vector<double> known;
    for (const std::optional<double>& error : report.solution.errors) {
        if (error) {
            known.push_back(*error);
        }
    }
    if (known.empty()) {
        return std::nullopt;
    }
    const auto [least, most] = std::minmax_element(known.begin(), known.end());
    return Uncertainty{*least, *median(known), *most};
}

std::vector<std::size_t> worst_constraints(const SolveReport& report) {
    const std::vector<solve::Miss>& misses = report.solution.misses;
    std::vector<std::size_t> numbers(misses.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    std::stable_sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
        return misses[a].deviations > misses[b].deviations;
    });
    return numbers;
}

}  // namespace balcony::app
