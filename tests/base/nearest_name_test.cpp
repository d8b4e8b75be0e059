// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "balcony/base.hpp"

namespace balcony::nearest_name_test {
namespace {

const std::vector<std::string> stages = {"circle", "superellipse", "torus", "zoom", "uv"};

TEST(NearestName, FindsEachKindOfSlip) {
    EXPECT_EQ(nearest_name("superelipse", stages), "superellipse");    // left out
    EXPECT_EQ(nearest_name("superelllipse", stages), "superellipse");  // too many
    EXPECT_EQ(nearest_name("superellipsi", stages), "superellipse");   // replaced
    EXPECT_EQ(nearest_name("tours", stages), "torus");                 // swapped
}

TEST(NearestName, ASwapIsOneSlip) {
    // Of five letters one may be wrong; as two replacements the swap would be one too many.
    EXPECT_EQ(nearest_name("trous", {"torus"}), "torus");
    EXPECT_EQ(nearest_name("tarts", {"torus"}), std::nullopt);
}

TEST(NearestName, LetterCaseDoesNotCount) {
    EXPECT_EQ(nearest_name("TORUS", stages), "torus");
    EXPECT_EQ(nearest_name("UV", stages), "uv");
}

TEST(NearestName, AThirdOfTheLettersMayBeWrong) {
    EXPECT_EQ(nearest_name("abcdef", {"abcdXY"}), "abcdXY");
    EXPECT_EQ(nearest_name("abcdef", {"abcXYZ"}), std::nullopt);
    EXPECT_EQ(nearest_name("ux", stages), "uv");
}

TEST(NearestName, NothingIsNearACompletelyDifferentName) {
    EXPECT_EQ(nearest_name("x", {"y"}), std::nullopt);
    EXPECT_EQ(nearest_name("", {"y"}), std::nullopt);
    EXPECT_EQ(nearest_name("hyperboloid", stages), std::nullopt);
    EXPECT_EQ(nearest_name("torus", {}), std::nullopt);
}

TEST(NearestName, TheNearestWinsAndTheFirstOfEquals) {
    EXPECT_EQ(nearest_name("rotates", {"rotaXes", "rotate", "rotated"}), "rotaXes");
    EXPECT_EQ(nearest_name("rotatee", {"rotaXXe", "rotated"}), "rotated");
}

TEST(NearestName, AnAbsurdlyLongNameIsNotLookedUp) {
    const std::string absurd(65, 'a');
    EXPECT_EQ(nearest_name(absurd, {absurd}), std::nullopt);
}

}  // namespace
}  // namespace balcony::nearest_name_test
