// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Maps of numbers over a picture: their colours, lines and places without a number.

#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "analyse/draw/color_scale.hpp"
#include "balcony/drawing.hpp"

namespace balcony::analyse::number_map_test {
namespace {

constexpr std::size_t width = 800;
constexpr std::size_t height = 400;

Color pixel(const Image& image, std::size_t x, std::size_t y) {
    const std::size_t i = 3 * (y * image.width + x);
    return {image.samples[i], image.samples[i + 1], image.samples[i + 2]};
}

// From 1 at the left to 100 at the right, as 100^u.
NumberMap powers() {
    NumberMap map{"powers", width, height, 20, 10, {}};
    for (std::size_t i = 0; i < map.columns * map.rows; ++i) {
        map.numbers.emplace_back(
            std::pow(100.0, (static_cast<double>(i % map.columns) + 0.5) / 20.0));
    }
    return map;
}

}  // namespace

TEST(NumberMap, LinesAreWhereTheNumbersAreRound) {
    const Image image = paint(powers());
    EXPECT_EQ(image.width, width);
    EXPECT_GT(image.height, height);
    // Beside the texts, which are in the middle.
    for (const std::size_t row : {0UL, 100UL, 300UL, height - 1}) {
        std::set<std::size_t> found;
        for (std::size_t x = 0; x < width; ++x) {
            if (pixel(image, x, row) == black) {
                found.insert(x);
            }
        }
        std::set<std::size_t> expected;
        for (const double number : {2.0, 5.0, 10.0, 20.0, 50.0}) {
            // The last pixel below the number, and the first one that is not.
            const double at = width * std::log10(number) / 2.0;
            const auto last = static_cast<std::size_t>(std::ceil(at - 0.5)) - 1;
            expected.insert({last, last + 1});
        }
        EXPECT_EQ(found, expected) << row;
    }
}

TEST(NumberMap, ColoursAreThoseOfTheScale) {
    const NumberMap map = powers();
    const Image image = paint(map);
    const ColorScale scale(*map.numbers.front(), *map.numbers[19],
                           ColorScale::Spacing::logarithmic);
    for (const std::size_t x : {30UL, 200UL, 611UL}) {
        const double number = std::pow(100.0, (static_cast<double>(x) + 0.5) / width);
        const Color expected = scale.color(number);
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(pixel(image, x, 50)[c], expected[c], 1.0) << x;
        }
    }
    EXPECT_EQ(pixel(image, 0, 50), sequential_color(0.0));
}

TEST(NumberMap, PlacesWithoutANumberHaveColoursOfTheirOwn) {
    NumberMap map = powers();
    const Image whole = paint(map);
    map.numbers[0].reset();
    map.numbers[5] = std::numeric_limits<double>::infinity();
    const Image image = paint(map);
    const Color missing = pixel(image, 10, 10);
    const Color unknown = pixel(image, 220, 10);
    EXPECT_NE(missing, unknown);
    EXPECT_EQ(pixel(image, 10, 100), pixel(whole, 10, 100));
    EXPECT_GT(image.height, whole.height) << "a line of the legend explains them";
    // Nothing has a number.
    map.numbers.assign(map.numbers.size(), std::nullopt);
    EXPECT_EQ(pixel(paint(map), 400, 200), missing);
}

TEST(NumberMap, OneNumberIsAMapToo) {
    NumberMap map{"one", 10, 10, 1, 1, {3.0}};
    const Image image = paint(map);
    EXPECT_EQ(image.width, 800U);
    // The scale has a twentieth on both sides.
    EXPECT_EQ(pixel(image, 100, 100),
              ColorScale(2.85, 3.15, ColorScale::Spacing::logarithmic).color(3.0));
}

}  // namespace balcony::analyse::number_map_test
