// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "balcony/lang.hpp"
#include "bridge/text/listing.hpp"

namespace balcony::bridge::listing_test {
namespace {

TEST(Names, AreGivenOnceAndAreWordsOfEveryLanguage) {
    Names names({"for"});
    EXPECT_EQ(names.unique("radius"), "radius");
    EXPECT_EQ(names.unique("radius"), "radius_2");
    EXPECT_EQ(names.unique("for"), "for_2");
    EXPECT_EQ(names.unique("a - b"), "a_b") << "GLSL reserves two underscores";
    EXPECT_EQ(names.unique("3d"), "camera_3d");
    EXPECT_EQ(names.unique(""), "camera_");
}

TEST(Names, DoNotBeginWithAReservedPrefix) {
    Names names({}, "gl_");
    EXPECT_EQ(names.unique("gl_x"), "camera_gl_x");
    EXPECT_EQ(names.unique("glass"), "glass");
}

TEST(Numbers, ReadAsTheSameAndArePrintedAsNoIntegers) {
    EXPECT_EQ(decimal(45.0), "45.0");
    EXPECT_EQ(decimal(-3.0), "-3.0");
    EXPECT_EQ(decimal(1e300), "1e+300");
    EXPECT_EQ(std::stod(decimal(0.1)), 0.1);
    EXPECT_EQ(single_decimal(0.1), "0.1");
    EXPECT_EQ(std::stof(single_decimal(1.0 / 3.0)), 1.0F / 3.0F);
}

TEST(Comments, StayOnTheirLine) { EXPECT_EQ(comment_line("a\nb\\"), "a?b/"); }

TEST(Formulas, OfACameraWithoutAFormulaNameTheStage) {
    const auto camera = lang::make_camera(
        std::make_shared<const SourceText>(
            "test", "camera c { map u = 0 .. 1, v = 0 .. 1  eye mesh(\"vase.obj\")  look normal }"),
        "");
    ASSERT_TRUE(camera) << to_text(camera.diagnostics);
    const auto made = formulas_of(*camera, {"c"});
    ASSERT_FALSE(made);
    EXPECT_NE(made.diagnostics.front().message.find("eye mesh(\"vase.obj\")"), std::string::npos)
        << made.diagnostics.front().message;
    EXPECT_NE(made.diagnostics.front().remedy.find("balcony rays"), std::string::npos);
}

}  // namespace
}  // namespace balcony::bridge::listing_test
