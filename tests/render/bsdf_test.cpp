// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The laws of a BSDF.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "render/shading/bsdf.hpp"
#include "statistics.hpp"

namespace balcony::render::test {
namespace {

constexpr double pi = std::numbers::pi;

float largest(const Color3f& c) { return std::max({c.x, c.y, c.z}); }

Appearance appearance(float metallic, float roughness, const Color3f& color = Color3f(1.0F)) {
    return {color, Color3f(0.0F), 1.0F, metallic, roughness};
}

class Directions {
public:
    explicit Directions(unsigned seed) : random_(seed) {}

    float uniform() { return uniform_(random_); }

    V3f on_sphere() {
        const float z = 2.0F * uniform() - 1.0F;
        const float angle = 2.0F * static_cast<float>(pi) * uniform();
        const float radius = std::sqrt(std::max(1.0F - z * z, 0.0F));
        return V3f(radius * std::cos(angle), radius * std::sin(angle), z).normalized();
    }
    V3f above(const V3f& normal, float min_cosine) {
        for (;;) {
            if (const V3f v = on_sphere(); v.dot(normal) > min_cosine) {
                return v;
            }
        }
    }

private:
    std::mt19937 random_;
    std::uniform_real_distribution<float> uniform_{0.0F, 1.0F};
};

// Materials of every kind: matt, glossy and mirroring; dielectric, metallic and between.
std::vector<Appearance> materials() {
    std::vector<Appearance> all;
    for (const float metallic : {0.0F, 0.4F, 1.0F}) {
        for (const float roughness : {0.05F, 0.3F, 0.6F, 1.0F}) {
            all.push_back(appearance(metallic, roughness, {0.9F, 0.5F, 0.2F}));
        }
    }
    return all;
}

TEST(Bsdf, IsReciprocal) {
    Directions random(1);
    for (const Appearance& material : materials()) {
        for (int trial = 0; trial < 1000; ++trial) {
            const V3f normal = random.on_sphere();
            const Bsdf bsdf(material, normal, normal);
            const V3f a = random.above(normal, 0.02F);
            const V3f b = random.above(normal, 0.02F);
            const Color3f there = bsdf.eval(a, b) / normal.dot(b);
            const Color3f back = bsdf.eval(b, a) / normal.dot(a);
            // The peak of the distribution is 1 / roughness^4 times as sensitive to the rounding of
            // the half vector as a float is precise: 0.3^-4 is 123. Fresnel's fifth power and two
            // divisions by cosines of 0.02 add a few roundings.
            constexpr float rounding = 130.0F * 16.0F * 6e-8F;
            EXPECT_NEAR(there.x, back.x, rounding * std::max(there.x, 1.0F));
            EXPECT_NEAR(there.z, back.z, rounding * std::max(there.z, 1.0F));
        }
    }
}

TEST(Bsdf, ReflectsNothingFromBelow) {
    Directions random(2);
    for (const Appearance& material : materials()) {
        for (int trial = 0; trial < 200; ++trial) {
            const V3f geometric = random.on_sphere();
            const V3f normal = random.above(geometric, 0.3F);
            const Bsdf bsdf(material, normal, geometric);
            const V3f viewer = random.above(normal, 0.01F);
            EXPECT_EQ(bsdf.eval(viewer, -random.above(geometric, 0.0F)), Color3f(0.0F));
            EXPECT_EQ(bsdf.eval(viewer, -random.above(normal, 0.0F)), Color3f(0.0F));
        }
    }
}

// What a surface gives off in a direction of even light of radiance 1, by the midpoint rule over
// cells of equal solid angle; without the mirror.
double albedo(const Bsdf& bsdf, const V3f& to_viewer) {
    constexpr int rows = 600;
    constexpr int columns = 600;
    double total = 0.0;
    for (int row = 0; row < rows; ++row) {
        const double z = (row + 0.5) / rows;
        for (int column = 0; column < columns; ++column) {
            const double angle = 2.0 * pi * (column + 0.5) / columns;
            const double radius = std::sqrt(1.0 - z * z);
            const V3f light(static_cast<float>(radius * std::cos(angle)),
                            static_cast<float>(radius * std::sin(angle)), static_cast<float>(z));
            total += double{bsdf.eval(to_viewer, light).x};
        }
    }
    return total * 2.0 * pi / (rows * columns);
}

V3f at_cosine(float cosine) { return {std::sqrt(1.0F - cosine * cosine), 0.0F, cosine}; }

// Each lobe gives off no more than it receives. A black dielectric has the highlight alone, and
// what a white one has more is its matt part. Together they may exceed 1, which docs/rendering.md
// says.
TEST(Bsdf, NoLobeGivesOffMoreThanItReceives) {
    const V3f normal(0.0F, 0.0F, 1.0F);
    constexpr double quadrature = 2e-3;  // 600 x 600 cells at roughness 0.3, against 1200 x 1200.
    Directions random(4);
    for (const float roughness : {0.3F, 0.6F, 1.0F}) {
        const Bsdf metal(appearance(1.0F, roughness), normal, normal);
        const Bsdf black(appearance(0.0F, roughness, Color3f(0.0F)), normal, normal);
        const Bsdf white(appearance(0.0F, roughness), normal, normal);
        for (int trial = 0; trial < 8; ++trial) {
            const V3f viewer = random.above(normal, 0.02F);
            EXPECT_LE(albedo(metal, viewer), 1.0 + quadrature) << roughness;
            const double highlight = albedo(black, viewer);
            EXPECT_LE(highlight, 1.0 + quadrature) << roughness;
            EXPECT_LE(albedo(white, viewer) - highlight, 1.0 + quadrature) << roughness;
        }
    }
}

struct SphereCells {
    static constexpr std::size_t rows = 24;
    static constexpr std::size_t columns = 24;

