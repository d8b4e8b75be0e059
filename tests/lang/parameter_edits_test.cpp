// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Other values for parameters that change from key to key.

#include <numbers>

#include <gtest/gtest.h>

#include "balcony/language_service.hpp"
#include "support.hpp"

namespace balcony::lang::parameter_edits_test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::string camera_with(const std::string& parameters) {
    return "camera a(" + parameters +
           ") {  // It stays.\n    map u = w .. -w, v = square\n    eye point(x, 0, 0)\n}\n";
}

EditedText text_of(const std::string& written) {
    return EditedText(std::make_shared<const SourceText>("test.cam", written));
}

// The text with values, or the error.
std::string with(const std::string& written, const std::vector<ParameterMove>& values,
                 const KeyTime& at, const std::string& camera = "a") {
    const EditedText text = text_of(written);
    const auto edits = text.with_values(camera, values, at);
    return edits ? test::edited(written, *edits) : edits.diagnostics.front().message;
}

// The parameters of camera_with() after a value for x.
std::string x_with(const std::string& x, double value, const KeyTime& at) {
    return with(camera_with("w = 0.5, x = " + x), {{"x", value, 0.01}}, at);
}
std::string x_is(const std::string& x) { return camera_with("w = 0.5, x = " + x); }

std::string without(const std::string& written, double time) {
    const EditedText text = text_of(written);
    const auto edits = text.without_keys("", {.time = time});
    return edits ? test::edited(written, *edits) : edits.diagnostics.front().message;
}

constexpr KeyTime begins(double time) { return {.time = time, .begins_keys = true}; }

}  // namespace

TEST(ParameterEdits, ANumberGetsKeys) {
    EXPECT_EQ(x_with("3", 5.0, begins(2.0)), x_is("keys((0, 3), (2, 5))"));
    EXPECT_EQ(x_with("1 + 2 /* three */", 5.0, begins(2.0)),
              x_is("keys((0, 1 + 2), (2, 5)) /* three */"));
    // Of the first frame, and without being asked to, it is another number.
    EXPECT_EQ(x_with("3", 5.0, begins(0.0)), x_is("5"));
    EXPECT_EQ(x_with("3", 5.0, {.time = 2.0}), x_is("5"));
    // As far as frames differ.
    EXPECT_EQ(x_with("3", 5.0, {.time = 1.0 / 24, .begins_keys = true}),
              x_is("keys((0, 3), (0.042, 5))"));
}

TEST(ParameterEdits, KeysAreReplacedAndInserted) {
    const std::string keys = "keys((0, 3), (2, 5),  (4, 6) /* last */, ease = smooth)";
    EXPECT_EQ(x_with(keys, 7.0, {.time = 2.0}),
              x_is("keys((0, 3), (2, 7),  (4, 6) /* last */, ease = smooth)"));
    EXPECT_EQ(x_with(keys, 7.0, {.time = 2.02}), x_with(keys, 7.0, {.time = 2.0}));
    EXPECT_EQ(x_with(keys, 7.0, {.time = 3.0}),
              x_is("keys((0, 3), (2, 5),  (3, 7), (4, 6) /* last */, ease = smooth)"));
    EXPECT_EQ(x_with(keys, 7.0, {.time = -1.0}),
              x_is("keys((-1, 7), (0, 3), (2, 5),  (4, 6) /* last */, ease = smooth)"));
    EXPECT_EQ(x_with(keys, 7.0, {.time = 5.0}),
              x_is("keys((0, 3), (2, 5),  (4, 6), (5, 7) /* last */, ease = smooth)"));
    EXPECT_EQ(x_with("keys([(0, 3), (2, 5)])", 7.0, {.time = 1.0}),
              x_is("keys([(0, 3), (1, 7), (2, 5)])"));
    EXPECT_EQ(x_with("keys(ease = hold, (0, 3))", 7.0, {.time = 1.0}),
              x_is("keys(ease = hold, (0, 3), (1, 7))"));
}

