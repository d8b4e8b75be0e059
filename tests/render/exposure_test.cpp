// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <gtest/gtest.h>

#include "balcony/film.hpp"

namespace balcony::render {
namespace {

// A film of grey pixels with two samples each, from dark to bright about a median, and a
// transparent one.
Film grey_film(float median) {
    Film film = *make_film({.width = 6, .height = 1, .data_layers = false});
    std::size_t pixel = 0;
    for (const float factor : {0.01F, 0.5F, 1.0F, 2.0F, 50.0F}) {
        const double value = 2.0 * double{factor} * double{median};
        film.sum[pixel++] = Color4d(value, value, value, 2.0);
    }
    film.passes = {2};
    return film;
}

TEST(Exposure, KeepsPicturesInTheRangeOfAScreen) {
    EXPECT_EQ(automatic_exposure(grey_film(0.05F)), 0.0);
    EXPECT_EQ(automatic_exposure(grey_film(0.18F)), 0.0);
    EXPECT_EQ(automatic_exposure(grey_film(0.9F)), 0.0);
}

// Half stops: the median comes within a factor 2^(1/4) of middle grey.
TEST(Exposure, MakesTheMedianMiddleGrey) {
    for (const float median : {1e-6F, 0.002F, 3.0F, 700.0F, 1e6F}) {
        const double exposure = automatic_exposure(grey_film(median));
        const double shown = static_cast<double>(median) * std::exp2(exposure);
        EXPECT_NEAR(std::log2(shown / 0.18), 0.0, 0.25) << median;
        EXPECT_EQ(2.0 * exposure, std::round(2.0 * exposure)) << median;
    }
}

TEST(Exposure, IsZeroForFilmsWithoutLight) {
    EXPECT_EQ(automatic_exposure(grey_film(0.0F)), 0.0);
    Film transparent = grey_film(1.0F);
    transparent.sum.assign(6, Color4d(0.0));
    EXPECT_EQ(automatic_exposure(transparent), 0.0);
    EXPECT_EQ(automatic_exposure(Film{}), 0.0);
}

}  // namespace
}  // namespace balcony::render
