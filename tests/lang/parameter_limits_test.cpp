// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The limits of parameters: fov = 60deg above 0 to 179deg.

#include <gtest/gtest.h>

#include <numbers>

#include "support.hpp"

namespace balcony::lang::parameter_limits_test {
namespace {

// Its rays start at x, where x is between its limits.
const std::string at_x =
    "camera a(x = 1 from 0 to 4, angle = 30deg above 0 to limit) {\n"
    "    map u = -angle .. angle, v = square\n"
    "    eye point(x, 0, 0)\n"
    "    toward sphere(1)\n"
    "    move translate(0, 0, 0)\n"
    "}\n"
    "let limit = 180deg\n";

double start(const camera::Camera& camera, double time = 0.0) {
    return test::ray(camera, 8, 4.5, 16, 9, time).origin[0];
}

TEST(ParameterLimits, AreInclusiveUnlessTheyAreAbove) {
    for (const char* x : {"0", "2.5", "4"}) {
        EXPECT_TRUE(test::make(at_x, {{"x", x}})) << x;
    }
    EXPECT_TRUE(test::make(at_x, {{"angle", "180deg"}}));
    const auto beyond = test::make(at_x, {{"x", "4.25"}});
    ASSERT_FALSE(beyond);
    EXPECT_EQ(beyond.diagnostics.front().message, "'x' must be from 0 to 4, but is 4.25");
    EXPECT_EQ(beyond.diagnostics.front().remedy, "its default is 1");
    EXPECT_FALSE(test::make(at_x, {{"x", "-1e-9"}}));
    const auto zero = test::make(at_x, {{"angle", "0"}});
    ASSERT_FALSE(zero);
    EXPECT_EQ(zero.diagnostics.front().message,
              "'angle' must be above 0deg and at most 180deg, but is 0deg");
}

TEST(ParameterLimits, AreCheckedWhereverAValueIsGiven) {
    for (const char* text : {"picture p { layer a(x = 5) }", "camera b = a(x = 5)",
                             "camera b { morph a .. a(x = 5), amount = 0.5 }"}) {
        const auto found =
            Workspace().make_all(std::make_shared<const SourceText>("test.cam", at_x + text));
        ASSERT_FALSE(found) << text;
        EXPECT_EQ(found.diagnostics.front().message, "'x' must be from 0 to 4, but is 5");
    }
}

TEST(ParameterLimits, HoldWhatChangesWithTime) {
    const auto made = test::make(at_x, {{"x", "keys((0, 1), (2, 3), (4, 7))"}});
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(start(*made, 1.0), 2.0);
    EXPECT_EQ(start(*made, 3.0), 4.0);
    EXPECT_EQ(start(*made, 9.0), 4.0);
    ASSERT_EQ(made.diagnostics.size(), 1U);
    EXPECT_EQ(made.diagnostics.front().severity, Severity::warning);
    EXPECT_EQ(made.diagnostics.front().message, "'x' must be from 0 to 4, but is 7 at t = 4");
    EXPECT_EQ(made.diagnostics.front().remedy, "it is held at 4");

    const auto within = test::make(at_x, {{"x", "keys((0, 1), (2, 3), (4, 4))"}});
    ASSERT_TRUE(within);
    EXPECT_EQ(to_text(within.diagnostics), "");
    EXPECT_EQ(start(*within, 3.0), 3.5);

    const auto without_keys = test::make(at_x, {{"x", "t"}});
    ASSERT_TRUE(without_keys);
    EXPECT_EQ(start(*without_keys, -3.0), 0.0);
}

TEST(ParameterLimits, LeaveOutAFitBeyondThem) {
    const std::string fitted =
        "camera a(x = 1 from 0 to 4) { map u = -1 .. 1, v = square eye point(x, 0, 0) toward "
        "sphere(1) fit x = scene_radius }";
    Workspace workspace;
    const auto text = std::make_shared<const SourceText>("test.cam", fitted);
    for (const auto& [radius, x] : {std::pair{3.0, 3.0}, std::pair{5.0, 1.0}}) {
        workspace.fit_to(SceneMeasures{.radius = radius});
        const auto made = workspace.make_camera(text);
        ASSERT_TRUE(made) << to_text(made.diagnostics);
        EXPECT_EQ(start(*made), x);
    }
}

TEST(ParameterLimits, AreTold) {
    const auto text = std::make_shared<const SourceText>("test.cam", at_x);
    const auto said = Workspace().describe(text);
    ASSERT_TRUE(said) << to_text(said.diagnostics);
    const Description::Parameter& angle = said->front().parameters[1];
    EXPECT_EQ(angle.limits_text, "above 0 to limit");
    EXPECT_EQ(angle.limits.minimum, 0.0);
    EXPECT_TRUE(angle.limits.excludes_minimum);
    EXPECT_DOUBLE_EQ(angle.limits.maximum, std::numbers::pi);
    const auto open = Workspace().make_open_camera(text, "", {});
    ASSERT_TRUE(open) << to_text(open.diagnostics);
    ASSERT_FALSE(open->open.empty());
    EXPECT_EQ(open->open.front().limits.maximum, 4.0);
}

}  // namespace
}  // namespace balcony::lang::parameter_limits_test
