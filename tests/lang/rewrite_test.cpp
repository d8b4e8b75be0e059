// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Values that are written into the text of a camera file, by their laws: equal values leave the
// text as it is, and the text that has others reads as these bit for bit.

#include <bit>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "support.hpp"

namespace balcony::lang::rewrite_test {
namespace {

const std::string file = R"(// A file with much around its numbers.
let third = 1/3

/* Two */ camera tube(fov = 60deg above 0 to 179deg,  // the field of view
            turn = 0.5rad, gamma = third, from = (1, 2, 3)) {
    let half = tan(fov/2)
    map    u = half .. -half, v = square
    eye    point(0, 0, gamma)
    toward plane((1, 0, 0))   // as usual
    move   rotate(z, turn), translate(from)
}

camera wide = tube(fov = 100deg  // wider
)
camera same = tube
)";

CameraSource source(const std::string& text) {
    return {std::make_shared<const SourceText>("test.cam", text)};
}

std::string rewritten(const std::string& text, const std::string& name,
                      const std::vector<Override>& values) {
    const auto made = Workspace().with_values(source(text), name, values);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return made ? *made : "";
}

OpenCamera open(const std::string& text, const std::string& name) {
    auto made = Workspace().make_open_camera(source(text), name, {});
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return made ? std::move(*made)
                : OpenCamera{test::make("camera a = pinhole").value.value(), {}, {}, {}};
}

std::vector<Override> values_of(const OpenCamera& camera) {
    std::vector<Override> values;
    for (const OpenParameter& one : camera.open) {
        values.push_back({one.name, one.written});
    }
    return values;
}

double value_of(const std::string& text, const std::string& camera, const std::string& name) {
    for (const OpenParameter& one : open(text, camera).open) {
        if (one.name == name) {
            return one.value;
        }
    }
    ADD_FAILURE() << name;
    return 0.0;
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), by);
}

}  // namespace

TEST(Rewrite, EqualValuesLeaveTheTextAsItIs) {
    for (const std::string name : {"tube", "wide"}) {
        EXPECT_EQ(rewritten(file, name, {}), file);
    }
    EXPECT_EQ(rewritten(file, "tube", values_of(open(file, "tube"))), file);
    EXPECT_EQ(rewritten(file, "wide", {{"fov", "100deg"}}), file);
}

TEST(Rewrite, ChangesNothingButTheValues) {
    EXPECT_EQ(rewritten(file, "tube", {{"gamma", "-0.25"}, {"fov", "61.5deg"}}),
              replaced(replaced(file, "60deg", "61.5deg"), "= third", "= -0.25"));
    EXPECT_EQ(rewritten(file, "tube", {{"from", "(4, 5, 6)"}}),
              replaced(file, "(1, 2, 3)", "(4, 5, 6)"));
}

TEST(Rewrite, WhatIsMadeOfAnotherHasTheValuesInItsCall) {
    EXPECT_EQ(rewritten(file, "wide", {{"turn", "1rad"}, {"fov", "90deg"}}),
              replaced(file, "100deg", "90deg, turn = 1rad"));
    EXPECT_EQ(rewritten(file, "same", {{"turn", "1rad"}, {"gamma", "2"}}),
              replaced(file, "same = tube", "same = tube(turn = 1rad, gamma = 2)"));
    const std::string chain =
        "camera low = wide(pitch = 1deg)\ncamera wide = fisheye(fov = 200deg)\n";
    EXPECT_EQ(rewritten(chain, "low", {{"fov", "90deg"}}),
              replaced(chain, "1deg", "1deg, fov = 90deg"));
}

TEST(Rewrite, WhatIsElsewhereIsMadeOfIt) {
    const auto built_in = Workspace().with_values("pinhole", "", {{"fov", "50deg"}, {"pz", "2"}});
    ASSERT_TRUE(built_in) << to_text(built_in.diagnostics);
    EXPECT_EQ(*built_in, "camera pinhole = pinhole(fov = 50deg, pz = 2)\n");
    const files::TemporaryFolder folder;
    folder.write("lens.cam", file);
    const std::string text = "import \"lens.cam\"\ncamera own = wide";
    const auto path = folder.write("a.cam", text);
    const auto imported = Workspace().with_values(path, "wide", {{"turn", "1rad"}});
    ASSERT_TRUE(imported) << to_text(imported.diagnostics);
    EXPECT_EQ(*imported, text + "\n\ncamera wide = wide(turn = 1rad)\n");
    folder.write("a.cam", *imported);
    const auto made = Workspace().make_open_camera(path, "wide", {}, {{"turn"}});
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(made->open.front().value, 1.0);
}

TEST(Rewrite, TheTextReadsAsTheValuesBitForBit) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> any(0.001, 3.1);
    std::size_t in_degrees_now = 0;
    for (int i = 0; i < 300; ++i) {
        const double fov = any(random);
        const double turn = -any(random);
        const double gamma = std::ldexp(any(random), i - 150);
        const std::string fov_text = literal(fov, true, "60deg");
        in_degrees_now += fov_text.ends_with("deg") ? 1 : 0;
        const std::string text = rewritten(file, "tube",
                                           {{"fov", fov_text},
                                            {"turn", literal(turn, true, "0.5rad")},
                                            {"gamma", literal(gamma, false, "third")}});
        EXPECT_EQ(value_of(text, "tube", "fov"), fov) << fov_text;
        EXPECT_EQ(value_of(text, "tube", "turn"), turn);
        EXPECT_EQ(value_of(text, "tube", "gamma"), gamma);
        // Almost every angle is a number of degrees after rounding to one.
        EXPECT_TRUE(literal(in_degrees(fov), true).ends_with("deg"));
        EXPECT_NEAR(in_degrees(fov), fov, 2e-16 * fov * 2.0);
    }
    // A product with pi/180 skips some of the doubles, but only some.
    EXPECT_GT(in_degrees_now, 200U);
    EXPECT_LT(in_degrees_now, 300U);
}

TEST(Rewrite, LiteralsAreShortAndHaveTheirUnit) {
    EXPECT_EQ(literal(0.1, false), "0.1");
    EXPECT_EQ(literal(-1e-9, false), "-1e-09");
    EXPECT_EQ(literal(in_degrees(1.0471975511965976), true, "59deg"), "60deg");
    EXPECT_EQ(literal(0.0, true, "2*half"), "0deg");
    EXPECT_EQ(literal(0.25, true, "1rad"), "0.25rad");
    EXPECT_EQ(literal(0.25, true, "2*(1rad + third)"), "0.25rad");
}

TEST(Rewrite, SaysWhatIsWrong) {
    const auto unknown = Workspace().with_values(source(file), "tube", {{"fob", "1deg"}});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.diagnostics.front().message, "the camera 'tube' has no parameter 'fob'");
    EXPECT_EQ(unknown.diagnostics.front().remedy, "did you mean 'fov'?");
    EXPECT_FALSE(Workspace().with_values(source(file), "tube", {{"gamma", "1deg"}}));
    EXPECT_FALSE(Workspace().with_values(source(file), "tube", {{"gamma", "1) {"}}));
    EXPECT_FALSE(Workspace().with_values(source(file), "tube", {{"fov", "180deg"}}));
    EXPECT_FALSE(Workspace().with_values(source(file), "nothing", {}));
}

}  // namespace balcony::lang::rewrite_test
