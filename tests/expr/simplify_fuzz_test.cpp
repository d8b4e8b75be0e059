// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Random formulas through the graph's local rules and through the simplifier, against the plain
// definitions of their operations.

#include <cmath>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "random_formula.hpp"

namespace balcony::expr::simplify_fuzz_test {

namespace {

constexpr std::size_t formula_count = 20000;
constexpr std::size_t points_each = 6;

struct Outcome {
    std::size_t compared = 0;
    std::size_t left_out = 0;
    std::string failure{};
};

/// Points with values for the further inputs, which may have any rates.
struct Trial {
    explicit Trial(std::mt19937_64& random) : points(points_each) {
        std::uniform_real_distribution<double> range(-3.0, 3.0);
        for (std::size_t i = 0; i < points.size(); ++i) {
            inputs[i] = {{{"shutter", range(random)}, {"lens", range(random)}}};
            points[i] = {range(random), range(random), range(random), {}, inputs[i]};
        }
        for (const char* const name : {"lens", "shutter"}) {
            rates.emplace_back(name, static_cast<Rate>(random() % 4));
        }
    }
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    [[nodiscard]] Expr simplified(Expr expression) const {
        Graph& graph = expression.graph();
        Rates declared;
        for (const auto& [name, rate] : rates) {
            declared.declare(InputId(graph.input(name).node().detail), rate);
        }
        return simplify(std::span(&expression, 1), declared).front();
    }

    std::vector<Point> points;
    std::array<std::array<InputValue, 2>, points_each> inputs;
    std::vector<std::pair<const char*, Rate>> rates;
};

std::string describe(const char* what, const Point& point, Bounded wanted, Bounded found) {
    std::ostringstream text;
    text << what << " at x = " << point.x << ", y = " << point.y << ", t = " << point.time << ": "
         << found.value << " in the place of " << wanted.value << ", bounds " << found.error
         << " and " << wanted.error;
    return text.str();
}

// Compares where the formula is finite throughout, as the graph's algebra may assume, and where
// rounding leaves enough digits that a wrong rewriting could be told from it.
Outcome check(const Formula& formula, const Trial& trial) {
    constexpr double enough_digits = 1e-6;
    Graph graph;
    const Expr built = build(graph, formula);
    const Expr simple = trial.simplified(built);
    Outcome outcome;
    for (const Point& point : trial.points) {
        const Bounded wanted = evaluate_bounded(formula, point);
        const double scale = enough_digits * std::max(1.0, std::fabs(wanted.value));
        if (!(wanted.error < scale)) {
            ++outcome.left_out;
            continue;
        }
        for (const auto& [what, expression] :
             {std::pair("built", built), std::pair("simplified", simple)}) {
            const Bounded found = evaluate_bounded(expression, point);
            if (std::isfinite(found.value) && !(found.error < scale)) {
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
    if (!trial.simplified(simple).same(simple)) {
        outcome.failure = "simplified again it changes from\n" + print(simple) + "to\n" +
                          print(trial.simplified(simple));
    }
    return outcome;
}

}  // namespace

TEST(SimplifyFuzz, RandomFormulasKeepTheirValuesAndAreFinished) {
    std::mt19937_64 random(1996);
    Outcome all;
    for (std::size_t i = 0; i < formula_count; ++i) {
        const Formula formula = random_formula(random, 3 + i % 38);
        const Trial trial(random);
        const Outcome outcome = check(formula, trial);
        all.compared += outcome.compared;
        all.left_out += outcome.left_out;
        if (!outcome.failure.empty()) {
            const Formula small = minimised(
                formula, [&](const Formula& f) { return !check(f, trial).failure.empty(); });
            ADD_FAILURE() << "formula " << i << ": " << check(small, trial).failure << "\n"
                          << to_text(small);
            if (HasNonfatalFailure() && i > 200) {
                return;
            }
        }
    }
    // Operations outside their domains and points near jumps must not empty the test.
    EXPECT_GT(all.compared, all.left_out);
    RecordProperty("compared", static_cast<int>(all.compared));
    RecordProperty("left_out", static_cast<int>(all.left_out));
}

}  // namespace balcony::expr::simplify_fuzz_test
