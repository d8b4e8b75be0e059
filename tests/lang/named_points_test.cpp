// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Names that stand for tuples and lists: a camera made with names is the camera made without.

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::lang::named_points_test {
namespace {

constexpr const char* written =
    "camera c { map u = 0 .. 1, v = 0.1 .. 1\n"
    "eye    { object catmull_rom([(-1, 0), (0, 2), (1, 0)]) move translate(1, 2, t) }\n"
    "toward { object disc(2) move rotate((1, 1, 0), 20deg), translate(5, 0, 0) } }";

void expect_same_rays(const camera::Camera& a, const camera::Camera& b) {
    for (const double x : {0.5, 20.0, 57.0, 99.5}) {
        const test::Ray one = test::ray(a, x, 30.0, 100.0, 50.0, 0.25);
        const test::Ray other = test::ray(b, x, 30.0, 100.0, 50.0, 0.25);
        ASSERT_TRUE(one.valid);
        EXPECT_EQ(one.origin, other.origin);
        EXPECT_EQ(one.direction, other.direction);
    }
}

camera::Camera made(const std::string& text, const std::vector<Override>& overrides = {},
                    std::string_view name = "") {
    Result<camera::Camera> camera = test::make(text, overrides, name);
    EXPECT_TRUE(camera && camera.diagnostics.empty()) << to_text(camera.diagnostics);
    return *camera;
}

std::string error_of(const std::string& text, const std::vector<Override>& overrides = {}) {
    const Result<camera::Camera> camera = test::make(text, overrides);
    EXPECT_FALSE(camera);
    EXPECT_EQ(camera.diagnostics.size(), 1U) << to_text(camera.diagnostics);
    return camera.diagnostics.empty() ? "" : camera.diagnostics.front().message;
}

const std::string with_parameters =
    "let end = (1, 0)\n"
    "camera c(path = [(0, 0), (1, 1), end], at = (0, 0, 0), axis = (0, 0, 1)) {\n"
    "    map u = 0 .. 1, v = 0.1 .. 1\n"
    "    eye    { object catmull_rom(path) move translate(at) }\n"
    "    toward { object disc(2) move rotate(axis, 20deg), translate(5, 0, 0) }\n"
    "}\n";

}  // namespace

TEST(NamedPoints, AreTheirValues) {
    expect_same_rays(made(written),
                     made("let far = 2\n"
                          "let path = [(-1, 0), top, (1, 0)]\n"
                          "let top = (0, far)\n"
                          "camera c { map u = 0 .. 1, v = 0.1 .. 1\n"
                          "let corner = (1, far, t)\n"
                          "let axis = (1, 1, 0)\n"
                          "eye    { object catmull_rom(path) move translate(corner) }\n"
                          "toward { object disc(2) move rotate(axis, 20deg), "
                          "translate((5, 0, 0)) } }"));
}

TEST(NamedPoints, ParametersMayBePoints) {
    const std::vector<Override> set = {
        {"path", "[(-1, 0), (0, 2), end]"}, {"at", "(1, 2, t)"}, {"axis", "(1, 1, 0)"}};
    expect_same_rays(made(written), made(with_parameters, set));
    const std::string layer =
        with_parameters +
        "picture p { layer c(path = [(-1, 0), (0, 2), end], at = (1, 2, t), axis = (1, 1, 0)) }";
    const auto picture =
        make_picture(std::make_shared<const SourceText>("test.cam", layer), "p", {});
    ASSERT_TRUE(picture) << to_text(picture.diagnostics);
    expect_same_rays(made(written),
                     std::get<camera::Camera>(picture->parts().layers.front().content));
}

TEST(NamedPoints, AParameterKeepsTheFormOfItsDefault) {
    EXPECT_EQ(error_of(with_parameters, {{"at", "3"}}),
              "'at' must be 3 numbers in parentheses, but this is a number");
    EXPECT_EQ(error_of(with_parameters, {{"at", "(1, 2)"}}),
              "'at' must be 3 numbers in parentheses, but this is 2 numbers in parentheses");
    EXPECT_EQ(error_of(with_parameters, {{"path", "(1, 2)"}}),
              "'path' must be a list, but this is 2 numbers in parentheses");
    EXPECT_EQ(error_of(with_parameters, {{"axis", "(0, 0, 1deg)"}}),
              "'axis' must be a plain number, but this is an angle");
}

TEST(NamedPoints, MismatchesAreReported) {
    const auto with = [](std::string_view statements) {
        return test::joined(
            {"let two = (1, 2) let three = (1, 2, 3) let many = [two, two]\n"
             "camera c { map u = 0 .. 1, v = 0 .. 1 ",
             statements, " }"});
    };
    EXPECT_EQ(error_of(with("eye sphere(1 + two)")),
              "expected a number, but 'two' is 2 numbers in parentheses");
    EXPECT_EQ(error_of(with("eye sphere(many)")),
              "'radius' of 'sphere' takes a number, but this is a list");
    EXPECT_EQ(error_of(with("eye disc(2) move translate(three, 4)")),
              "'translate' takes 3 arguments, but 4 are given");
    EXPECT_EQ(error_of(with("eye disc(2) move translate(three, x = 4)")), "'x' is given twice");
    EXPECT_EQ(error_of(with("eye disc(2) move rotate(two, 3deg)")),
              "'axis' of 'rotate' takes three numbers (a, b, c) or x, y or z, but there are 2");
    EXPECT_EQ(error_of(with("eye bezier(three)")), "'points' of 'bezier' takes a list of points");
    EXPECT_EQ(error_of(with("eye bezier(tow)")), "unknown name 'tow'");
    EXPECT_EQ(error_of(with("eye bezier(3)")), "'points' of 'bezier' takes a list of points");
    EXPECT_EQ(error_of(with("eye bezier([two, many])")),
              "a list contains numbers or points, but this is a list");
    EXPECT_EQ(error_of(with("eye bezier([[1, 2], two])")),
              "a list contains numbers or points, but this is a list");
    EXPECT_EQ(error_of(with("eye bezier([two, (two, 1)])")),
              "expected a number, but 'two' is 2 numbers in parentheses");
}

// What is wrong with a point is shown where the point is written and where it is used.
TEST(NamedPoints, AWrongPointIsShownWithItsUse) {
    const Result<camera::Camera> camera = test::make(
        "let  path = [(0, 0), (1, 5deg)]\n"
        "camera c { map u = 0 .. 1, v = 0 .. 1 eye bezier(path) }");
    ASSERT_FALSE(camera);
    EXPECT_EQ(
        to_text(camera.diagnostics),
        "test.cam:1:26: error: 'points' of 'bezier' must be a plain number, but this is an angle\n"
        "    1 | let  path = [(0, 0), (1, 5deg)]\n"
        "      |                          ^~~~\n"
        "test.cam:2:50: note: used here\n"
        "    2 | camera c { map u = 0 .. 1, v = 0 .. 1 eye bezier(path) }\n"
        "      |                                                  ^~~~\n"
        "  help: remove deg or rad, or divide the angle by 1rad\n");
}

TEST(NamedPoints, CauseAWarningIfUnused) {
    const Result<camera::Camera> camera = test::make(
        "camera c(at = (1, 2, 3)) { let path = [1, 2] map u = 0 .. 1, v = square eye plane }");
    ASSERT_TRUE(camera);
    ASSERT_EQ(camera.diagnostics.size(), 2U);
    EXPECT_EQ(camera.diagnostics[0].message, "the parameter 'at' is unused");
    EXPECT_EQ(camera.diagnostics[1].message, "the let 'path' is unused");
}

}  // namespace balcony::lang::named_points_test
