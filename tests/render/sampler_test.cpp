// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The sampler: reproducible, uniform, stratified over passes and pixels, and without relations
// between dimensions.

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "render/sampling/sample_block.hpp"
#include "render/sampling/sampler.hpp"
#include "shading/geometry/circle.hpp"
#include "statistics.hpp"

namespace balcony::render::test::sampler_test {
namespace {

constexpr std::size_t dimensions = 8;
constexpr std::uint32_t seed = 1;

// The numbers of one sample.
std::vector<float> numbers(std::size_t x, std::size_t y, const PassNumbers& pass) {
    Sampler sampler(x, y, pass);
    std::vector<float> all;
    while (all.size() < dimensions) {
        const Imath::V2f pair = sampler.next_pair();
        all.push_back(pair.x);
        all.push_back(pair.y);
    }
    return all;
}

std::vector<float> numbers(std::size_t x, std::size_t y, std::size_t pass) {
    return numbers(x, y, PassNumbers(pass, seed));
}

// The mean product of independent uniform numbers deviates by 1/12 over the root of their number.
void expect_no_correlation(const std::vector<std::vector<float>>& points) {
    const auto count = static_cast<double>(points.size());
    for (std::size_t a = 0; a < dimensions; ++a) {
        for (std::size_t b = a + 1; b < dimensions; ++b) {
            double product = 0.0;
            for (const std::vector<float>& point : points) {
                product += (double{point[a]} - 0.5) * (double{point[b]} - 0.5);
            }
            EXPECT_LT(std::abs(12.0 * product / count), 4.0 / std::sqrt(count)) << a << ", " << b;
        }
    }
}

TEST(Sampler, DependsOnSeedPixelPassAndDimensionAlone) {
    const std::vector<float> first = numbers(17, 4, 9);
    EXPECT_EQ(numbers(17, 4, 9), first);
    EXPECT_NE(numbers(4, 17, 9), first);
    EXPECT_NE(numbers(17, 4, 8), first);
    EXPECT_NE(numbers(17, 4, PassNumbers(9, seed + 1)), first);
    EXPECT_EQ(std::set<float>(first.begin(), first.end()).size(), dimensions);
    EXPECT_TRUE(std::all_of(first.begin(), first.end(),
                            [](float value) { return value >= 0.0F && value < 1.0F; }));
}

// Dimensions whose pass numbers are not kept are computed.
TEST(Sampler, HasAnyNumberOfDimensions) {
    const PassNumbers pass(3, seed);
    Sampler sampler(5, 6, pass);
    std::set<float> all;
    constexpr std::size_t pairs = 1000;
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        const Imath::V2f both = sampler.next_pair();
        all.insert({both.x, both.y});
    }
    // Two of 2000 numbers of 24 bits are equal with a probability of 0.12.
    EXPECT_GE(all.size(), 2 * pairs - 2);
}

// Those of a block and those beyond it, from samplers that have given different numbers of pairs.
TEST(Sampler, GivesTheSameNumbersInBlocks) {
    const PassNumbers pass(11, seed);
    for (const std::size_t count : {std::size_t{1}, std::size_t{5}, SampleBlock::size}) {
        std::vector<Sampler> samplers;
        std::vector<const Sampler*> pointers;
        samplers.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            samplers.emplace_back(3 * i, 40 - i, pass);
            for (std::size_t skipped = 0; skipped < 9 * i; ++skipped) {
                (void)samplers.back().next();
            }
            pointers.push_back(&samplers.back());
        }
        SampleBlock block;
        block.fill(pointers);
        for (std::size_t i = 0; i < count; ++i) {
            Sampler alone = samplers[i];
            SampleReader reader(block, i, samplers[i]);
            EXPECT_EQ(reader.next(), alone.next()) << i;
            for (std::size_t pair = 0; pair < SampleBlock::depth; ++pair) {
                EXPECT_EQ(reader.next_pair(), alone.next_pair()) << i << ", " << pair;
            }
            EXPECT_EQ(samplers[i].next(), alone.next()) << i;
        }
    }
}

