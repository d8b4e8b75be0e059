// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "balcony/expr.hpp"

namespace balcony::expr::table_test {

namespace {

using Cubic = std::array<double, 4>;

double value(const Cubic& c, double x) { return ((c[3] * x + c[2]) * x + c[1]) * x + c[0]; }

double slope(const Cubic& c, double x) { return (3.0 * c[3] * x + 2.0 * c[2]) * x + c[1]; }

Table tabulated(const Cubic& c, double first, double last, std::size_t cells) {
    std::vector<double> values;
    std::vector<double> slopes;
    for (std::size_t i = 0; i <= cells; ++i) {
        const double x =
            first + (last - first) * static_cast<double>(i) / static_cast<double>(cells);
        values.push_back(value(c, x));
        slopes.push_back(slope(c, x));
    }
    return hermite_table(first, last, values, slopes);
}

}  // namespace

TEST(Table, IsExactOnCubicsInsideAndBeyondItsEnds) {
    std::mt19937_64 random(31);
    std::uniform_real_distribution<double> range(-2.0, 2.0);
    for (int i = 0; i < 200; ++i) {
        const Cubic c{range(random), range(random), range(random), range(random)};
        const double first = range(random);
        const double last = first + 0.5 + std::fabs(range(random));
        const Table table = tabulated(c, first, last, 1 + static_cast<std::size_t>(i) % 9);
        const Table slopes = table.derivative(0);
        for (int k = -5; k <= 25; ++k) {
            // Up to a quarter of the range beyond: the end cells go on.
            const double x = first + (last - first) * k / 20.0;
            // The values are of size 100 at most; a cell nine times shorter than the range
            // continued over two of its lengths makes a few hundred roundings of it.
            EXPECT_NEAR(table(x), value(c, x), 1e-11) << k;
            EXPECT_NEAR(slopes(x), slope(c, x), 1e-10) << k;
        }
    }
}

TEST(Table, TakesTheGivenValuesAndSlopesAtItsKnots) {
    const std::array values{1.0, -2.0, 4.0, 0.5};
    const std::array slopes{0.0, 3.0, -1.0, 2.0};
    const Table table = hermite_table(0.0, 6.0, values, slopes);
    const Table derivative = table.derivative(0);
    for (std::size_t i = 0; i < 4; ++i) {
        const double x = 2.0 * static_cast<double>(i);
        EXPECT_NEAR(table(x), values[i], 1e-14);
        EXPECT_NEAR(derivative(x), slopes[i], 1e-14);
    }
}

TEST(Table, StaysUndefinedWhereItsArgumentIs) {
    const Table table = tabulated({1.0, 2.0, 3.0, 4.0}, 0.0, 1.0, 4);
    EXPECT_TRUE(std::isnan(table(std::numeric_limits<double>::quiet_NaN())));
    for (const double far : {1e300, -1e300, std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()}) {
        EXPECT_FALSE(std::isfinite(table(far)));
    }
}

TEST(Lookup, IsOneNodeATableAndArgument) {
    Graph graph;
    const auto table = std::make_shared<const Table>(tabulated({1.0, 2.0, 0.0, 0.0}, 0.0, 1.0, 4));
    const Expr x = graph.picture_x();
    EXPECT_TRUE(graph.lookup(table, x).same(graph.lookup(table, x)));
    EXPECT_FALSE(
        graph.lookup(table, x).same(graph.lookup(std::make_shared<const Table>(*table), x)));
    EXPECT_TRUE(graph.lookup(table, graph.constant(0.5)).is_constant(2.0));
}

TEST(Lookup, HasTheDerivativeTableTimesTheInnerSlope) {
    Graph graph;
    const Cubic c{0.3, -1.0, 2.0, 0.7};
    const auto table = std::make_shared<const Table>(tabulated(c, -3.0, 3.0, 5));
    const Expr x = graph.picture_x();
    const Expr slopes = differentiate(graph.lookup(table, x * x), x);
    for (const double at : {-1.5, -0.2, 0.0, 0.9, 1.6}) {
        EXPECT_NEAR(evaluate(std::span(&slopes, 1), {at, 0.0, 0.0, {}})[0],
                    slope(c, at * at) * 2.0 * at, 1e-12);
    }
}

}  // namespace balcony::expr::table_test