    static std::size_t cell(const V3f& v) {
        const double angle = std::atan2(double{v.y}, double{v.x}) / (2.0 * pi) + 0.5;
        const auto row = static_cast<std::size_t>(0.5 * (double{v.z} + 1.0) * rows);
        const auto column = static_cast<std::size_t>(angle * columns);
        return std::min(row, rows - 1) * columns + std::min(column, columns - 1);
    }

    // The integral of a density over each cell.
    static std::vector<double> integrate(const Bsdf& bsdf, const V3f& to_viewer) {
        constexpr std::size_t fine = 40;
        std::vector<double> integrals(rows * columns);
        for (std::size_t j = 0; j < rows * fine; ++j) {
            const double z = 2.0 * (static_cast<double>(j) + 0.5) / (rows * fine) - 1.0;
            for (std::size_t i = 0; i < columns * fine; ++i) {
                const double angle =
                    2.0 * pi * ((static_cast<double>(i) + 0.5) / (columns * fine) - 0.5);
                const double radius = std::sqrt(1.0 - z * z);
                const V3f light(static_cast<float>(radius * std::cos(angle)),
                                static_cast<float>(radius * std::sin(angle)),
                                static_cast<float>(z));
                integrals[j / fine * columns + i / fine] += double{bsdf.pdf(to_viewer, light)};
            }
        }
        for (double& integral : integrals) {
            integral *= 4.0 * pi / (rows * columns * fine * fine);
        }
        return integrals;
    }
};

double sum(const std::vector<double>& values) {
    double total = 0.0;
    for (const double value : values) {
        total += value;
    }
    return total;
}

// Over the sphere the density is that of a direction or of the mirror.
TEST(Bsdf, TheDensityIntegratesToOne) {
    const V3f normal(0.0F, 0.0F, 1.0F);
    for (const Appearance& material : materials()) {
        const Bsdf bsdf(material, normal, normal);
        for (const float cosine : {0.15F, 0.7F, 1.0F}) {
            const V3f viewer = at_cosine(cosine);
            double mirror = 0.0;
            if (const auto found = bsdf.sample_mirror(viewer)) {
                // The mirror is chosen by how much it weighs among both lobes.
                const Color3f rest = (Color3f(1.0F) - found->weight) * (1.0F - material.metallic) *
                                     material.base_color;
                mirror = double{largest(found->weight) / (largest(found->weight) + largest(rest))};
            }
            // The midpoint rule's error where the density is cut off at the horizon and at the
            // peak of roughness 0.3, found by halving the cells.
            constexpr double quadrature = 3e-3;
            EXPECT_NEAR(sum(SphereCells::integrate(bsdf, viewer)) + mirror, 1.0, quadrature)
                << material.metallic << " " << material.roughness << " " << cosine;
        }
    }
}

TEST(Bsdf, SamplesFollowTheDensity) {
    constexpr int draws = 200000;
    const V3f normal(0.0F, 0.0F, 1.0F);
    unsigned seed = 10;
    for (const Appearance& material : materials()) {
        const Bsdf bsdf(material, normal, normal);
        for (const float cosine : {0.15F, 0.7F}) {
            const V3f viewer = at_cosine(cosine);
            Directions random(++seed);
            std::vector<double> expected = SphereCells::integrate(bsdf, viewer);
            std::vector<double> counts(expected.size());
            double nothing = 0.0;
            double mirror = 0.0;
            for (int draw = 0; draw < draws; ++draw) {
                const auto sample =
                    bsdf.sample(viewer, {random.uniform(), random.uniform(), random.uniform()});
                if (!sample) {
                    nothing += 1.0;
                } else if (sample->delta) {
                    mirror += 1.0;
                } else {
                    counts[SphereCells::cell(sample->to_light)] += 1.0;
                    EXPECT_NEAR(sample->pdf, bsdf.pdf(viewer, sample->to_light), 1e-6F);
                }
            }
            // What lies below the horizon is where sampling finds nothing; the mirror has the rest.
            double below = 0.0;
            for (std::size_t i = 0; i < expected.size() / 2; ++i) {
                below += expected[i];
                expected[i] = 0.0;
            }
            const double above = sum(expected);
            if (above + below == 0.0) {
                EXPECT_EQ(mirror, draws);
                continue;
            }
            for (double& value : expected) {
                value *= draws;
            }
            expected.push_back(below * draws);
            counts.push_back(nothing);
            expected.push_back((1.0 - above - below) * draws);
            counts.push_back(mirror);
            EXPECT_GT(chi_square_probability(counts, expected), significance)
                << material.metallic << " " << material.roughness << " " << cosine;
        }
    }
}

// The mean of the weights is the integral of what is reflected.
TEST(Bsdf, WeightsAddUpToWhatIsReflected) {
    constexpr int draws = 100000;
    const V3f normal(0.0F, 0.0F, 1.0F);
    for (const float roughness : {0.3F, 1.0F}) {
        const Bsdf bsdf(appearance(0.0F, roughness), normal, normal);
        const V3f viewer = at_cosine(0.7F);
        Directions random(99);
        double total = 0.0;
        double squares = 0.0;
        for (int draw = 0; draw < draws; ++draw) {
            const auto sample =
                bsdf.sample(viewer, {random.uniform(), random.uniform(), random.uniform()});
            const double weight = sample ? double{sample->weight.x} : 0.0;
            total += weight / draws;
            squares += weight * weight / draws;
        }
        const double deviation = std::sqrt((squares - total * total) / draws);
        EXPECT_NEAR(total, albedo(bsdf, viewer), 4.0 * deviation + 1e-3) << roughness;
    }
}

TEST(Bsdf, AMirrorObeysTheLawOfReflection) {
    Directions random(3);
    for (int trial = 0; trial < 1000; ++trial) {
        const V3f normal = random.on_sphere();
        const V3f viewer = random.above(normal, 0.01F);
        const Bsdf bsdf(appearance(1.0F, 0.0F, {0.8F, 0.6F, 0.4F}), normal, normal);
        const auto sample = bsdf.sample_mirror(viewer);
        ASSERT_TRUE(sample && sample->delta);
        EXPECT_NEAR(sample->to_light.dot(normal), viewer.dot(normal), 1e-6F);
        EXPECT_NEAR(sample->to_light.cross(viewer).dot(normal), 0.0F, 1e-6F);
        EXPECT_LE(largest(sample->weight), 1.0F + 1e-6F);
        // A mirror of metal is chosen always.
        const auto chosen = bsdf.sample(viewer, {0.9F, 0.5F, 0.5F});
        ASSERT_TRUE(chosen && chosen->delta);
        EXPECT_EQ(chosen->to_light, sample->to_light);
        EXPECT_EQ(bsdf.eval(viewer, sample->to_light), Color3f(0.0F));
        EXPECT_EQ(bsdf.pdf(viewer, sample->to_light), 0.0F);
    }
    EXPECT_FALSE(Bsdf(appearance(1.0F, 0.5F), {0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 1.0F})
                     .sample_mirror({0.0F, 0.0F, 1.0F}));
}

TEST(Bsdf, BlackSurfacesGiveOffNothing) {
    const V3f normal(0.0F, 0.0F, 1.0F);
    const Bsdf bsdf(appearance(1.0F, 0.5F, Color3f(0.0F)), normal, normal);
    EXPECT_FALSE(bsdf.sample(normal, {0.5F, 0.0F, 0.0F}));
    EXPECT_EQ(bsdf.eval(normal, normal), Color3f(0.0F));
}

}  // namespace
}  // namespace balcony::render::test
