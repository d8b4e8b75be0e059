// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "balcony/film.hpp"

namespace balcony::render::exposure_test {
namespace {

// A film of grey pixels with two samples each, from dark to bright about a median, and a
// transparent one. The brightest is above the 95th percentile of so few.
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

// Quarter stops: the median comes within a factor 2^(1/8) of middle grey.
TEST(Exposure, MakesTheMedianMiddleGrey) {
    for (const float median : {1e-6F, 0.002F, 0.009F, 3.0F, 700.0F, 1e6F}) {
        const double exposure = automatic_exposure(grey_film(median));
        const double shown = static_cast<double>(median) * std::exp2(exposure);
        EXPECT_NEAR(std::log2(shown / 0.18), 0.0, 0.125) << median;
        EXPECT_EQ(4.0 * exposure, std::round(4.0 * exposure)) << median;
    }
}

// A row of pixels of which a tenth is bright.
Film film_with_highlights(double middle, double highlight) {
    Film film = *make_film({.width = 100, .height = 1, .data_layers = false});
    for (std::size_t i = 0; i < 100; ++i) {
        const double value = i < 90 ? middle : highlight;
        film.sum[i] = Color4d(value, value, value, 1.0);
    }
    film.passes.assign(film.passes.size(), 1);
    return film;
}

TEST(Exposure, KeepsHighlightsInRange) {
    EXPECT_EQ(automatic_exposure(film_with_highlights(0.1, 3.9)), 0.0);
    // The highlight becomes white, within an eighth of a stop.
    EXPECT_NEAR(std::log2(400.0) + automatic_exposure(film_with_highlights(40.0, 400.0)), 0.0,
                0.125);
    // It darkens the rest by at most two stops.
    EXPECT_NEAR(std::log2(0.1 / 0.18) + automatic_exposure(film_with_highlights(0.1, 400.0)), -2.0,
                0.125);
    // Where nothing is bright, the median counts, whatever is black.
    Film dark = film_with_highlights(0.0, 700.0);
    EXPECT_NEAR(std::log2(700.0 / 0.18) + automatic_exposure(dark), 0.0, 0.125);
}

TEST(Exposure, IsZeroForFilmsWithoutLight) {
    EXPECT_EQ(automatic_exposure(grey_film(0.0F)), 0.0);
    Film transparent = grey_film(1.0F);
    transparent.sum.assign(6, Color4d(0.0));
    EXPECT_EQ(automatic_exposure(transparent), 0.0);
    EXPECT_EQ(automatic_exposure(Film{}), 0.0);
}

Color3f grey(float level) { return Color3f(level); }

TEST(ViewTransform, NeutralKeepsDarkAndMiddleTones) {
    for (const Color3f& color : {grey(0.0F), grey(1e-6F), grey(0.18F), grey(0.8F),
                                 Color3f(0.8F, 0.1F, 0.0F), Color3f(0.02F, 0.5F, 0.79F)}) {
        EXPECT_EQ(displayed(ViewTransform::neutral, color), color);
    }
}

// Brighter light is never shown darker, and white is reached by nothing but the brightest.
TEST(ViewTransform, NeutralIsMonotonicAndSmooth) {
    for (const Color3f& tint : {grey(1.0F), Color3f(1.0F, 0.5F, 0.1F), Color3f(0.0F, 0.0F, 1.0F)}) {
        Color3f before(0.0F);
        constexpr float step = 1e-3F;
        constexpr float rounding = 4.0F * 6e-8F;  // Four operations on numbers below 1.
        for (float level = 0.0F; level < 20.0F; level += step) {
            const Color3f shown = displayed(ViewTransform::neutral, level * tint);
            for (int c = 0; c < 3; ++c) {
                ASSERT_GE(shown[c], before[c] - rounding) << level << ' ' << c;
                // The slope never exceeds 1, so it does not jump where the compression begins.
                ASSERT_LE(shown[c] - before[c], 1.01F * step) << level << ' ' << c;
                ASSERT_LT(shown[c], 1.0F);
            }
            before = shown;
        }
    }
    EXPECT_NEAR(displayed(ViewTransform::neutral, grey(1.0F)).x, 0.9F, 1e-6F);
}

std::vector<ViewTransform> every_view() {
    std::vector<ViewTransform> all;
    for (const std::string& name : view_transforms().all()) {
        all.push_back(*view_transforms().find(name));
    }
    return all;
}

// Black is black, middle grey is middle grey, greys stay grey, and more light is never darker.
TEST(ViewTransform, EachKeepsBlackAndMiddleGreyAndOrder) {
    ASSERT_EQ(every_view().size(), 4U);
    for (const ViewTransform view : every_view()) {
        EXPECT_EQ(displayed(view, grey(0.0F)), grey(0.0F)) << view_transforms()[view].name;
        EXPECT_NEAR(displayed(view, grey(0.18F)).x, 0.18F, 1e-5F) << view_transforms()[view].name;
        EXPECT_GT(displayed(view, grey(100.0F)).x, 0.99F) << view_transforms()[view].name;
        float before = 0.0F;
        for (float stops = -12.0F; stops < 10.0F; stops += 0.01F) {
            const Color3f shown = displayed(view, grey(std::exp2(stops)));
            // The rounding of powers and logarithms, each to about 2^-22.
            ASSERT_GE(shown.x, before - 1e-6F) << view_transforms()[view].name << ' ' << stops;
            ASSERT_NEAR(shown.x, shown.y, 1e-6F);
            ASSERT_NEAR(shown.x, shown.z, 1e-6F);
            before = shown.x;
        }
    }
}

// The two curves that are meant for pictures with a wide range show a stop more at every exposure
// of eleven, where standard is white from 1 on.
TEST(ViewTransform, FilmAndAgxSeparateHighlights) {
    for (const ViewTransform view : {ViewTransform::filmic, ViewTransform::agx}) {
        for (float light = 0.01F; light < 10.0F; light *= 2.0F) {
            EXPECT_GT(displayed(view, grey(std::min(2.0F * light, 15.0F))).x,
                      displayed(view, grey(light)).x + 0.002F)
                << view_transforms()[view].name << ' ' << light;
        }
    }
}

// A red light that gets brighter turns white; a dark red keeps its hue.
TEST(ViewTransform, AgxDesaturatesBrightLight) {
    const Color3f red(1.0F, 0.02F, 0.02F);
    const auto ratio = [&](float level) {
        const Color3f shown = displayed(ViewTransform::agx, level * red);
        return shown.y / shown.x;
    };
    EXPECT_LT(ratio(0.18F), 0.1F);
    EXPECT_GT(ratio(16.0F), 0.4F);
    EXPECT_LT(ratio(1.0F), ratio(4.0F));
    EXPECT_LT(ratio(4.0F), ratio(16.0F));
}

TEST(ViewTransform, HasARowForEachName) {
    for (const std::string& name : view_transforms().all()) {
        EXPECT_EQ(view_transforms()[*view_transforms().find(name)].name, name);
        EXPECT_FALSE(view_transforms()[*view_transforms().find(name)].meaning.empty());
    }
    EXPECT_FALSE(view_transforms().find("raw"));
    EXPECT_EQ(displayed(ViewTransform::standard, Color3f(0.9F, 7.0F, -1.0F)),
              Color3f(0.9F, 1.0F, 0.0F));
}

TEST(ViewTransform, TakesAnyNumber) {
    const float infinite = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const ViewTransform view : every_view()) {
        for (const Color3f& color : {grey(infinite), grey(nan), Color3f(infinite, 0.0F, nan),
                                     grey(std::numeric_limits<float>::max())}) {
            const Color3f shown = displayed(view, color);
            for (int c = 0; c < 3; ++c) {
                EXPECT_TRUE(shown[c] >= 0.0F && shown[c] <= 1.0F) << shown[c];
            }
        }
    }
}

}  // namespace
}  // namespace balcony::render::exposure_test
