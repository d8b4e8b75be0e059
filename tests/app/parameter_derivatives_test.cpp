// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/parameter_derivatives.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace balcony::app::parameter_derivatives_test {
namespace {

using Imath::V2d;
using Imath::V3d;

constexpr std::array<std::size_t, 2> size{200, 100};

// Sees a point (x, y, z) at 100 - 50 (y / x - turn) pixels from the left.
const auto text = std::make_shared<const SourceText>("turned.cam", R"(
    camera turned(turn = 0.25, list = (0, 0, 0), rise = 0) {
        map u = 2 .. -2, v = square
        eye point(0, 0, 0)
        toward surface(u, v) = [1, u + turn, v + rise]
        move translate(list)
    })");

lang::OpenPicture opened(const std::optional<std::vector<std::string>>& open = {}) {
    auto made = lang::Workspace().make_open_picture(text, "", {}, open);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return std::move(*made);
}

TEST(ParameterDerivatives, OfPositionsAreThoseOfTheFormula) {
    const lang::OpenPicture picture = opened(std::vector<std::string>{"turn"});
    const std::vector<V3d> points{{2, 1, 0}, {-2, 1, 0}, {4, -1, 0.5}};
    const auto locator = analyse::Locator::make(*lang::make_picture(text, ""), 200, 100);
    ASSERT_TRUE(locator) << to_text(locator.diagnostics);
    const auto made = position_derivatives(picture, {.size = size}, *locator, points);
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(made->by, std::vector<std::string>{"turn"});
    EXPECT_EQ(made->derivatives.valid, (std::vector<std::uint8_t>{1, 0, 1}));
    const std::vector<double> wanted{50, 0, 0, 0, 50, 0};
    ASSERT_EQ(made->derivatives.values.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_NEAR(made->derivatives.values[i], wanted[i], 1e-9) << i;
    }
}

TEST(ParameterDerivatives, AreInTheOrderThatIsAskedFor) {
    const std::vector<V3d> points{{2, 1, 0}};
    const auto locator = analyse::Locator::make(*lang::make_picture(text, ""), 200, 100);
    ASSERT_TRUE(locator) << to_text(locator.diagnostics);
    const auto by = [&](std::vector<std::string> names) {
        return position_derivatives(opened(), {.by = std::move(names), .size = size}, *locator,
                                    points);
    };
    const auto made = by({"rise", "turn"});
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(made->by, (std::vector<std::string>{"rise", "turn"}));
    // x by both, and y by both.
    const std::vector<double> wanted{0, 50, 50, 0};
    ASSERT_EQ(made->derivatives.values.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_NEAR(made->derivatives.values[i], wanted[i], 1e-9) << i;
    }
    EXPECT_EQ(by({"rise"})->by, (std::vector<std::string>{"rise", "turn"}));
    EXPECT_EQ(kind_of_errors(by({"rise", "rise"}).diagnostics), Kind::usage);
}

TEST(ParameterDerivatives, OfRaysAreInTheirAxes) {
    const lang::OpenPicture picture = opened(std::vector<std::string>{"turn"});
    const std::vector<V2d> points{{30.0, 20.0}, {170.5, 80.0}};
    const auto z_up = ray_derivatives(picture, {.size = size}, points);
    const auto y_up = ray_derivatives(picture, {.size = size, .axes = Axes::y_up}, points);
    ASSERT_TRUE(z_up && y_up);
    const std::vector<double>& before = z_up->derivatives.values;
    const std::vector<double>& after = y_up->derivatives.values;
    ASSERT_EQ(before.size(), 12U);
    for (std::size_t first = 0; first < 12; first += 3) {
        EXPECT_EQ(V3d(after[first], after[first + 1], after[first + 2]),
                  V3d(before[first], before[first + 2], -before[first + 1]));
    }
    EXPECT_NE(before[4], 0.0);
}

TEST(ParameterDerivatives, AreByNumbersThatAreOpen) {
    const std::vector<V2d> points{{30.0, 20.0}};
    const auto by = [&](const std::string& name) {
        return ray_derivatives(opened(std::vector{name}), {.by = std::vector{name}, .size = size},
                               points);
    };
    EXPECT_TRUE(by("turn"));
    EXPECT_EQ(kind_of_errors(by("list").diagnostics), Kind::usage);
    EXPECT_EQ(
        kind_of_errors(ray_derivatives(opened(), {.size = size, .layer = 3}, points).diagnostics),
        Kind::usage);
}

}  // namespace
}  // namespace balcony::app::parameter_derivatives_test
