// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <random>

#include <gtest/gtest.h>

#include "random_formula.hpp"

namespace balcony::expr::substitute_test {

namespace {

std::vector<double> values(std::span<const Expr> expressions, double x, double y) {
    return evaluate(expressions, {x, y, 0.75, {}, further_input_values});
}

}  // namespace

TEST(Substitute, PutsReplacementsInAllAtOnce) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    const std::array formulas{x - 2.0 * y, x / y};
    const std::array swapped{Substitution{x, y}, Substitution{y, x}};
    EXPECT_EQ(values(substitute(graph, formulas, swapped), 3.0, 5.0), values(formulas, 5.0, 3.0));
}

TEST(Substitute, EqualsEvaluationAtTheReplacementsValues) {
    std::mt19937_64 random(41);
    std::uniform_real_distribution<double> range(-2.0, 2.0);
    for (int i = 0; i < 300; ++i) {
        Graph source;
        const Expr formula = build(source, random_formula(random, 15));
        Graph target;
        const Expr a = target.picture_x() + 0.5;
        const Expr b = target.picture_x() * target.picture_y();
        const std::array put{Substitution{source.picture_x(), a},
                             Substitution{source.picture_y(), b}};
        const Expr result = substitute(target, std::span(&formula, 1), put).front();
        ASSERT_EQ(&result.graph(), &target);
        const double x = range(random);
        const double y = range(random);
        const Bounded wanted =
            evaluate_bounded(formula, {x + 0.5, x * y, 0.75, {}, further_input_values});
        const Bounded found = evaluate_bounded(result, {x, y, 0.75, {}, further_input_values});
        if (wanted.error < 1e-6 && found.error < 1e-6) {
            // Bounds of first order, and the arguments are rounded once more.
            EXPECT_NEAR(found.value, wanted.value, 4.0 * (found.error + wanted.error));
        }
    }
}

TEST(Substitute, LeavesWhatIsNotReplaced) {
    Graph source;
    Graph target;
    const Expr formula = source.picture_x() * source.time() + source.variable(3);
    const Expr copy = substitute(target, std::span(&formula, 1), {}).front();
    EXPECT_TRUE(copy.same(target.picture_x() * target.time() + target.variable(3)));
    EXPECT_EQ(target.fresh_variable().node().detail, 4U);
}

TEST(Substitute, BringsTablesAlongAndSharesThem) {
    Graph source;
    Graph target;
    const std::array knots{1.0, 2.0};
    const std::array slopes{0.0, 3.0};
    const auto table = std::make_shared<const Table>(hermite_table(0.0, 1.0, knots, slopes));
    const Expr formula = source.lookup(table, source.picture_x());
    const Expr copy = substitute(target, std::span(&formula, 1), {}).front();
    EXPECT_TRUE(copy.same(target.lookup(table, target.picture_x())));
}

TEST(Substitute, FoldsWhatBecomesConstant) {
    Graph graph;
    const Expr formula = sin(graph.variable(0)) + cos(graph.variable(0));
    const Substitution zero{graph.variable(0), graph.constant(0.0)};
    EXPECT_TRUE(
        substitute(graph, std::span(&formula, 1), std::span(&zero, 1)).front().is_constant(1.0));
}

}  // namespace balcony::expr::substitute_test
