// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Directions towards triangles, suns and environments, and their densities.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "directions.hpp"
#include "shading/lights/environment_map.hpp"
#include "shading/lights/sun.hpp"
#include "shading/lights/triangle_sampling.hpp"
#include "statistics.hpp"

namespace balcony::render::test::light_shapes_test {
namespace {

using Imath::V2f;

using std::numbers::pi;

// -------------------------------------------------------------------------------- triangles

constexpr WorldTriangle slanted{{0.3F, -0.4F, 1.0F}, {1.1F, 0.2F, 0.3F}, {-0.2F, 0.9F, -0.1F}};

TEST(TriangleSampling, PassesChiSquare) {
    constexpr int draws = 200'000;
    // From close by, where sampling is by solid angle, and from afar, where it is by area.
    for (const V3f& from :
         {V3f(0.2F, 0.1F, 0.2F), V3f(0.0F, 0.0F, -12.0F), V3f(0.5F, 0.3F, 1.05F)}) {
        // In cells of the triangle itself, as from afar it lies within one cell of the sphere.
        constexpr std::size_t cells = 20;
        std::vector<double> counts(cells * cells);
        std::vector<double> expected(cells * cells);
        const auto cell = [](float u, float v) {
            const auto part = [](float x) {
                return std::min(static_cast<std::size_t>(x * cells), cells - 1);
            };
            return part(u) * cells + part(v);
        };
        Random random(1);
        for (int draw = 0; draw < draws; ++draw) {
            const auto sample = sample_triangle(slanted, from, random.pair());
            ASSERT_TRUE(sample);
            counts[cell(sample->u, sample->v)] += 1.0;
            const float again = pdf_of_triangle(slanted, from, sample->direction, sample->distance);
            ASSERT_NEAR(again / sample->pdf, 1.0F, 1e-4F);
        }
        constexpr int steps = 1200;
        const double area = 2.0 * double{slanted.area()} / (steps * steps);
        for (int i = 0; i < steps * steps; ++i) {
            // Of the squares on the diagonal, half belongs to the triangle.
            const int row = i / steps;
            const int column = i % steps;
            const bool half = row + column == steps - 1;
            if (row + column >= steps) {
                continue;
            }
            const float center = half ? 1.0F / 3.0F : 0.5F;
            const float u = (static_cast<float>(row) + center) / steps;
            const float v = (static_cast<float>(column) + center) / steps;
            const V3f way = slanted.corner + u * slanted.edge_1 + v * slanted.edge_2 - from;
            const float distance = way.length();
            const V3f direction = way / distance;
            const double solid_angle =
                (half ? 0.5 : 1.0) * area *
                double{std::abs(slanted.across().normalized().dot(direction))} /
                double{distance * distance};
            expected[cell(u, v)] +=
                draws * solid_angle * double{pdf_of_triangle(slanted, from, direction, distance)};
        }
        EXPECT_NEAR(sum(expected) / draws, 1.0, 2e-3);
        const double scale = draws / sum(expected);
        for (double& value : expected) {
            value *= scale;
        }
        EXPECT_GT(chi_square_probability(counts, expected), significance) << from;
    }
}

TEST(TriangleSampling, HitsTheTriangleItself) {
    Random random(2);
    for (int trial = 0; trial < 20'000; ++trial) {
        const auto corner = [&] { return 2.0F * random.numbers() - V3f(1.0F); };
        const V3f a = corner();
        const WorldTriangle triangle{a, corner() - a, corner() - a};
        const V3f from = 2.0F * corner();
        const auto sample = sample_triangle(triangle, from, random.pair());
        if (!sample || triangle.area() < 0.01F) {
            continue;
        }
        const V3f point =
            triangle.corner + sample->u * triangle.edge_1 + sample->v * triangle.edge_2;
        const V3f way = point - from;
        // A triangle that is seen edge-on amplifies rounding.
        const float slant = std::abs(triangle.across().normalized().dot(sample->direction));
        EXPECT_NEAR(way.length(), sample->distance, 1e-5F / slant) << trial;
        EXPECT_NEAR(way.normalized().dot(sample->direction), 1.0F, 1e-5F / slant) << trial;
    }
}

TEST(TriangleSampling, IsSafeForDegenerateTriangles) {
    const WorldTriangle point{{0.0F, 0.0F, 1.0F}, V3f(0.0F), V3f(0.0F)};
    const WorldTriangle line{{0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}};
    const WorldTriangle tiny{{0.0F, 0.0F, 1.0F}, {1e-20F, 0.0F, 0.0F}, {0.0F, 1e-20F, 0.0F}};
    const WorldTriangle huge{{-1e18F, -1e18F, 1.0F}, {3e18F, 0.0F, 0.0F}, {0.0F, 3e18F, 0.0F}};
    Random random(3);
    for (const WorldTriangle& triangle : {point, line, tiny, huge, slanted}) {
        for (const V3f& from : {V3f(0.0F), V3f(0.0F, 0.0F, 1.0F), V3f(0.5F, 0.5F, 1.0F),
                                V3f(0.0F, 0.0F, 1.0F - 1e-7F), slanted.corner}) {
            for (int draw = 0; draw < 200; ++draw) {
                const auto sample = sample_triangle(triangle, from, random.pair());
                if (sample) {
                    EXPECT_TRUE(std::isfinite(sample->pdf) && sample->pdf > 0.0F);
                    EXPECT_NEAR(sample->direction.length(), 1.0F, 1e-5F);
                    EXPECT_TRUE(std::isfinite(sample->distance));
                }
            }
        }
    }
}

// ------------------------------------------------------------------------------ environments

// A dark picture with a bright pixel, a gradient and a black part.
EnvironmentMap spotted(std::size_t width, std::size_t height) {
    std::vector<Color3f> texels;
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const float value = x < width / 4 ? 0.0F
                                : x == width / 2 && y == height / 3
                                    ? 50.0F
                                    : 0.1F + static_cast<float>(y) / static_cast<float>(height);
            texels.emplace_back(value, 0.5F * value, 0.25F);
            texels.back().z = value;
        }
    }
    return {width, height, std::move(texels)};
}

