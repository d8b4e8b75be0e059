// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The sampler: reproducible, uniform, stratified, and without relations between dimensions.

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "render/sampling/sampler.hpp"
#include "statistics.hpp"

namespace balcony::render::test {
namespace {

constexpr std::size_t dimensions = 8;

// The numbers of one sample.
std::vector<float> numbers(std::size_t x, std::size_t y, std::size_t pass) {
    Sampler sampler(x, y, pass);
    std::vector<float> all;
    while (all.size() < dimensions) {
        const Imath::V2f pair = sampler.next_pair();
        all.push_back(pair.x);
        all.push_back(pair.y);
    }
    return all;
}

TEST(Sampler, DependsOnPixelPassAndDimensionAlone) {
    const std::vector<float> first = numbers(17, 4, 9);
    EXPECT_EQ(numbers(17, 4, 9), first);
    EXPECT_NE(numbers(4, 17, 9), first);
    EXPECT_NE(numbers(17, 4, 8), first);
    EXPECT_EQ(std::set<float>(first.begin(), first.end()).size(), dimensions);
    EXPECT_TRUE(std::all_of(first.begin(), first.end(),
                            [](float value) { return value >= 0.0F && value < 1.0F; }));
}

// Across pixels, where nothing is stratified, each dimension and each pair of dimensions is spread
// evenly: neighbouring pixels have nothing to do with each other.
TEST(Sampler, IsUniformAcrossPixels) {
    constexpr std::size_t side = 200;
    constexpr std::size_t cells = 16;
    for (std::size_t a = 0; a < dimensions; ++a) {
        for (std::size_t b = a + 1; b < dimensions; ++b) {
            std::vector<double> counts(cells * cells);
            for (std::size_t i = 0; i < side * side; ++i) {
                const std::vector<float> point = numbers(i % side, i / side, 3);
                const auto cell = [&](std::size_t d) {
                    return static_cast<std::size_t>(point[d] * static_cast<float>(cells));
                };
                counts[cell(a) * cells + cell(b)] += 1.0;
            }
            const std::vector<double> expected(counts.size(),
                                               static_cast<double>(side * side) / (cells * cells));
            EXPECT_GT(chi_square_probability(counts, expected), significance) << a << ", " << b;
        }
    }
}

// Of neighbouring pixels, in x and y, the first dimension against itself.
TEST(Sampler, NeighboursAreNotCorrelated) {
    constexpr std::size_t side = 300;
    for (const auto& [dx, dy] : {std::pair(1U, 0U), {0U, 1U}, {1U, 1U}}) {
        double product = 0.0;
        for (std::size_t i = 0; i < side * side; ++i) {
            const float here = Sampler(i % side, i / side, 0).next();
            const float there = Sampler(i % side + dx, i / side + dy, 0).next();
            product += (double{here} - 0.5) * (double{there} - 0.5);
        }
        // The mean product of independent uniform numbers deviates by 1/12 over the root of their
        // number; four deviations are passed once in 16,000.
        const double correlation = 12.0 * product / (side * side);
        EXPECT_LT(std::abs(correlation), 4.0 / side) << dx << ", " << dy;
    }
}

// Any 2^k passes from a multiple of 2^k on: one in each part of each dimension, and one in each
// elementary rectangle of a pair.
TEST(Sampler, PassesAreStratified) {
    constexpr std::size_t count = 64;
    for (const std::size_t first : {std::size_t{0}, std::size_t{64}, std::size_t{64 * 1001}}) {
        for (std::size_t columns = 1; columns <= count; columns *= 2) {
            const std::size_t rows = count / columns;
            for (std::size_t pair = 0; pair < dimensions; pair += 2) {
                std::set<std::size_t> cells;
                for (std::size_t pass = first; pass < first + count; ++pass) {
                    const std::vector<float> point = numbers(5, 6, pass);
                    const auto column =
                        static_cast<std::size_t>(point[pair] * static_cast<float>(columns));
                    const auto row =
                        static_cast<std::size_t>(point[pair + 1] * static_cast<float>(rows));
                    cells.insert(row * columns + column);
                }
                EXPECT_EQ(cells.size(), count) << first << ", " << columns << ", " << pair;
            }
        }
    }
}

// Over the passes of a pixel, numbers of different pairs go through each other's range freely.
TEST(Sampler, DimensionsAreNotCorrelatedOverPasses) {
    constexpr std::size_t count = 1 << 14;
    std::vector<std::vector<float>> points;
    for (std::size_t pass = 0; pass < count; ++pass) {
        points.push_back(numbers(123, 45, pass));
    }
    for (std::size_t a = 0; a < dimensions; ++a) {
        for (std::size_t b = a + 1; b < dimensions; ++b) {
            double product = 0.0;
            for (const std::vector<float>& point : points) {
                product += (double{point[a]} - 0.5) * (double{point[b]} - 0.5);
            }
            const double correlation = 12.0 * product / static_cast<double>(count);
            EXPECT_LT(std::abs(correlation), 4.0 / std::sqrt(static_cast<double>(count)))
                << a << ", " << b;
        }
    }
}

// A smooth integrand is met far better than by independent numbers, whose error would be 0.0037.
TEST(Sampler, ConvergesFasterThanChance) {
    constexpr std::size_t count = 4096;
    double total = 0.0;
    for (std::size_t pass = 0; pass < count; ++pass) {
        const Imath::V2f p = Sampler(1, 2, pass).next_pair();
        total += double{p.x} * double{p.y} / count;
    }
    EXPECT_NEAR(total, 0.25, 2e-4);
}

}  // namespace
}  // namespace balcony::render::test
