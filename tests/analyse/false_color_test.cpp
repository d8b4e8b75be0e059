// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// False colours: scales and their ticks, text, and pictures of known cameras.

#include <gtest/gtest.h>

#include <set>

#include "analyse/bitmap.hpp"
#include "analyse/bitmap_font.hpp"
#include "analyse/color_scale.hpp"
#include "balcony/diagnose.hpp"
#include "support.hpp"

namespace balcony::analyse {
namespace {

using Spacing = ColorScale::Spacing;

std::string tick_texts(const ColorScale& scale) {
    std::string texts;
    for (const ColorScale::Tick& tick : scale.ticks()) {
        texts += tick.text + " ";
    }
    return texts;
}

TEST(ColorScale, PositionAndValueAreInverse) {
    for (const Spacing spacing : {Spacing::linear, Spacing::logarithmic}) {
        const ColorScale scale(0.5, 80.0, spacing);
        for (const double s : {0.0, 0.25, 0.8, 1.0}) {
            EXPECT_NEAR(scale.position(scale.value(s)), s, 1e-12);
        }
        EXPECT_EQ(scale.position(0.1), 0.0);
        EXPECT_EQ(scale.position(1e9), 1.0);
    }
    EXPECT_NEAR(ColorScale(1, 100, Spacing::logarithmic).position(10), 0.5, 1e-12);
}

TEST(ColorScale, TicksAreRound) {
    EXPECT_EQ(tick_texts({0.0, 10.0, Spacing::linear}), "0 2 4 6 8 10 ");
    EXPECT_EQ(tick_texts({12.4, 13.3, Spacing::linear}), "12.4 12.6 12.8 13 13.2 ");
    EXPECT_EQ(tick_texts({0.9, 25.0, Spacing::logarithmic}), "1 2 5 10 20 ");
    EXPECT_EQ(tick_texts({1.0, 1.6, Spacing::logarithmic}), "1 1.2 1.4 1.6 ");
    EXPECT_EQ(tick_texts({1e-3, 1e6, Spacing::logarithmic}), "0.001 0.1 10 1000 100000 ");
}

// Every step of the scale is brighter than the last by about as much.
TEST(ColorScale, BrightnessGrowsEvenly) {
    const auto luma = [](double s) {
        const Color c = sequential_color(s);
        return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    };
    for (int i = 0; i < 20; ++i) {
        const double growth = luma((i + 1) / 20.0) - luma(i / 20.0);
        EXPECT_GT(growth, 3.0) << i;
        EXPECT_LT(growth, 16.0) << i;
    }
}

TEST(Bitmap, EveryCharacterIsOneOfItsOwn) {
    EXPECT_EQ(std::set<Glyph>(glyphs.begin(), glyphs.end()).size(), glyphs.size());
    for (const Glyph& glyph : glyphs) {
        for (const std::uint8_t row : glyph) {
            EXPECT_LT(row, 1U << glyph_width);
        }
    }
}

TEST(Bitmap, WritesWithinItsBounds) {
    Bitmap bitmap(20, 10, {255, 255, 255});
    EXPECT_EQ(Bitmap::text_width("iii", 2), 34U);
    bitmap.write(1, 1, "T", {0, 0, 0});
    bitmap.write(15, 5, "out\xc3", {0, 0, 0}, 3);
    const Image image = bitmap.take();
    const auto dark = [&](std::size_t x, std::size_t y) {
        return image.samples[3 * (y * image.width + x)] == 0;
    };
    EXPECT_TRUE(dark(1, 1) && dark(5, 1) && dark(3, 7));
    EXPECT_FALSE(dark(1, 2) || dark(6, 1) || dark(3, 8));
}

TEST(FalseColor, EveryMapOfEveryKindOfCameraCanBeDrawn) {
    for (const char* text :
         {"camera a { map u = 1 .. -1, v = -1 .. 1 eye plane((0, 0, 0)) look normal }",
          "camera none { map u = 1 .. -1, v = -1 .. 1 eye point(0, 0, 0)\n"
          "toward surface(u, v) = [sqrt(-1 - u^2), u, v] look relative }",
          "camera flat { map u = 1 .. -1, v = -1 .. 1 eye point(0, 0, 0) toward circle(1) }"}) {
        DiagnoseSettings settings;
        settings.width = 60;
        settings.height = 40;
        const Report report = diagnose(test::camera_of(text), settings);
        for (const MapDescription& row : map_kinds()) {
            const Image image = false_color(report, row.kind);
            EXPECT_EQ(image.samples.size(), 3 * image.width * image.height);
            EXPECT_GT(image.height, image.width * 2 / 3);
            EXPECT_EQ(find_map_kind(row.name), row.kind);
        }
    }
    EXPECT_FALSE(find_map_kind("none"));
}

TEST(FalseColor, ColoursStandWhereTheSamplesAre) {
    DiagnoseSettings settings;
    settings.width = 100;
    settings.height = 100;
    const Report report =
        diagnose(test::camera_of("camera half { map u = 1 .. -1, v = -1 .. 1 eye point(0, 0, 0)\n"
                                 "toward surface(u, v) = [1 + sqrt(v)/10, u, v] look relative }"),
                 settings);
    const Image image = false_color(report, MapKind::validity);
    const auto red_at = [&](std::size_t x, std::size_t y) {
        return int{image.samples[3 * (y * image.width + x)]};
    };
    // v grows upwards; no ray below the middle, where it is grey.
    EXPECT_EQ(red_at(400, 600), 128);
    EXPECT_EQ(red_at(400, 200), 53);
}

}  // namespace
}  // namespace balcony::analyse
