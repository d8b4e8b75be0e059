// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Each value is computed as often as it must be and no more.

#include <array>

#include <gtest/gtest.h>

#include "program/tape.hpp"

namespace balcony::program::rates_test {

using expr::Expr;
using expr::Graph;

TEST(Rates, FollowTheInputsOfARoot) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    const std::vector<Expr> roots{graph.constant(3.0), sin(graph.time()), sin(x), exp(y),
                                  atan2(x, y)};
    const Program program(roots);
    ASSERT_EQ(program.root_count(), 5U);
    EXPECT_EQ(program.rate(0), Rate::uniform);
    EXPECT_EQ(program.rate(1), Rate::uniform);
    EXPECT_EQ(program.rate(2), Rate::column);
    EXPECT_EQ(program.rate(3), Rate::row);
    EXPECT_EQ(program.rate(4), Rate::pixel);
    EXPECT_EQ(program.instruction_count(Rate::uniform), 1U);
    EXPECT_EQ(program.instruction_count(Rate::column), 1U);
    EXPECT_EQ(program.instruction_count(Rate::row), 1U);
    EXPECT_EQ(program.instruction_count(Rate::pixel), 1U);
}

TEST(Rates, TheCurvesOfASphericalProductRunPerColumnAndRow) {
    Graph graph;
    const Expr u = 0.01 * graph.picture_x() - 1.0;
    const Expr v = 0.02 * graph.picture_y() + 0.5;
    const Expr radius = pow(pow(abs(cos(u)), 8.0) + pow(abs(sin(u)), 8.0), -0.125);
    const Expr g1 = radius * cos(u);
    const Expr g2 = radius * sin(u);
    const Expr h1 = exp(sin(v));
    const Expr h2 = log(2.0 + cos(v));
    const std::vector<Expr> roots{g1 * h1, g2 * h1, h2};
    const Program program(roots);
    EXPECT_EQ(program.rate(0), Rate::pixel);
    EXPECT_EQ(program.rate(1), Rate::pixel);
    EXPECT_EQ(program.rate(2), Rate::row);
    EXPECT_EQ(program.instruction_count(Rate::pixel), 2U);  // the two products
}

TEST(Rates, AChainOfPixelValuesTakesFewRegisters) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    Expr chain = x;
    for (int i = 0; i < 1000; ++i) {
        chain = max(sqrt(abs(chain)), y);
    }
    const std::vector<Expr> roots{chain};
    const Program program(roots);
    // Two registers of a row of points, one of x and y each, a few uniform ones.
    EXPECT_LE(program.tape().register_doubles, 5 * max_tile_width);
}

TEST(Rates, ARootOfNothingIsAllowed) {
    const Program program(std::span<const Expr>{});
    EXPECT_EQ(program.root_count(), 0U);
    Scratch scratch;
    run(program, {.width = 3, .height = 3}, scratch, {});
    run_reference(program, {.width = 3, .height = 3}, {});
}

}  // namespace balcony::program::rates_test
