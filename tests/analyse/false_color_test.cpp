// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// False colours: scales and their ticks, text, and pictures of known cameras.

#include <gtest/gtest.h>

#include <set>

#include "analyse/draw/bitmap.hpp"
#include "analyse/draw/bitmap_font.hpp"
#include "analyse/draw/color_scale.hpp"
#include "balcony/diagnose.hpp"
#include "support.hpp"

namespace balcony::analyse::false_color_test {
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

TEST(Bitmap, CharactersAreDistinct) {
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
        const CameraReport report = *diagnose(test::camera_of(text), settings);
        for (const auto& row : map_kinds()) {
            const Image image = false_color(report, row.value);
            EXPECT_EQ(image.samples.size(), 3 * image.width * image.height);
            EXPECT_GT(image.height, image.width * 2 / 3);
            EXPECT_EQ(map_kinds().find(row.name), row.value);
        }
    }
    EXPECT_FALSE(map_kinds().find("none"));
}

TEST(FalseColor, ColoursAreAtTheirSamples) {
    DiagnoseSettings settings;
    settings.width = 100;
    settings.height = 100;
    const CameraReport report =
        *diagnose(test::camera_of("camera half { map u = 1 .. -1, v = -1 .. 1 eye point(0, 0, 0)\n"
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

// 200 samples in 20 columns, all valid; make(i, sample) changes them.
template <class Make>
CameraReport report_of(const Make& make) {
    CameraReport report;
    report.grid = SampleGrid::over(20, 10, 1);
    report.samples.resize(report.grid.size());
    for (std::size_t i = 0; i < report.samples.size(); ++i) {
        report.samples[i] = {.valid = true, .orientation = 1, .views = 1};
        make(i, report.samples[i]);
    }
    return report;
}

// The colour of a sample in a map of 800 pixels, 40 for each sample.
Color color_of(const Image& image, std::size_t sample) {
    const std::size_t at = 3 * ((40 * (sample / 20) + 20) * image.width + 40 * (sample % 20) + 20);
    return {image.samples[at], image.samples[at + 1], image.samples[at + 2]};
}

TEST(FalseColor, TheScaleExcludesOnePercentAtEachEnd) {
    const CameraReport report = report_of([](std::size_t i, Sample& sample) {
        sample.anisotropy = static_cast<double>(i + 1);
        sample.magnification = 5.0;
    });
    const Image image = false_color(report, MapKind::anisotropy);
    const ColorScale scale(3.0, 198.0, Spacing::logarithmic);
    for (const std::size_t i : {0, 1, 2, 3, 5, 50, 150, 196, 199}) {
        EXPECT_EQ(color_of(image, i), scale.color(static_cast<double>(i + 1))) << i;
    }
    // Where all is alike it has the middle of a scale round it.
    const ColorScale narrow(4.75, 5.25, Spacing::logarithmic);
    EXPECT_EQ(color_of(false_color(report, MapKind::magnification), 7), narrow.color(5.0));
}

TEST(FalseColor, AScaleThatIsTrueHasTheMiddleColour) {
    // From -50 to 149 percent, of which the largest fiftieth is left out.
    const CameraReport report = report_of([](std::size_t i, Sample& sample) {
        sample.valid = i != 0;
        if (i > 1) {
            sample.scale_error = (static_cast<double>(i) - 50.0) / 100.0;
        }
    });
    const Image image = false_color(report, MapKind::scale);
    const ColorScale scale(-146.0, 146.0, Spacing::linear);
    for (const std::size_t i : {2, 20, 50, 100, 196, 199}) {
        EXPECT_EQ(color_of(image, i), scale.color(static_cast<double>(i) - 50.0)) << i;
    }
    EXPECT_EQ(color_of(image, 0), (Color{128, 128, 128}));
    EXPECT_EQ(color_of(image, 1), (Color{205, 205, 205}));
    // Rounding errors do not look like errors, but may turn a colour to the next.
    const CameraReport exact = report_of(
        [](std::size_t i, Sample& sample) { sample.scale_error = i % 2 == 0 ? 1e-9 : -1e-9; });
    const Image one_color = false_color(exact, MapKind::scale);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(color_of(one_color, 0)[k], color_of(one_color, 1)[k], 1);
    }
}

TEST(FalseColor, SingularSamplesAreNotOfTheScale) {
    const CameraReport report = report_of([](std::size_t i, Sample& sample) {
        sample.singular = i % 2 == 1;
        sample.magnification = sample.singular ? 0.0 : static_cast<double>(i + 1);
    });
    // 100 values 1, 3 .. 199, of which the outermost are left out.
    const ColorScale scale(3.0, 197.0, Spacing::logarithmic);
    const Image image = false_color(report, MapKind::magnification);
    EXPECT_EQ(color_of(image, 20), scale.color(21.0));
    EXPECT_EQ(color_of(image, 100), scale.color(101.0));
    EXPECT_EQ(color_of(image, 21), color_of(image, 101));
}

TEST(FalseColor, SignsSeamsAndRepeatsHaveTheirColours) {
    const CameraReport report = report_of([](std::size_t i, Sample& sample) {
        sample.orientation = i < 20 ? -1 : 1;
        sample.seam = i < 40;
        sample.views = i < 60 ? 0 : i < 80 ? 7 : 1;
    });
    const Image signs = false_color(report, MapKind::orientation);
    EXPECT_EQ(color_of(signs, 0), (Color{240, 150, 40}));
    EXPECT_EQ(color_of(signs, 20), (Color{49, 104, 142}));
    const Image seams = false_color(report, MapKind::seams);
    EXPECT_EQ(color_of(seams, 39), (Color{190, 20, 20}));
    EXPECT_EQ(color_of(seams, 40), (Color{205, 215, 225}));
    const Image repeats = false_color(report, MapKind::repeated);
    const ColorScale scale(1.0, 7.0, Spacing::linear);
    EXPECT_EQ(color_of(repeats, 60), scale.color(7.0));
    EXPECT_EQ(color_of(repeats, 80), scale.color(1.0));
    EXPECT_NE(color_of(repeats, 0), scale.color(0.0));
    // The legend below the map says what 7 looks like, too.
    const Color seven = scale.color(7.0);
    bool in_legend = false;
    for (std::size_t i = 3 * 400 * repeats.width; i + 2 < repeats.samples.size(); i += 3) {
        in_legend =
            in_legend || (repeats.samples[i] == seven[0] && repeats.samples[i + 1] == seven[1] &&
                          repeats.samples[i + 2] == seven[2]);
    }
    EXPECT_TRUE(in_legend);
}

}  // namespace
}  // namespace balcony::analyse::false_color_test
