// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "balcony/expr.hpp"

namespace balcony::expr::simplify_test {

namespace {

// The operations that a grid of points must do at every point.
std::size_t pixel_operations(std::span<const Expr> roots) {
    std::size_t count = 0;
    for (const NodeId id : reachable(roots.front().graph(), roots)) {
        const Expr node(roots.front().graph(), id);
        count += operation(node.op()).arity > 0 && node.rate() == Rate::pixel ? 1 : 0;
    }
    return count;
}

std::size_t operations_in(std::span<const Expr> roots) {
    std::size_t count = 0;
    for (const NodeId id : reachable(roots.front().graph(), roots)) {
        count += operation(roots.front().graph()[id].op).arity > 0 ? 1 : 0;
    }
    return count;
}

Expr simplified(Expr e) { return simplify(std::span(&e, 1)).front(); }

std::size_t pixel_operations(Expr e) { return pixel_operations(std::span(&e, 1)); }

}  // namespace

// Joined, the coefficients would be 0 and the term gone with them, were it ever so large.
TEST(Simplify, KeepsTermsWhoseJoinedCoefficientsUnderflow) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    const double infinity = std::numeric_limits<double>::infinity();
    const auto at = [](Expr e, double column, double row) {
        return evaluate(std::span(&e, 1), {column, row, 0.0, {}}).front();
    };
    const Expr scaled_x = 1e-200 * x;
    const Expr square = simplified(scaled_x * scaled_x + y * y);
    EXPECT_NEAR(at(square, 1e200, 0.0), 1.0, 1e-15) << print(square);
    EXPECT_EQ(at(square, infinity, 0.0), infinity) << print(square);
    const Expr twice_scaled = simplified(1e-200 * scaled_x);
    EXPECT_EQ(at(twice_scaled, infinity, 0.0), infinity) << print(twice_scaled);
    const Expr multiple = simplified(1e-200 * (scaled_x + y));
    EXPECT_EQ(at(multiple, infinity, 0.0), infinity) << print(multiple);
    const Expr quotient = simplified((scaled_x * sin(y)) / (1e200 * y));
    EXPECT_EQ(at(quotient, infinity, 1.0), infinity) << print(quotient);
}

TEST(Simplify, CollapsesAffineChainsOfAnyLength) {
    for (const int length : {1, 2, 10, 1000}) {
        Graph graph;
        std::mt19937_64 random(51);
        std::uniform_real_distribution<double> range(0.5, 1.5);
        Expr chain = graph.picture_x();
        for (int i = 0; i < length; ++i) {
            chain = (chain + range(random)) * range(random) - range(random) * chain / 3.0;
        }
        const Expr simple = simplified(chain);
        EXPECT_LE(operations_in(std::span(&simple, 1)), 2U) << print(simple);
    }
}

TEST(Simplify, CollapsesChainsOfMapsOfThePlane) {
    for (const int length : {1, 3, 300}) {
        Graph graph;
        Expr u = graph.picture_x();
        Expr v = graph.picture_y();
        for (int i = 0; i < length; ++i) {
            const Expr turned_u = 0.8 * u - 0.6 * v + 0.3;
            v = 0.6 * u + 0.8 * v - 0.1 * i;
            u = turned_u;
        }
        const std::array roots{u, v};
        const std::vector<Expr> simple = simplify(roots);
        // Of a x + b y + c only the sum of the column's and the row's part is left at a point.
        EXPECT_LE(pixel_operations(simple), 2U) << length;
        EXPECT_LE(operations_in(simple), 8U) << length;
    }
}

TEST(Simplify, SeparatesProductsByRate) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    EXPECT_EQ(pixel_operations(simplified(sin(x) * cos(y) * exp(x) * y * graph.time() * x)), 1U);
    EXPECT_EQ(pixel_operations(simplified((sin(x) * y) * ((2.0 * cos(y)) * -x))), 1U);
    EXPECT_EQ(pixel_operations(simplified(sin(x) * cos(y) / (1.0 + x * x))), 1U);
}

TEST(Simplify, OrdersSumsByRate) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    EXPECT_EQ(pixel_operations(simplified(sin(x) + cos(y) + exp(x) + y + 3.0 + graph.time())), 1U);
}

TEST(Simplify, TakesCommonFactorsOutOfSums) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    EXPECT_EQ(pixel_operations(simplified(sin(x) * y + 3.0 * (cos(x) * y) - exp(x) * y)), 1U);
    EXPECT_EQ(pixel_operations(simplified(x * sin(y) + 3.0 * (x * cos(y)) - x * exp(y))), 1U);
}

TEST(Simplify, CollectsEqualTerms) {
    Graph graph;
    const Expr f = sin(graph.picture_x() * graph.picture_y());
    EXPECT_TRUE(simplified(f + 2.0 * f - 3.0 * f).is_constant(0.0));
    EXPECT_TRUE(simplified((f + 1.0) - f).is_constant(1.0));
    EXPECT_TRUE(simplified((f + graph.time()) - graph.time()).same(f));
}

TEST(Simplify, KeepsWhatSeveralRootsShare) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    const Expr shared = sin(x + y) + cos(x * y);
    const std::array roots{shared * 2.0 + 1.0, shared * 3.0 + 1.0, shared};
    // sin, x + y, cos, x y, their sum, and a product and a sum for each of two roots.
    EXPECT_LE(pixel_operations(simplify(roots)), 9U);
    const Expr sum = x + y;
    EXPECT_EQ(operations_in(simplify(std::array{sum, 3.0 * sum})), 2U);
}

TEST(Simplify, GivesNothingForNothing) { EXPECT_TRUE(simplify({}).empty()); }

}  // namespace balcony::expr::simplify_test
