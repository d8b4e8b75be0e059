// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A set of lights that is asked for one.

#include <vector>

#include <gtest/gtest.h>

#include "render/shading/lights.hpp"
#include "statistics.hpp"
#include "support.hpp"

namespace balcony::render::test {
namespace {

constexpr LitPoint point{{1.0F, 2.0F, 3.0F}, {0.0F, 0.0F, 1.0F}};

scene::Scene lit_scene(std::size_t lamps, bool default_light) {
    scene::Scene scene;
    scene.default_light = default_light;
    for (std::size_t i = 0; i < lamps; ++i) {
        scene::Light lamp;
        lamp.position = V3d(static_cast<double>(i), 5.0, -2.0);
        lamp.intensity = Color3f(1.0F + static_cast<float>(i));
        scene.lights.push_back(lamp);
    }
    return scene;
}

// Numbers at even distances: each light is hit as often as its probability says, and the mean of
// what arrives over the probability is the sum of all.
TEST(LightSet, SamplesHaveTheirProbabilityAndAddUp) {
    constexpr int draws = 10000;
    for (const std::size_t lamps : {1U, 2U, 7U}) {
        for (const bool default_light : {false, true}) {
            const scene::Scene scene = lit_scene(lamps, default_light);
            const LightSet lights(scene);
            ASSERT_EQ(lights.size(), lamps + (default_light ? 1 : 0));
            double all = 0.0;
            std::vector<double> counts(lights.size());
            std::vector<double> probabilities(lights.size());
            for (std::size_t i = 0; i < lights.size(); ++i) {
                all += double{lights.arriving(i, point).irradiance.x};
            }
            double mean = 0.0;
            for (int draw = 0; draw < draws; ++draw) {
                const auto sample = lights.sample(point, (static_cast<float>(draw) + 0.5F) / draws);
                ASSERT_TRUE(sample);
                mean += double{sample->arriving.irradiance.x / sample->probability} / draws;
                for (std::size_t i = 0; i < lights.size(); ++i) {
                    if (lights.arriving(i, point).irradiance == sample->arriving.irradiance) {
                        counts[i] += 1.0;
                        probabilities[i] = double{sample->probability};
                    }
                }
            }
            double total = 0.0;
            for (std::size_t i = 0; i < lights.size(); ++i) {
                total += probabilities[i];
                // One draw more or less at either end of a light's part.
                EXPECT_NEAR(counts[i], probabilities[i] * draws, 2.0);
            }
            EXPECT_NEAR(total, 1.0, 1e-6);
            EXPECT_NEAR(mean, all, all * 2.0 * static_cast<double>(lights.size()) / draws);
        }
    }
}

TEST(LightSet, IsSafeAtTheEndsOfTheNumbers) {
    const scene::Scene none = lit_scene(0, false);
    EXPECT_EQ(LightSet(none).size(), 0U);
    EXPECT_FALSE(LightSet(none).sample(point, 0.5F));
    const scene::Scene three = lit_scene(3, false);
    EXPECT_TRUE(LightSet(three).sample(point, 0.0F));
    EXPECT_TRUE(LightSet(three).sample(point, 0x1.fffffep-1F));
}

TEST(LightSet, TheLightAtTheViewerComesFromThereWithoutShadow) {
    const scene::Scene scene = lit_scene(0, true);
    const Illumination arriving = LightSet(scene).arriving(0, point);
    EXPECT_EQ(arriving.to_light, point.to_viewer);
    EXPECT_EQ(arriving.distance, 0.0F);
}

}  // namespace
}  // namespace balcony::render::test
