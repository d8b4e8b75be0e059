// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A set of lights that is asked for one.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stop_token>

#include <gtest/gtest.h>

#include "shading/lights/light_set.hpp"
#include "support.hpp"

namespace balcony::render::test::light_set_test {
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

// Numbers at even distances: the mean of what arrives over its probability is the sum of all lamps.
TEST(LightSet, LampsAddUp) {
    constexpr int draws = 10000;
    for (const std::size_t lamps : {1U, 2U, 7U}) {
        const scene::Scene scene = lit_scene(lamps, false);
        const LightSet lights(scene);
        double all = 0.0;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            all += double{lights.arriving(i, point).irradiance.x};
        }
        double mean = 0.0;
        for (int draw = 0; draw < draws; ++draw) {
            const float random = (static_cast<float>(draw) + 0.5F) / draws;
            const auto sample = lights.sample(point, {random, 0.5F, 0.5F});
            ASSERT_TRUE(sample);
            EXPECT_TRUE(sample->delta);
            mean += double{sample->radiance.x / sample->pdf} / draws;
        }
        EXPECT_NEAR(mean, all, all * 2.0 * static_cast<double>(lamps) / draws);
    }
}

TEST(LightSet, IsSafeAtTheEndsOfTheNumbers) {
    const scene::Scene none = lit_scene(0, false);
    EXPECT_EQ(LightSet(none).size(), 0U);
    EXPECT_FALSE(LightSet(none).sample(point, V3f(0.5F)));
    const scene::Scene three = lit_scene(3, false);
    EXPECT_TRUE(LightSet(three).sample(point, V3f(0.0F)));
    EXPECT_TRUE(LightSet(three).sample(point, V3f(0x1.fffffep-1F)));
}

TEST(LightSet, TheLightAtTheViewerComesFromThereWithoutShadow) {
    const scene::Scene scene = lit_scene(0, true);
    const Illumination arriving = LightSet(scene).arriving(0, point);
    EXPECT_EQ(arriving.to_light, point.to_viewer);
    EXPECT_EQ(arriving.distance, 0.0F);
}

constexpr LitPoint floor_point{{0.1F, 0.0F, 0.2F}, {0.0F, 1.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};

// The irradiance of a point, by samples on a grid of numbers. Checks that sample() and the pdf of
// what it finds agree.
double irradiance(const LightSet& lights, const LitPoint& at, int steps) {
    double sum = 0.0;
    for (int i = 0; i < steps * steps * steps; ++i) {
        const auto number = [steps](int k) {
            return (static_cast<float>(k % steps) + 0.5F) / static_cast<float>(steps);
        };
        const auto sample =
            lights.sample(at, {number(i), number(i / steps), number(i / steps / steps)});
        if (!sample) {
            continue;
        }
        if (std::isinf(sample->distance) && !sample->delta) {
            EXPECT_NEAR(lights.pdf_of_distant(at, sample->to_light) / sample->pdf, 1.0F, 1e-4F);
        }
        const float cosine = std::max(0.0F, at.normal.dot(sample->to_light));
        sum += double{sample->radiance.x * cosine / sample->pdf};
    }
    return sum / (steps * steps * steps);
}

TEST(LightSet, AConstantDomeGivesPi) {
    const scene::Scene scene = lit_scene(0, false);
    const LightSet lights = LightSet(scene).with(Environment::constant(Color3f(1.0F)));
    EXPECT_NEAR(irradiance(lights, floor_point, 20), std::numbers::pi, 1e-4);
}

// Lambert's formula for a polygon (1760).
double irradiance_of_square(const V3d& at, const std::array<V3d, 4>& corners) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const V3d a = (corners[i] - at).normalized();
        const V3d b = (corners[(i + 1) % 4] - at).normalized();
        sum += std::acos(a.dot(b)) * a.cross(b).normalized().y;
    }
    return std::abs(0.5 * sum);
}

TEST(LightSet, ASquareGivesItsIrradiance) {
    scene::Scene scene;
    scene::Material lamp;
    lamp.emission = Color3f(2.0F);
    add(scene, parallelogram({-1.0F, 2.0F, -1.0F}, {2.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 2.0F}), lamp);
    const double expected = 2.0 * irradiance_of_square(V3d(floor_point.position),
                                                       {V3d(-1.0, 2.0, -1.0), V3d(1.0, 2.0, -1.0),
                                                        V3d(1.0, 2.0, 1.0), V3d(-1.0, 2.0, 1.0)});
    EXPECT_NEAR(irradiance(LightSet(scene), floor_point, 40), expected, 1e-3);
}

// Nothing was built that samples could be taken from.
TEST(LightSet, ObeysAStop) {
    scene::Scene scene = lit_scene(3, false);
    scene::Material lamp = white();
    lamp.emission = Color3f(1.0F);
    add(scene, wall(-1.0F, 1.0F), lamp);
    std::stop_source stop;
    EXPECT_TRUE(LightSet(scene, nullptr, {}, stop.get_token()).sample(point, V3f(0.5F)));
    stop.request_stop();
    const LightSet stopped(scene, nullptr, {}, stop.get_token());
    EXPECT_FALSE(stopped.sample(point, V3f(0.5F)));
}

}  // namespace
}  // namespace balcony::render::test::light_set_test
