// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "balcony/expr.hpp"

namespace balcony::expr::power_test {

namespace {

bool contains(Expr root, Op op) {
    for (const NodeId id : reachable(root.graph(), std::span(&root, 1))) {
        if (root.graph()[id].op == op) {
            return true;
        }
    }
    return false;
}

double value(Expr e, double x) { return evaluate(std::span(&e, 1), {x, 0.0, 0.0, {}})[0]; }

}  // namespace

TEST(Power, EighthsUpTo64BecomeProductsAndRootsWithinTheirBound) {
    std::mt19937_64 random(21);
    std::uniform_real_distribution<double> logarithm(-5.0, 5.0);
    for (int eighths = -512; eighths <= 512; ++eighths) {
        const double p = eighths / 8.0;
        Graph graph;
        const Expr power = pow(graph.picture_x(), p);
        ASSERT_FALSE(contains(power, Op::power)) << p;
        for (int i = 0; i < 50; ++i) {
            const double x = std::exp(logarithm(random));
            // 64 bits of mantissa: its own error is 2^-11 of a unit in the last place.
            const long double wanted =
                powl(static_cast<long double>(x), static_cast<long double>(p));
            const double unit =
                std::nextafter(static_cast<double>(wanted), HUGE_VAL) - static_cast<double>(wanted);
            EXPECT_LE(std::fabs(static_cast<double>(value(power, x) - wanted)),
                      (std::fabs(p) + 3.0) * unit)
                << x << '^' << p;
        }
    }
}

TEST(Power, WholeExponentsTakeNegativeBases) {
    Graph graph;
    for (int p = -7; p <= 7; ++p) {
        const Expr power = pow(graph.picture_x(), static_cast<double>(p));
        EXPECT_DOUBLE_EQ(value(power, -1.7), std::pow(-1.7, p));
    }
}

TEST(Power, FractionsOfNegativeBasesAreUndefined) {
    Graph graph;
    for (const double p : {0.125, 0.5, 1.25, 2.875, -0.5}) {
        EXPECT_TRUE(std::isnan(value(pow(graph.picture_x(), p), -1.7))) << p;
    }
}

TEST(Power, OtherExponentsStay) {
    Graph graph;
    for (const double p : {0.1, 1.0 / 3.0, 64.125, -65.0}) {
        EXPECT_TRUE(contains(pow(graph.picture_x(), p), Op::power)) << p;
    }
    EXPECT_TRUE(contains(pow(graph.picture_x(), graph.time()), Op::power));
}

TEST(Power, EvenPowersNeedNoAbsoluteValue) {
    Graph graph;
    const Expr x = graph.picture_x();
    EXPECT_TRUE(pow(abs(x), 8.0).same(pow(x, 8.0)));
    EXPECT_FALSE(pow(abs(x), 3.0).same(pow(x, 3.0)));
}

TEST(SignedPower, IsOddAndOfThePowerOfTheSize) {
    Graph graph;
    for (const double p : {0.25, 1.0, 1.5, 2.0, 0.3}) {
        const Expr power = signed_power(graph.picture_x(), graph.constant(p));
        for (const double x : {0.0, 0.3, 1.0, 4.0}) {
            // Either form of the power may be off by its few units in the last place.
            EXPECT_NEAR(value(power, x), std::pow(x, p), 1e-15 * (1.0 + std::pow(x, p)));
            EXPECT_EQ(value(power, -x), -value(power, x));
        }
    }
}

}  // namespace balcony::expr::power_test
