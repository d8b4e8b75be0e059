// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Derivatives against differences of neighbours, over the table of operations: a new operation is
// tested as it stands there.

#include <array>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "random_formula.hpp"

namespace balcony::expr::derivative_test {

namespace {

struct Slope {
    double value = 0.0;
    double error = 0.0;
};

// Ridders' method: central differences over shrinking steps, extrapolated to the step 0. The error
// is how far the last two extrapolations differ.
Slope numerical_slope(const std::function<double(double)>& f, double at) {
    constexpr int rows = 8;
    constexpr double shrink = 1.6;
    std::array<std::array<double, rows>, rows> table{};
    Slope best{0.0, std::numeric_limits<double>::infinity()};
    double step = 0.05;
    for (int i = 0; i < rows; ++i, step /= shrink) {
        table[0][i] = (f(at + step) - f(at - step)) / (2.0 * step);
        double factor = shrink * shrink;
        for (int k = 1; k <= i; ++k, factor *= shrink * shrink) {
            table[k][i] = (factor * table[k - 1][i] - table[k - 1][i - 1]) / (factor - 1.0);
            const double error = std::max(std::fabs(table[k][i] - table[k - 1][i]),
                                          std::fabs(table[k][i] - table[k - 1][i - 1]));
            if (error < best.error) {
                best = {table[k][i], error};
            }
        }
    }
    return best;
}

struct Comparison {
    int compared = 0;
    int tried = 0;
};

// Kinks, jumps and the ends of domains show in the error of the difference; they are left out, and
// so are formulas with a part that is not finite, as the graph's algebra may assume none.
void compare(Expr expression, double at, Comparison& count) {
    Graph& graph = expression.graph();
    const Expr derivative = differentiate(expression, graph.picture_x());
    const auto value = [](Expr e, double x) {
        return evaluate(std::span(&e, 1), {x, 0.5, 0.25, {}, further_input_values})[0];
    };
    const Slope wanted = numerical_slope([&](double x) { return value(expression, x); }, at);
    ++count.tried;
    const Bounded bounded = evaluate_bounded(expression, {at, 0.5, 0.25, {}, further_input_values});
    if (!std::isfinite(bounded.error)) {
        return;
    }
    const double scale = 1.0 + std::fabs(wanted.value);
    if (!(wanted.error < 1e-8 * scale)) {
        return;
    }
    ++count.compared;
    // Ten times what the method says of itself, and the rounding of the derivative.
    EXPECT_NEAR(value(derivative, at), wanted.value, 10.0 * wanted.error + 1e-12 * scale)
        << print(expression) << "at " << at << ", derivative\n"
        << print(derivative);
}

class EveryDerivative : public testing::TestWithParam<Operation> {};

std::vector<Operation> operations_on_arguments() {
    std::vector<Operation> rows;
    for (const Operation& row : operations()) {
        if (row.scalar != nullptr) {
            rows.push_back(row);
        }
    }
    return rows;
}

}  // namespace

// f(a(x), b(x), c(x)) with curved a, b, c, any of which may be constant, which is the chain rule by
// each argument and by all. Operations without a derivative are flat but for jumps.
TEST_P(EveryDerivative, EqualsTheDifferenceOfNeighbours) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> range(-2.5, 2.5);
    std::bernoulli_distribution constant(0.3);
    Comparison count;
    for (int i = 0; i < 600; ++i) {
        Graph graph;
        const Expr x = graph.picture_x();
        std::array<Expr, 3> arguments;
        for (Expr& argument : arguments) {
            argument = constant(random) ? graph.constant(range(random))
                                        : range(random) + range(random) * sin(x + range(random));
        }
        compare(graph.apply(GetParam().op,
                            std::span(arguments).first(static_cast<std::size_t>(GetParam().arity))),
                range(random), count);
    }
    // The narrowest domain, that of the inverse sine, is hit about one time in three.
    EXPECT_GT(count.compared, count.tried / 8);
}

INSTANTIATE_TEST_SUITE_P(Operations, EveryDerivative, testing::ValuesIn(operations_on_arguments()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Derive, RandomFormulasEqualTheDifferenceOfNeighbours) {
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> range(-2.0, 2.0);
    Comparison count;
    for (int i = 0; i < 2000; ++i) {
        Graph graph;
        compare(build(graph, random_formula(random, 12)), range(random), count);
    }
    EXPECT_GT(count.compared, count.tried / 2);
}

TEST(Derive, TakesEachBranchOfSelectMinimumAndMaximumAwayFromTheKink) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr kinked[] = {select(x < 1.0, x * x, sin(x)), min(x * x, sin(x)), max(x * x, sin(x)),
                           abs(x * x - 2.0)};
    for (const Expr expression : kinked) {
        for (const double at : {-2.0, -0.5, 0.4, 0.7, 1.2, 2.5}) {
            Comparison count;
            compare(expression, at, count);
            EXPECT_EQ(count.compared, 1);
        }
    }
}

TEST(Derive, SecondDerivativesAreDerivativesOfDerivatives) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr second = differentiate(differentiate(sin(x * x), x), x);
    const double at = 0.7;
    EXPECT_NEAR(evaluate(std::span(&second, 1), {at, 0.0, 0.0, {}})[0],
                2.0 * std::cos(at * at) - 4.0 * at * at * std::sin(at * at), 1e-15);
}

TEST(Derive, GoesByAnyLeafAndLeavesTheOthersAlone) {
    Graph graph;
    const Expr product = graph.picture_x() * graph.picture_y() * graph.time() * graph.variable(0);
    const std::array variables{7.0};
    const Point point{2.0, 3.0, 5.0, variables};
    const std::array slopes{
        differentiate(product, graph.picture_x()), differentiate(product, graph.picture_y()),
        differentiate(product, graph.time()), differentiate(product, graph.variable(0))};
    EXPECT_EQ(evaluate(slopes, point), (std::vector<double>{105.0, 70.0, 42.0, 30.0}));
    EXPECT_TRUE(differentiate(sin(graph.picture_x()), graph.time()).is_constant(0.0));
}

TEST(Derive, SignedPowerOfExponentOneHasTheSlopeOneAtZero) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr slope = differentiate(signed_power(x, graph.constant(1.0)), x);
    EXPECT_EQ(evaluate(std::span(&slope, 1), {})[0], 1.0);
}

}  // namespace balcony::expr::derivative_test
