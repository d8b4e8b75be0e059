// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "formula_trial.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace balcony::expr {

namespace {

// From -3 to 3.
double any_number(const Choice& below) {
    constexpr std::size_t steps = 1U << 16U;
    return 6.0 * static_cast<double>(below(steps)) / static_cast<double>(steps) - 3.0;
}

std::string describe(const char* what, const Point& point, Bounded wanted, Bounded found) {
    std::ostringstream text;
    text << what << " at x = " << point.x << ", y = " << point.y << ", t = " << point.time << ": "
         << found.value << " in the place of " << wanted.value << ", bounds " << found.error
         << " and " << wanted.error;
    return text.str();
}

}  // namespace

bool has_enough_digits(double value, double error) {
    constexpr double enough_digits = 1e-6;
    return error < enough_digits * std::max(1.0, std::fabs(value));
}

Trial::Trial(const Choice& below) {
    for (std::size_t i = 0; i < count; ++i) {
        inputs_[i] = {{{"shutter", any_number(below)}, {"lens", any_number(below)}}};
        points_[i] = {any_number(below), any_number(below), any_number(below), {}, inputs_[i]};
    }
    for (const char* const name : {"lens", "shutter"}) {
        rates_.emplace_back(name, static_cast<Rate>(below(4)));
    }
}

Expr Trial::simplified(Expr expression) const {
    Graph& graph = expression.graph();
    Rates declared;
    for (const auto& [name, rate] : rates_) {
        declared.declare(InputId(graph.input(name).node().detail), rate);
    }
    return simplify(std::span(&expression, 1), declared).front();
}

Outcome Trial::operator()(const Formula& formula) const {
    Graph graph;
    const Expr built = build(graph, formula);
    const Expr simple = simplified(built);
    Outcome outcome;
    for (const Point& point : points_) {
        const Bounded wanted = evaluate_bounded(formula, point);
        if (!has_enough_digits(wanted.value, wanted.error)) {
            ++outcome.left_out;
            continue;
        }
        for (const auto& [what, expression] :
             {std::pair("built", built), std::pair("simplified", simple)}) {
            const Bounded found = evaluate_bounded(expression, point);
            if (std::isfinite(found.value) && !has_enough_digits(wanted.value, found.error)) {
                ++outcome.left_out;
                continue;
            }
            ++outcome.compared;
            // The bounds are of first order: twice their sum leaves room for the second.
            const double tolerance =
                2.0 * (wanted.error + (std::isfinite(found.error) ? found.error : 0.0));
            if (!(std::fabs(found.value - wanted.value) <= tolerance)) {
                outcome.failure = describe(what, point, wanted, found) + "\n" + print(expression);
                return outcome;
            }
        }
    }
    if (!simplified(simple).same(simple)) {
        outcome.failure = "simplified again it changes from\n" + print(simple) + "to\n" +
                          print(simplified(simple));
    }
    return outcome;
}

}  // namespace balcony::expr