// At 2^16 parts of a turn, of which each is a float, and at the largest float below 1.
TEST(Sampler, DirectionsAreEvenOnTheCircle) {
    const auto expect_on_circle = [](float part) {
        const Imath::V2f at = on_circle(part);
        const double angle = 2.0 * std::numbers::pi * double{part};
        EXPECT_NEAR(at.x, std::cos(angle), 2e-7) << part;
        EXPECT_NEAR(at.y, std::sin(angle), 2e-7) << part;
    };
    for (int i = 0; i < 1 << 16; ++i) {
        expect_on_circle(static_cast<float>(i) * 0x1p-16F);
    }
    expect_on_circle(0x1.fffffep-1F);
}

// Over seeds, each dimension and each pair of dimensions is spread evenly.
TEST(Sampler, IsUniformOverSeeds) {
    constexpr std::size_t count = 40'000;
    constexpr std::size_t cells = 16;
    std::vector<std::vector<float>> points;
    for (std::uint32_t i = 0; i < count; ++i) {
        points.push_back(numbers(17, 4, PassNumbers(3, i)));
    }
    for (std::size_t a = 0; a < dimensions; ++a) {
        for (std::size_t b = a + 1; b < dimensions; ++b) {
            std::vector<double> counts(cells * cells);
            for (const std::vector<float>& point : points) {
                const auto cell = [&](std::size_t d) {
                    return static_cast<std::size_t>(point[d] * static_cast<float>(cells));
                };
                counts[cell(a) * cells + cell(b)] += 1.0;
            }
            const std::vector<double> expected(counts.size(),
                                               static_cast<double>(count) / (cells * cells));
            EXPECT_GT(chi_square_probability(counts, expected), significance) << a << ", " << b;
        }
    }
}

// Of a pass, the numbers of different pairs go through each other's range freely.
TEST(Sampler, DimensionsAreNotCorrelatedOverPixels) {
    constexpr std::size_t side = 256;
    const PassNumbers pass(3, seed);
    std::vector<std::vector<float>> points;
    for (std::size_t i = 0; i < side * side; ++i) {
        points.push_back(numbers(i % side, i / side, pass));
    }
    expect_no_correlation(points);
}

// Samples of any 2^k passes from a multiple of 2^k on in an aligned square of pixels: one in each
// elementary rectangle.
TEST(Sampler, PassesOfASquareOfPixelsAreStratified) {
    for (const std::size_t passes : {1U, 2U, 4U, 8U}) {
        for (const std::size_t side : {1U, 2U, 4U, 8U}) {
            for (const std::size_t first : {std::size_t{0}, std::size_t{24}}) {
                const std::size_t count = passes * side * side;
                std::vector<std::vector<float>> points;
                for (std::size_t pass = first; pass < first + passes; ++pass) {
                    const PassNumbers of_pass(pass, seed);
                    for (std::size_t i = 0; i < side * side; ++i) {
                        points.push_back(numbers(64 + i % side, 1000 + i / side, of_pass));
                    }
                }
                for (std::size_t columns = 1; columns <= count; columns *= 2) {
                    const std::size_t rows = count / columns;
                    for (std::size_t pair = 0; pair < dimensions; pair += 2) {
                        std::set<std::size_t> cells;
                        for (const std::vector<float>& point : points) {
                            const auto column =
                                static_cast<std::size_t>(point[pair] * static_cast<float>(columns));
                            const auto row = static_cast<std::size_t>(point[pair + 1] *
                                                                      static_cast<float>(rows));
                            cells.insert(row * columns + column);
                        }
                        EXPECT_EQ(cells.size(), count)
                            << passes << ", " << side << ", " << first << ", " << columns;
                    }
                }
            }
        }
    }
}