TEST(ParameterEdits, AnglesAndCallsKeepTheirForm) {
    const std::string turned =
        "camera a(turn = keys((0, 10deg), (1, 0.5rad))) {\n    map u = 1 .. -1, v = square\n"
        "    eye point(0, 0, turn)\n}\n";
    EXPECT_EQ(with(turned, {{"turn", 20 * degree, 0.01}}, {.time = 2.0}).substr(0, 59),
              "camera a(turn = keys((0, 10deg), (1, 0.5rad), (2, 20deg))) ");
    EXPECT_EQ(with(turned, {{"turn", 1.0, 0.01}}, {.time = 1.0}).substr(0, 46),
              "camera a(turn = keys((0, 10deg), (1, 1rad))) {");
    const std::string derived = camera_with("w = 0.5, x = 3") + "camera b = a(x = 4)\n";
    EXPECT_EQ(with(derived, {{"x", 5.0, 0.1}, {"w", 1.0, 0.1}}, begins(1.0), "b"),
              camera_with("w = 0.5, x = 3") +
                  "camera b = a(x = keys((0, 4), (1, 5)), w = keys((0, 0.5), (1, 1)))\n");
}

TEST(ParameterEdits, KeysThatAreNotWrittenOutStay) {
    for (const char* x : {"keys((0, 3), (2, 5), at = t/2)", "keys(\"path.csv\")", "2*t",
                          "keys((0, 3), (2, 5)) + 1"}) {
        EXPECT_EQ(x_with(x, 7.0, {.time = 1.0}), "'x' is not one number") << x;
        EXPECT_TRUE(text_of(x_is(x)).keys("a").empty()) << x;
    }
    // Nor calls with mistakes.
    for (const char* x : {"keys()", "keys([])", "keys(ease = smooth)", "keys(1, 2)",
                          "keys((0, 3), (2, 5), at = )"}) {
        const EditedText text = text_of(x_is(x));
        EXPECT_TRUE(text.keys("a").empty()) << x;
        EXPECT_FALSE(text.with_values("a", {{"x", 7.0, 0.01}}, {.time = 1.0})) << x;
        EXPECT_FALSE(text.without_keys("a", {})) << x;
    }
    EXPECT_EQ(with(camera_with("w = 1, x = 2"), {{"y", 1.0}}, {}),
              "the camera 'a' has no parameter 'y'");
}

TEST(ParameterEdits, TellsTheTimesOfKeys) {
    const EditedText text = text_of(camera_with("w = keys((1, 2)), x = keys((0, 3), (3/2, 5))"));
    const std::vector<ParameterKeys> keys = text.keys("");
    ASSERT_EQ(keys.size(), 2U);
    EXPECT_EQ(keys[0].parameter, "w");
    EXPECT_EQ(keys[0].times, (std::vector<double>{1.0}));
    EXPECT_EQ(keys[1].parameter, "x");
    EXPECT_EQ(keys[1].times, (std::vector<double>{0.0, 1.5}));
    EXPECT_TRUE(text.keys("other").empty());
    EXPECT_TRUE(text_of("camera a(").keys("").empty());
}

TEST(ParameterEdits, KeysAreTakenAway) {
    const std::string keys = x_is("keys((0, 3), (2, 5), (4, 6), ease = smooth)");
    EXPECT_EQ(without(keys, 0.0), x_is("keys((2, 5), (4, 6), ease = smooth)"));
    EXPECT_EQ(without(keys, 2.01), x_is("keys((0, 3), (4, 6), ease = smooth)"));
    EXPECT_EQ(without(keys, 4.0), x_is("keys((0, 3), (2, 5), ease = smooth)"));
    EXPECT_EQ(without(keys, 3.0), "no parameter has a key at 3 s");
    // What is left of two is a number.
    EXPECT_EQ(without(x_is("keys((0, 3), (2, 5))"), 0.0), x_is("5"));
    EXPECT_EQ(without(x_is("keys((0, 3), (2, 5))"), 2.0), x_is("3"));
    EXPECT_EQ(without(x_is("keys((0, 3))"), 0.0), x_is("3"));
    // Of all parameters.
    EXPECT_EQ(without(camera_with("w = keys((0, 1), (2, 2)), x = keys((0, 3), (2, 5))"), 2.0),
              camera_with("w = 1, x = 3"));
}

}  // namespace balcony::lang::parameter_edits_test