TEST(EnvironmentMap, PassesChiSquare) {
    constexpr int draws = 400'000;
    for (const auto& [width, height] : {std::pair{16UL, 8UL}, {1UL, 1UL}, {3UL, 5UL}}) {
        const EnvironmentMap map = spotted(width, height);
        std::vector<double> expected =
            SphereCells::integrals([&](const V3f& d) { return double{map.pdf(d)}; }, 24);
        EXPECT_NEAR(sum(expected), 1.0, 5e-3);
        const double scale = draws / sum(expected);
        std::vector<double> counts(expected.size());
        Random random(4);
        for (int draw = 0; draw < draws; ++draw) {
            const EnvironmentMap::Sample sample = map.sample(random.pair());
            counts[SphereCells::cell_of(sample.direction)] += 1.0;
            // A direction may be rounded across the border of a cell.
            if (draw < 10'000) {
                EXPECT_NEAR(map.pdf(sample.direction.normalized()) / sample.pdf, 1.0F, 1e-4F)
                    << sample.direction;
            }
        }
        for (double& value : expected) {
            value *= scale;
        }
        EXPECT_GT(chi_square_probability(counts, expected), significance) << width;
    }
}

TEST(EnvironmentMap, IsNeverUnlikelyWhereThereIsLight) {
    for (const auto& [width, height] : {std::pair{16UL, 8UL}, {2100UL, 1030UL}}) {
        const EnvironmentMap map = spotted(width, height);
        Random random(5);
        for (int trial = 0; trial < 20'000; ++trial) {
            const float z = 2.0F * random.number() - 1.0F;
            const float turn = 6.2831853F * random.number();
            const float across = std::sqrt(1.0F - z * z);
            const V3f direction(across * std::cos(turn), across * std::sin(turn), z);
            if (map.radiance(direction).x > 0.0F) {
                EXPECT_GT(map.pdf(direction), 0.0F);
            }
        }
    }
}

TEST(EnvironmentMap, ShowsThePictureUprightAndNotMirrored) {
    // Four columns: back and left, left and front, front and right, right and back, seen from
    // inside along x; two rows.
    std::vector<Color3f> texels;
    for (int i = 0; i < 8; ++i) {
        texels.emplace_back(static_cast<float>(i));
    }
    const EnvironmentMap map(4, 2, std::move(texels));
    const auto at = [&](float x, float y, float z) {
        return map.radiance(V3f(x, y, z).normalized()).x;
    };
    const float high = std::sqrt(2.0F);  // 45 degrees up.
    EXPECT_NEAR(at(1.0F, 1.0F, high), 1.0F, 1e-4F);
    EXPECT_NEAR(at(1.0F, -1.0F, high), 2.0F, 1e-4F);
    EXPECT_NEAR(at(-1.0F, 1.0F, -high), 4.0F, 1e-4F);
    EXPECT_NEAR(at(-1.0F, -1.0F, -high), 7.0F, 1e-4F);
    EXPECT_NEAR(at(1.0F, 0.0F, 1.0F), 1.5F, 1e-4F);
    EXPECT_NEAR(at(-1.0F, 0.0F, 1.0F), 1.5F, 1e-4F);  // Column 0 follows column 3.
    EXPECT_NEAR(map.mean().x, 3.5F, 1e-4F);
}

// -------------------------------------------------------------------------------------- suns

TEST(Sun, PassesChiSquare) {
    constexpr int draws = 100'000;
    for (const double angle : {9.3e-3, 0.5, pi}) {
        const Sun sun(V3f(0.48F, 0.6F, 0.64F), Color3f(1.0F), angle);
        // Rings and sectors of equal solid angle.
        std::vector<double> counts(64);
        const std::vector<double> expected(64, draws / 64.0);
        const V3f side = sun.to_light().cross(V3f(0.0F, 0.0F, 1.0F)).normalized();
        const V3f up = sun.to_light().cross(side);
        Random random(6);
        int outside = 0;
        for (int draw = 0; draw < draws; ++draw) {
            const V3f direction = sun.sample(random.pair());
            outside += sun.covers(direction) ? 0 : 1;
            const double ring = double{(direction - sun.to_light()).length2()} /
                                (4.0 * std::sin(0.25 * angle) * std::sin(0.25 * angle));
            const double turn =
                std::atan2(double{direction.dot(up)}, double{direction.dot(side)}) / (2.0 * pi) +
                0.5;
            const auto part = [](double x) {
                return std::min(static_cast<std::size_t>(x * 8.0), std::size_t{7});
            };
            counts[part(ring) * 8 + part(turn)] += 1.0;
        }
        // Only rounding leads outside.
        EXPECT_LT(outside, draws / 1000);
        EXPECT_GT(chi_square_probability(counts, expected), significance) << angle;
        const double solid_angle = 4.0 * pi * std::sin(0.25 * angle) * std::sin(0.25 * angle);
        EXPECT_NEAR(double{sun.pdf()} * solid_angle, 1.0, 1e-5);
    }
}

}  // namespace
}  // namespace balcony::render::test::light_shapes_test
