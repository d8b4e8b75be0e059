// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Sample positions follow the pixel filter.

#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "balcony/render.hpp"
#include "render/sampling/pass_offset.hpp"

namespace balcony::render::test::pass_offset_test {
namespace {

// The densities as textbooks give them, up to a factor.
struct Density {
    const char* name;
    std::function<double(double)> at;
};

const Density densities[] = {
    {"blackman-harris",
     [](double x) {
         const double angle = 2.0 * std::numbers::pi * (x / 3.0 + 0.5);
         return std::abs(x) > 1.5
                    ? 0.0
                    : 0.35875 - 0.48829 * std::cos(angle) + 0.14128 * std::cos(2.0 * angle) -
                          0.01168 * std::cos(3.0 * angle);
     }},
    {"box", [](double x) { return std::abs(x) > 0.5 ? 0.0 : 1.0; }},
    {"tent", [](double x) { return std::max(0.0, 1.0 - std::abs(x)); }},
    {"gaussian", [](double x) { return std::abs(x) > 1.5 ? 0.0 : std::exp(-2.0 * x * x); }},
};

double integral(const std::function<double(double)>& f) {
    constexpr int steps = 40000;
    double total = 0.0;
    for (int i = 0; i < steps; ++i) {
        total += f(-2.0 + 4.0 * (i + 0.5) / steps) * 4.0 / steps;
    }
    return total;
}

TEST(PassOffset, EveryFilterIsTested) {
    ASSERT_EQ(pixel_filters().size(), std::size(densities));
    for (const Density& density : densities) {
        EXPECT_NE(find_pixel_filter(density.name), nullptr) << density.name;
    }
    EXPECT_EQ(find_pixel_filter("mitchell"), nullptr);
}

TEST(PassOffset, TheFirstPassIsAtThePixelCentre) {
    for (const Density& density : densities) {
        EXPECT_EQ(pass_offset(*find_pixel_filter(density.name), 0), Imath::V2d(0.0, 0.0));
    }
}

TEST(PassOffset, PassesHaveTheMomentsOfTheFilter) {
    constexpr int count = 4096;
    // A sequence of low discrepancy is within (log n)^2 / n of the integral.
    constexpr double discrepancy = 70.0 / count;
    for (const Density& density : densities) {
        const double whole = integral(density.at);
        const auto moment = [&](int power) {
            return integral([&](double x) { return std::pow(x, power) * density.at(x) / whole; });
        };
        Imath::V2d mean(0.0, 0.0);
        Imath::V2d square(0.0, 0.0);
        double fourth = 0.0;
        double product = 0.0;
        for (int i = 0; i < count; ++i) {
            const Imath::V2d p =
                pass_offset(*find_pixel_filter(density.name), static_cast<std::size_t>(i));
            ASSERT_GT(density.at(p.x), 0.0) << density.name << ", " << p.x;
            mean += p / count;
            square += p * p / count;
            fourth += std::pow(p.y, 4) / count;
            product += p.x * p.y / count;
        }
        EXPECT_LT(mean.length(), discrepancy) << density.name;
        EXPECT_NEAR(square.x, moment(2), discrepancy) << density.name;
        EXPECT_NEAR(square.y, moment(2), discrepancy) << density.name;
        EXPECT_NEAR(fourth, moment(4), discrepancy) << density.name;
        EXPECT_NEAR(product, 0.0, discrepancy) << density.name;
    }
}

// Of any 2^k passes from a multiple of 2^k on, each elementary rectangle of the unit square
// contains one. The box filter's distribution is the position in the pixel itself.
TEST(PassOffset, PassesFillEveryElementaryRectangle) {
    const PixelFilter& box = *find_pixel_filter("box");
    constexpr std::size_t digits = 6;
    constexpr std::size_t count = std::size_t{1} << digits;
    for (const std::size_t first : {std::size_t{0}, 5 * count}) {
        for (std::size_t columns = 0; columns <= digits; ++columns) {
            std::set<std::pair<int, int>> filled;
            for (std::size_t pass = first; pass < first + count; ++pass) {
                const Imath::V2d p = pass_offset(box, pass) + Imath::V2d(0.5, 0.5);
                filled.emplace(
                    static_cast<int>(std::ldexp(p.x, static_cast<int>(columns))),
                    static_cast<int>(std::ldexp(p.y, static_cast<int>(digits - columns))));
            }
            EXPECT_EQ(filled.size(), count) << first << ", " << columns;
        }
    }
}

// So that a picture point is the same number in every tile.
TEST(PassOffset, OffsetsAreMultiplesOfASmallPower) {
    for (const Density& density : densities) {
        for (std::size_t pass = 0; pass < 100; ++pass) {
            const Imath::V2d scaled = pass_offset(*find_pixel_filter(density.name), pass) * 0x1p30;
            EXPECT_EQ(scaled.x, std::nearbyint(scaled.x));
            EXPECT_EQ(scaled.y, std::nearbyint(scaled.y));
        }
    }
}

}  // namespace
}  // namespace balcony::render::test::pass_offset_test
