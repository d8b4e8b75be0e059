// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "random_formula.hpp"

namespace balcony::expr {

/// What came of trying a formula.
struct Outcome {
    std::size_t compared = 0;  ///< Values.
    std::size_t left_out = 0;  ///< Those of which rounding leaves too few digits.
    std::string failure{};     ///< Empty if there is none.
};

/// Points with values for the further inputs, which may have any rates.
class Trial {
public:
    explicit Trial(const Choice& below);
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    /// Whether a formula keeps its values in a graph, and when it is simplified, and whether it is
    /// finished then. Compares where it is finite throughout, as the graph's algebra may assume,
    /// and where rounding leaves enough digits that a wrong rewriting could be told from it.
    [[nodiscard]] Outcome operator()(const Formula& formula) const;

private:
    static constexpr std::size_t count = 6;

    [[nodiscard]] Expr simplified(Expr expression) const;

    std::array<Point, count> points_;
    std::array<std::array<InputValue, 2>, count> inputs_;
    std::vector<std::pair<const char*, Rate>> rates_;
};

/// Whether a value within this error has enough digits for a comparison to mean something.
[[nodiscard]] bool has_enough_digits(double value, double error);

}  // namespace balcony::expr
