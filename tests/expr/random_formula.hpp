// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/expr.hpp"

namespace balcony::expr {

/// A value with a bound on how far rounding may have carried it from the true one.
struct Bounded {
    double value = 0.0;
    double error = 0.0;
};

/// (a, b) to a / (1 + b^2) and 1 / (1 + a^2 + b^2), which is what formulas call.
[[nodiscard]] const std::shared_ptr<const Native>& formula_native();

/// A formula as a list of steps outside any graph, so that no rule of the graph has touched it.
struct Formula {
    /// The step of a result is a call of formula_native() on two steps.
    struct Step {
        Op op = Op::constant;
        std::array<std::size_t, 3> arguments{};  ///< Numbers of earlier steps.
        double value = 0.0;                      ///< Of a constant; which result of a call.
        std::string_view input{};                ///< The name of an input.
    };
    std::vector<Step> steps;  ///< The last one is the result.
};

/// The inputs of a random formula.
inline constexpr std::array<std::string_view, 5> formula_inputs{"x", "y", "t", "lens", "shutter"};

/// Values for those that are not x, y and t.
inline constexpr std::array further_input_values{InputValue{"lens", 0.65},
                                                 InputValue{"shutter", -1.3}};

/// A number below a count, which is at least 1: what decides how a formula grows.
using Choice = std::function<std::size_t(std::size_t)>;

/// Its inputs and some constants, then operations on them by choice, most of them inside their
/// domains.
[[nodiscard]] Formula grown_formula(const Choice& below, std::size_t operations_wanted);
/// The same by chance.
[[nodiscard]] Formula random_formula(std::mt19937_64& random, std::size_t operations_wanted);

/// The formula in a graph.
[[nodiscard]] Expr build(Graph& graph, const Formula& formula);

/// Both follow each operation's scalar definition and sum up what a change of its arguments within
/// their bounds does to its value, plus its own rounding. Near a jump the bound is as high as the
/// jump. A value that depends on one that is not finite gets an infinite bound.
[[nodiscard]] Bounded evaluate_bounded(const Formula& formula, const Point& point);
[[nodiscard]] Bounded evaluate_bounded(Expr expression, const Point& point);

/// For messages: one step a line.
[[nodiscard]] std::string to_text(const Formula& formula);

/// The smallest formula found that still fails, by leaving steps out.
template <class Fails>
Formula minimised(Formula formula, const Fails& fails) {
    for (std::size_t size = 1; size < formula.steps.size(); ++size) {
        Formula shorter = formula;
        shorter.steps.resize(size);
        if (fails(shorter)) {
            formula = shorter;
        }
    }
    for (std::size_t i = 0; i < formula.steps.size(); ++i) {
        for (const std::string_view input : formula_inputs) {
            Formula simpler = formula;
            simpler.steps[i] = {Op::input, {}, 0.0, input};
            if (operation(formula.steps[i].op).arity > 0 && fails(simpler)) {
                formula = simpler;
            }
        }
    }
    return formula;
}

}  // namespace balcony::expr
