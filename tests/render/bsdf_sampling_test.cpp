// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The samples of a BSDF against its density.

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "bsdf_support.hpp"
#include "directions.hpp"
#include "statistics.hpp"

namespace balcony::render::test::bsdf_sampling_test {
namespace {

TEST(BsdfSampling, FollowsTheDensity) {
    constexpr int draws = 100000;
    unsigned seed = 10;
    for (const NamedAppearance& material : all_kinds()) {
        const Bsdf bsdf = flat(material);
        for (const float cosine : {0.15F, 0.7F}) {
            const V3f viewer = at_cosine(cosine);
            Directions random(++seed);
            std::vector<double> expected = SphereCells::integrals(
                [&](const V3f& light) { return double{bsdf.evaluate(viewer, light).pdf}; }, 16);
            std::vector<double> counts(expected.size());
            double others = 0.0;
            for (int draw = 0; draw < draws; ++draw) {
                const auto sample = bsdf.sample(viewer, random.numbers());
                if (sample && !sample->delta) {
                    counts[SphereCells::cell_of(sample->to_light)] += 1.0;
                } else {
                    others += 1.0;
                }
            }
            const double found = sum(expected);
            // The midpoint rule's error at the horizon and at the peak of roughness 0.3, found by
            // halving the cells.
            constexpr double quadrature = 3e-3;
            EXPECT_LE(found, 1.0 + quadrature) << material.name << " " << cosine;
            if (others == draws) {
                EXPECT_EQ(found, 0.0) << material.name << " " << cosine;
                continue;
            }
            for (double& value : expected) {
                value *= draws;
            }
            expected.push_back(std::max(1.0 - found, 0.0) * draws);
            counts.push_back(others);
            EXPECT_GT(chi_square_probability(counts, expected), significance)
                << material.name << " " << cosine;
        }
    }
}

TEST(BsdfSampling, WeightsAreTheReflectedLightOverTheDensity) {
    Directions random(7);
    for (int trial = 0; trial < 20000; ++trial) {
        const Bsdf bsdf = flat(random.material());
        const V3f viewer = random.above({0.0F, 0.0F, 1.0F}, 0.01F);
        const auto sample = bsdf.sample(viewer, random.numbers());
        if (!sample || sample->delta) {
            continue;
        }
        const Bsdf::Value value = bsdf.evaluate(viewer, sample->to_light);
        EXPECT_EQ(value.pdf, sample->pdf);
        EXPECT_NEAR(sample->weight.y, value.reflected.y / value.pdf,
                    1e-6F * std::max(sample->weight.y, 1.0F));
        EXPECT_NEAR(sample->to_light.length(), 1.0F, 1e-6F);
        EXPECT_NEAR(sample->facet_normal.length(), 1.0F, 1e-6F);
    }
}

}  // namespace
}  // namespace balcony::render::test::bsdf_sampling_test
