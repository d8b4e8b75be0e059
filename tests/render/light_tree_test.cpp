// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The choice of one of many lights at finite distances.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "directions.hpp"
#include "shading/lights/light_tree.hpp"
#include "statistics.hpp"

namespace balcony::render::test::light_tree_test {
namespace {

using Imath::V3f;

LightBounds lamp(const V3f& position, float power) {
    LightBounds bounds;
    bounds.box.extendBy(position);
    bounds.cosine_spread = -1.0F;
    bounds.cosine_falloff = 0.0F;
    bounds.power = power;
    return bounds;
}

// A small surface, with or without a back.
LightBounds patch(const V3f& position, const V3f& normal, float half, bool two_sided) {
    LightBounds bounds;
    bounds.box = {position - V3f(half), position + V3f(half)};
    bounds.axis = normal;
    bounds.cosine_falloff = 0.0F;
    bounds.two_sided = two_sided;
    bounds.power = half * half;
    return bounds;
}

std::vector<LightBounds> mixed_lights(std::size_t count, unsigned seed) {
    Random random(seed);
    std::vector<LightBounds> lights;
    for (std::size_t i = 0; i < count; ++i) {
        const V3f position = random.point(1.0F);
        lights.push_back(i % 3 == 0 ? lamp(position, random.number())
                                    : patch(position, random.direction(), 0.05F, i % 3 == 1));
    }
    return lights;
}

TEST(LightTree, ChoosesEachLightAsOftenAsItSays) {
    constexpr int draws = 100'000;
    const std::vector<LightBounds> lights = mixed_lights(60, 1);
    const LightTree tree(lights);
    Random random(2);
    for (int place = 0; place < 8; ++place) {
        const V3f position = random.point(0.8F);
        const V3f normal = place % 2 == 0 ? V3f(0.0F) : random.direction();
        // The last cell counts where bounds turn out to be narrower below than above.
        std::vector<double> counts(lights.size() + 1);
        std::vector<double> expected(lights.size() + 1);
        expected.back() = draws;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            expected[i] = draws * double{tree.probability(position, normal, i)};
            expected.back() -= expected[i];
        }
        for (int draw = 0; draw < draws; ++draw) {
            const auto chosen = tree.choose(position, normal, random.number());
            counts[chosen ? chosen->light : lights.size()] += 1.0;
            if (chosen) {
                EXPECT_NEAR(chosen->probability / tree.probability(position, normal, chosen->light),
                            1.0F, 1e-5F);
            }
        }
        EXPECT_GT(chi_square_probability(counts, expected), significance) << place;
    }
}

TEST(LightTree, ProbabilitiesAddUpToOne) {
    const std::vector<LightBounds> lights = mixed_lights(1000, 3);
    const LightTree tree(lights);
    Random random(4);
    for (int place = 0; place < 20; ++place) {
        // Without a normal, the lamps arrive everywhere, so no branch is a dead end.
        const V3f position = random.point(1.5F);
        double total = 0.0;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            total += double{tree.probability(position, V3f(0.0F), i)};
        }
        EXPECT_LE(total, 1.0 + 1e-4);
        EXPECT_GT(total, 0.95);
    }
}