// The part of the variance of a picture's error at frequencies of less than one eighth per pixel,
// relative to white noise, which has the same variance at every frequency.
double low_frequencies(const std::vector<double>& error, std::size_t side) {
    const auto wave = [side](std::size_t frequency, std::size_t place) {
        const auto turns = static_cast<double>(frequency * place % side);
        return std::polar(1.0, 2.0 * std::numbers::pi * turns / static_cast<double>(side));
    };
    std::vector<std::complex<double>> rows(side * side);
    std::vector<std::complex<double>> both(side * side);
    for (std::size_t i = 0; i < side * side; ++i) {
        for (std::size_t x = 0; x < side; ++x) {
            rows[i] += error[i / side * side + x] * wave(i % side, x);
        }
    }
    for (std::size_t i = 0; i < side * side; ++i) {
        for (std::size_t y = 0; y < side; ++y) {
            both[i] += rows[y * side + i % side] * wave(i / side, y);
        }
    }
    double low = 0.0;
    double all = 0.0;
    double low_count = 0.0;
    for (std::size_t i = 1; i < side * side; ++i) {
        const auto is_low = [side](std::size_t k) { return std::min(k, side - k) < side / 8; };
        const double power = std::norm(both[i]);
        all += power;
        if (is_low(i % side) && is_low(i / side)) {
            low += power;
            low_count += 1.0;
        }
    }
    return low / low_count / (all / static_cast<double>(side * side - 1));
}

// An area light behind an edge, a round one, a smooth integrand.
TEST(Sampler, ErrorsOfAPictureAreBlueNoise) {
    constexpr std::size_t side = 32;
    using Integrand = double (*)(const Imath::V2f&);
    const Integrand integrands[] = {
        [](const Imath::V2f& p) { return p.x < 0.4F && p.y < 0.7F ? 1.0 : 0.0; },
        [](const Imath::V2f& p) { return p.length2() < 1.0F ? 1.0 : 0.0; },
        [](const Imath::V2f& p) { return std::sin(7.0 * double{p.x} + 3.0 * double{p.y}); }};
    for (const Integrand integrand : integrands) {
        for (const std::size_t samples : {1U, 2U, 3U, 4U, 16U}) {
            double low = 0.0;
            constexpr std::size_t pictures = 16;
            for (std::uint32_t picture = 0; picture < pictures; ++picture) {
                std::vector<double> sums(side * side);
                for (std::size_t pass = 0; pass < samples; ++pass) {
                    const PassNumbers of_pass(pass, picture);
                    for (std::size_t i = 0; i < sums.size(); ++i) {
                        sums[i] += integrand(Sampler(i % side, i / side, of_pass).next_pair());
                    }
                }
                low += low_frequencies(sums, side) / pictures;
            }
            // White noise has 1 on average; of 16 pictures with 48 low frequencies each (half of
            // them independent), the mean deviates from it by 1/20.
            EXPECT_LT(low, 0.7) << samples << " samples";
        }
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

// Over the passes of a pixel, too.
TEST(Sampler, DimensionsAreNotCorrelatedOverPasses) {
    constexpr std::size_t count = 1 << 14;
    std::vector<std::vector<float>> points;
    for (std::size_t pass = 0; pass < count; ++pass) {
        points.push_back(numbers(123, 45, pass));
    }
    expect_no_correlation(points);
}

// A smooth integrand is met far better than by independent numbers, whose error would be 0.0037.
TEST(Sampler, ConvergesFasterThanChance) {
    constexpr std::size_t count = 4096;
    double total = 0.0;
    for (std::size_t pass = 0; pass < count; ++pass) {
        const Imath::V2f p = Sampler(1, 2, PassNumbers(pass, seed)).next_pair();
        total += double{p.x} * double{p.y} / count;
    }
    EXPECT_NEAR(total, 0.25, 2e-4);
}

}  // namespace
}  // namespace balcony::render::test::sampler_test
