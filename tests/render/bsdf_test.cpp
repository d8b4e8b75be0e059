// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The laws of a BSDF.

#include <gtest/gtest.h>

#include "bsdf_support.hpp"

namespace balcony::render::test {
namespace {

TEST(Bsdf, IsReciprocal) {
    Directions random(1);
    for (const NamedAppearance& material : all_kinds()) {
        for (int trial = 0; trial < 1000; ++trial) {
            const V3f normal = random.on_sphere();
            const Bsdf bsdf(material.appearance, normal, normal, material.entering);
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
    for (const NamedAppearance& material : all_kinds()) {
        for (int trial = 0; trial < 200; ++trial) {
            const V3f geometric = random.on_sphere();
            const V3f normal = random.above(geometric, 0.3F);
            const Bsdf bsdf(material.appearance, normal, geometric, material.entering);
            const V3f viewer = random.above(normal, 0.01F);
            EXPECT_EQ(bsdf.eval(viewer, -random.above(geometric, 0.0F)), Color3f(0.0F));
            EXPECT_EQ(bsdf.eval(viewer, -random.above(normal, 0.0F)), Color3f(0.0F));
        }
    }
}

TEST(Bsdf, AMirrorObeysTheLawOfReflection) {
    Directions random(3);
    for (int trial = 0; trial < 1000; ++trial) {
        const V3f normal = random.on_sphere();
        const V3f viewer = random.above(normal, 0.01F);
        const Bsdf bsdf(metal(0.0F, {0.8F, 0.6F, 0.4F}), normal, normal);
        const auto sample = bsdf.sample_mirror(viewer);
        ASSERT_TRUE(sample && sample->delta);
        EXPECT_NEAR(sample->to_light.dot(normal), viewer.dot(normal), 1e-6F);
        EXPECT_NEAR(sample->to_light.cross(viewer).dot(normal), 0.0F, 1e-6F);
        EXPECT_LE(brightest(sample->weight), 1.0F + 1e-6F);
        // A mirror of metal is chosen always.
        const auto chosen = bsdf.sample(viewer, {0.9F, 0.5F, 0.5F});
        ASSERT_TRUE(chosen && chosen->delta);
        EXPECT_EQ(chosen->to_light, sample->to_light);
        EXPECT_EQ(bsdf.eval(viewer, sample->to_light), Color3f(0.0F));
        EXPECT_EQ(bsdf.pdf(viewer, sample->to_light), 0.0F);
    }
    EXPECT_FALSE(flat(metal(0.5F)).sample_mirror({0.0F, 0.0F, 1.0F}));
}

TEST(Bsdf, BlackSurfacesGiveOffNothing) {
    const V3f normal(0.0F, 0.0F, 1.0F);
    const Bsdf bsdf = flat(metal(0.5F, Color3f(0.0F)));
    EXPECT_FALSE(bsdf.sample(normal, {0.5F, 0.0F, 0.0F}));
    EXPECT_EQ(bsdf.eval(normal, normal), Color3f(0.0F));
}

}  // namespace
}  // namespace balcony::render::test