TEST(LightTree, EveryLightThatArrivesMayBeChosen) {
    const std::vector<LightBounds> lights = mixed_lights(300, 5);
    const LightTree tree(lights);
    Random random(6);
    std::size_t arriving = 0;
    for (int trial = 0; trial < 100'000; ++trial) {
        const auto light = static_cast<std::size_t>(random.number() * 300.0F);
        const LightBounds& one = lights[light];
        const V3f from =
            one.box.min + V3f(random.number(), random.number(), random.number()) * one.box.size();
        const V3f position = random.point(1.5F);
        const V3f normal = random.direction();
        const V3f to_light = (from - position).normalized();
        const float leaving = -to_light.dot(one.axis);
        const bool leaves =
            one.cosine_spread < 0.0F || leaving > 0.0F || (one.two_sided && leaving < 0.0F);
        if (leaves && to_light.dot(normal) > 0.0F) {
            ++arriving;
            ASSERT_GT(tree.probability(position, normal, light), 0.0F) << trial;
        }
    }
    EXPECT_GT(arriving, 30'000U);
}

TEST(LightTree, PrefersTheNearTheStrongAndTheFacing) {
    const auto share = [](const LightBounds& first, const LightBounds& second) {
        const std::vector<LightBounds> two{first, second};
        return LightTree(two).probability(V3f(0.0F), V3f(0.0F, 0.0F, 1.0F), 0);
    };
    const V3f down(0.0F, 0.0F, -1.0F);
    EXPECT_NEAR(share(lamp({0.0F, 0.0F, 1.0F}, 1.0F), lamp({0.0F, 0.0F, 2.0F}, 1.0F)), 0.8F, 1e-4F);
    EXPECT_NEAR(share(lamp({0.0F, 0.0F, 1.0F}, 3.0F), lamp({0.0F, 0.0F, 1.0F}, 1.0F)), 0.75F,
                1e-4F);
    EXPECT_EQ(share(lamp({0.0F, 0.0F, 1.0F}, 1.0F), lamp({0.0F, 0.0F, -1.0F}, 1.0F)), 1.0F);
    const V3f above(0.0F, 0.0F, 1.0F);
    EXPECT_EQ(share(patch(above, down, 0.01F, false), patch(above, -down, 0.01F, false)), 1.0F);
    EXPECT_NEAR(share(patch(above, down, 0.01F, false), patch(above, -down, 0.01F, true)), 0.5F,
                1e-3F);
}

TEST(LightTree, SkipsLightsWithoutPower) {
    const std::vector<LightBounds> dark{lamp({0.0F, 0.0F, 1.0F}, 0.0F), LightBounds{}};
    EXPECT_TRUE(LightTree(dark).empty());
    EXPECT_FALSE(LightTree(dark).choose(V3f(0.0F), V3f(0.0F), 0.5F));
    EXPECT_TRUE(LightTree({}).empty());
    const std::vector<LightBounds> one{lamp({0.0F, 0.0F, 1.0F}, 0.0F),
                                       lamp({0.0F, 0.0F, 2.0F}, 1e-20F)};
    const auto chosen = LightTree(one).choose(V3f(0.0F), V3f(0.0F), 0.5F);
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->light, 1U);
    EXPECT_EQ(chosen->probability, 1.0F);
}

TEST(LightTree, TakesManyLightsInOnePlace) {
    const std::vector<LightBounds> lights(20'000, lamp({1.0F, 2.0F, 3.0F}, 1.0F));
    const LightTree tree(lights);
    const auto chosen = tree.choose(V3f(0.0F), V3f(0.0F), 0.7F);
    ASSERT_TRUE(chosen);
    EXPECT_NEAR(chosen->probability * 20'000.0F, 1.0F, 0.5F);
}

TEST(LightTree, TakesLightsOfAnyStrength) {
    std::vector<LightBounds> lights;
    for (int i = 0; i < 60; ++i) {
        lights.push_back(
            lamp({static_cast<float>(i), 0.0F, 0.0F}, std::pow(10.0F, static_cast<float>(i - 30))));
    }
    const LightTree tree(lights);
    Random random(7);
    for (int draw = 0; draw < 1000; ++draw) {
        const auto chosen = tree.choose({0.5F, 1e-20F, 0.0F}, V3f(0.0F), random.number());
        ASSERT_TRUE(chosen);
        EXPECT_GT(chosen->probability, 0.0F);
    }
}

// The angle between an axis of a light and the mean axis, plus the light's own.
TEST(LightBounds, ContainTheDirectionsOfAll) {
    Random random(8);
    for (int trial = 0; trial < 10'000; ++trial) {
        std::vector<LightBounds> lights;
        for (int i = 0; i < 1 + trial % 5; ++i) {
            lights.push_back(patch(random.point(1.0F), random.direction(), 0.1F, trial % 2 == 0));
            lights.back().cosine_spread = 1.0F - random.number() * random.number();
        }
        const LightBounds all = bounds_of(lights);
        for (const LightBounds& one : lights) {
            const V3f direction = (one.axis + random.point(0.5F)).normalized();
            if (direction.dot(one.axis) > one.cosine_spread) {
                const float cosine = direction.dot(all.axis);
                EXPECT_GT(all.two_sided ? std::abs(cosine) : cosine, all.cosine_spread - 1e-3F);
            }
            EXPECT_TRUE(all.box.intersects(one.box.min) && all.box.intersects(one.box.max));
        }
    }
}

}  // namespace
}  // namespace balcony::render::test::light_tree_test
