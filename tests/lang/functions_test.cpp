// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Functions that files define, and elements of lists and tuples.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../files/temporary_folder.hpp"
#include "support.hpp"

namespace balcony::lang::functions_test {

namespace {

// The origin of the central ray of a camera whose eye is at a point.
std::array<double, 3> eye_at(const std::string& lets, const std::string& coordinates,
                             double time = 0.0) {
    const auto camera =
        test::make(test::joined({lets, "\ncamera c { map u = 1 .. -1, v = square eye point(",
                                 coordinates, ") toward plane((1, 0, 0)) }"}));
    EXPECT_TRUE(camera) << to_text(camera.diagnostics);
    return camera ? test::ray(*camera, 50.0, 50.0, 100.0, 100.0, time).origin
                  : std::array<double, 3>{};
}

std::string first_error(const std::string& text) {
    const auto made = test::make(text);
    EXPECT_FALSE(made) << text;
    return made.diagnostics.empty() ? "" : made.diagnostics.front().message;
}

std::vector<std::string> warnings_of(const std::string& text) {
    std::vector<std::string> messages;
    for (const Diagnostic& found : test::make(text).diagnostics) {
        messages.push_back(found.message);
    }
    return messages;
}

constexpr const char* camera_with = "\ncamera c { map u = -1 .. 1, v = square eye sphere(";

}  // namespace

TEST(Functions, AreFormulasOfTheirParameters) {
    const auto at = eye_at("let half(x) = x/2  let ratio(x, y) = half(x)/y",
                           "half(6), ratio(2, 4), half(half(8))");
    EXPECT_EQ(at, (std::array{3.0, 0.25, 2.0}));
}

TEST(Functions, TakeAndGivePointsAndLists) {
    const std::string lets =
        "let turned(p) = (-p[1], p[0], 0)\n"
        "let third(list) = list[2]\n"
        "let row(y) = [(0, y), (1, y), (2, y)]\n";
    EXPECT_EQ(eye_at(lets, "turned((4, 5))"), (std::array{-5.0, 4.0, 0.0}));
    EXPECT_EQ(eye_at(lets, "turned(third(row(7)))"), (std::array{-7.0, 2.0, 0.0}));
    EXPECT_EQ(eye_at(lets, "third([1, 2, 3]), row(5)[1][1]"), (std::array{3.0, 5.0, 0.0}));
}

TEST(Functions, UseTheNamesAroundTheirDefinition) {
    const auto at = eye_at("let scale = 10  let big(x) = scale*x + t", "big(1), big(t)", 2.0);
    EXPECT_EQ(at, (std::array{12.0, 22.0, 0.0}));
    const auto camera = test::make(
        "let scale = 10  let big(x) = scale*x\n"
        "camera c(scale = 2) { map u = 1 .. -1, v = square eye point(big(scale), scale) "
        "toward plane((1, 0, 0)) }");
    ASSERT_TRUE(camera) << to_text(camera.diagnostics);
    EXPECT_EQ(test::ray(*camera, 50.0, 50.0, 100.0, 100.0).origin, (std::array{20.0, 2.0, 0.0}))
        << "not those around the call";
}

TEST(Functions, HideBuiltInOnesAndParametersHideNames) {
    EXPECT_EQ(eye_at("let max(a, b, c) = a + b + c", "max(1, 2, 3)")[0], 6.0);
    EXPECT_EQ(eye_at("let x = 5  let same(x) = x", "same(1), x"), (std::array{1.0, 5.0, 0.0}));
}

TEST(Functions, StandInFormulasOfStages) {
    const auto camera = test::make(
        "let wave(u, height) = height*cos(u)\n"
        "let circle_at(u) = (cos(u), sin(u))\n"
        "camera c { map u = 180deg .. -180deg, v = -1 .. 1\n"
        "           eye surface(u, v) = [circle_at(u), wave(u, v)] }");
    ASSERT_TRUE(camera) << to_text(camera.diagnostics);
    // A quarter from the left and from the bottom: u is 90deg, v is -0.5.
    const auto origin = test::ray(*camera, 25.0, 75.0, 100.0, 100.0).origin;
    EXPECT_NEAR(origin[0], 0.0, 1e-15);
    EXPECT_NEAR(origin[1], 1.0, 1e-15);
    EXPECT_NEAR(origin[2], 0.0, 1e-15);
}

TEST(Functions, KeepUnits) {
    EXPECT_NEAR(eye_at("let turn(n) = n*90deg", "sin(turn(1)), turn(2)/1rad")[1], std::numbers::pi,
                1e-15);
    EXPECT_EQ(first_error(test::joined({"let more(x) = x + 30deg", camera_with, "more(2)) }"})),
              "'+' combines an angle and a plain number");
}

// An error in a function is at its place in the function, with the call in a note.
TEST(Functions, ReportErrorsWhereTheyAreAndWhereTheyAreCalled) {
    const auto made = test::make(test::joined(
        {"let inverse(x) = 1/x  let twice(x) = 2*inverse(x)", camera_with, "twice(0)) }"}));
    ASSERT_EQ(made.diagnostics.size(), 1U) << to_text(made.diagnostics);
    EXPECT_EQ(made.diagnostics[0].message, "division by 0");
    ASSERT_EQ(made.diagnostics[0].notes.size(), 2U);
    EXPECT_EQ(made.diagnostics[0].notes[1].message, "in this call of 'twice'");
}

TEST(Functions, MayHaveAnErrorThatAConditionExcludes) {
    EXPECT_EQ(
        eye_at("let inverse(x) = 1/x  let safe(x) = if(x == 0, 7, inverse(x))", "safe(0), safe(4)"),
        (std::array{7.0, 0.25, 0.0}));
}

TEST(Functions, AreCheckedWithoutACall) {
    EXPECT_EQ(first_error(test::joined({"let f(x) = x + nothing", camera_with, "1) }"})),
              "unknown name 'nothing'");
}

TEST(Functions, CannotBeRecursive) {
    EXPECT_EQ(first_error("let f(n) = if(n == 0, 1, n*f(n - 1))"),
              "the function 'f' is recursive: f -> f");
    EXPECT_EQ(first_error("let f(n) = g(n)  let g(n) = h  let h = f(1)"),
              "the function 'f' is recursive: f -> g -> h -> f");
    // A parameter is not the function of the same name.
    EXPECT_EQ(eye_at("let f(g) = g + 1  let g = f(2)", "g")[0], 3.0);
}

TEST(Functions, AreCalledWithAllTheirParameters) {
    const std::string lets = "let f(x, y) = x + y";
    EXPECT_EQ(first_error(test::joined({lets, camera_with, "f(1)) }"})),
              "'f' takes 2 arguments, but 1 is given");
    EXPECT_EQ(first_error(test::joined({lets, camera_with, "f(1, y = 2)) }"})),
              "the function 'f' takes no named arguments");
    EXPECT_EQ(first_error(test::joined({lets, camera_with, "f) }"})), "'f' is a function");
    EXPECT_EQ(first_error(test::joined({"let w = 2", camera_with, "w(1)) }"})),
              "'w' is a number and cannot be called");
}

TEST(Functions, AreWarnedAboutIfUnused) {
    EXPECT_EQ(warnings_of(test::joined({"let f(x) = x", camera_with, "1) }"})),
              std::vector<std::string>{"the function 'f' is unused"});
    EXPECT_EQ(warnings_of("camera c { let f(x, y) = x map u = -1 .. 1, v = square "
                          "eye sphere(f(1, 2)) }"),
              std::vector<std::string>{"the parameter 'y' is unused"});
}

TEST(Functions, AreImported) {
    const files::TemporaryFolder folder;
    folder.write("shapes.cam", "let unit = 2  let doubled(x) = unit*x");
    const auto file = folder.write(
        "c.cam", test::joined({"import \"shapes.cam\"", camera_with, "doubled(3)) }"}));
    EXPECT_TRUE(test::check(file).empty()) << to_text(test::check(file));
}

// Functions that call others several times would need any amount of time.
TEST(Functions, HaveBoundedWork) {
    std::string lets = "let f0(x) = x + t\n";
    for (int i = 1; i < 40; ++i) {
        const std::string below = "f" + std::to_string(i - 1);
        lets += test::joined({"let f", std::to_string(i), "(x) = ", below, "(", below, "(x))\n"});
    }
    EXPECT_EQ(first_error(test::joined({lets, camera_with, "f39(1)) }"})),
              "the calls of functions have more than 4000000 operations");
}

TEST(Functions, NeedNoStack) {
    std::string lets = "let f0(x) = x\n";
    for (int i = 1; i < 5000; ++i) {
        lets += test::joined(
            {"let f", std::to_string(i), "(x) = f", std::to_string(i - 1), "(x) + 1\n"});
    }
    EXPECT_EQ(first_error(test::joined({lets, camera_with, "f4999(1)) }"})),
              "calls of functions are nested more than 400 levels deep");
}

TEST(Elements, AreCountedFromZero) {
    const std::string lets = "let list = [(1, 2), (3, 4)]  let point = (5, 6, 7)";
    EXPECT_EQ(eye_at(lets, "list[1][0], point[2], list[2 - 1][1]"), (std::array{3.0, 7.0, 4.0}));
    EXPECT_EQ(first_error(test::joined({lets, camera_with, "point[3]) }"})),
              "the index of an element is a whole number from 0 to 2, but this is 3");
    EXPECT_EQ(first_error(test::joined({lets, camera_with, "point[t]) }"})),
              "the index of an element is a whole number from 0 to 2, but this is not constant");
    EXPECT_EQ(first_error(test::joined({lets, camera_with, "point) }"})),
              "'radius' of 'sphere' takes a number, but there are 3");
    EXPECT_EQ(first_error(test::joined({lets, camera_with, "2*point) }"})),
              "expected a number, but 'point' is 3 numbers in parentheses");
    EXPECT_EQ(first_error(test::joined({"let w = 1", camera_with, "w[0]) }"})),
              "'w' is a number, which has no elements");
}

}  // namespace balcony::lang::functions_test
