// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The points of an aperture.

#include "camera/lenses/disc.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace balcony::camera::disc_test {

namespace {

using std::numbers::pi;

class Disc {
public:
    Disc() {
        const PolarPoint made = on_disc({graph_.picture_x(), graph_.picture_y()}, Emitter(graph_));
        roots_ = {made.radius, made.angle};
    }
    struct Point {
        double radius, angle;
    };
    Point operator()(double x, double y) const {
        const std::vector<double> values = expr::evaluate(roots_, {x, y});
        return {values[0], values[1]};
    }

private:
    Graph graph_;
    std::array<Expr, 2> roots_;
};

}  // namespace

// Equal squares cover equal areas: the moments are those of a disc, and so is each of its sectors.
TEST(OnDisc, CoversItEvenly) {
    const Disc disc;
    constexpr int side = 128;
    constexpr int sectors = 16;
    std::array<double, sectors> parts{};
    double x1 = 0.0, y1 = 0.0, r2 = 0.0, x2 = 0.0;
    for (int i = 0; i < side; ++i) {
        for (int k = 0; k < side; ++k) {
            const auto at = [](int j) { return (2.0 * j + 1.0) / side - 1.0; };
            const auto [radius, angle] = disc(at(i), at(k));
            ASSERT_GE(angle, 0.0);
            ASSERT_LT(angle, 2.0 * pi);
            parts[static_cast<std::size_t>(angle / (2.0 * pi) * sectors)] += 1.0;
            const double x = radius * std::cos(angle);
            x1 += x;
            y1 += radius * std::sin(angle);
            x2 += x * x;
            r2 += radius * radius;
        }
    }
    constexpr double count = 1.0 * side * side;
    EXPECT_NEAR(x1 / count, 0.0, 1e-12);
    EXPECT_NEAR(y1 / count, 0.0, 1e-12);
    // The midpoint rule is exact to a square of a step of 2/side.
    constexpr double step = 2.0 / side;
    EXPECT_NEAR(r2 / count, 0.5, step * step);
    EXPECT_NEAR(x2 / count, 0.25, step * step);
    // A border of a sector passes through at most two of the side's squares in each row.
    for (const double part : parts) {
        EXPECT_NEAR(part / count, 1.0 / sectors, 2.0 * side / count);
    }
}

TEST(OnDisc, KeepsWhereTheAxesAndTheBorderAre) {
    const Disc disc;
    EXPECT_NEAR(disc(0.5, 0.0).angle, 0.0, 1e-15);
    EXPECT_NEAR(disc(0.0, 0.5).angle, 0.5 * pi, 1e-15);
    EXPECT_NEAR(disc(-0.5, 0.0).angle, pi, 1e-15);
    EXPECT_NEAR(disc(0.0, -0.5).angle, 1.5 * pi, 1e-15);
    EXPECT_NEAR(disc(1.0, 1.0).angle, 0.25 * pi, 1e-15);
    EXPECT_NEAR(disc(0.3, -0.7).radius, 0.7, 1e-15);
    EXPECT_EQ(disc(0.0, 0.0).radius, 0.0);
    EXPECT_TRUE(std::isfinite(disc(0.0, 0.0).angle));
}

}  // namespace balcony::camera::disc_test
