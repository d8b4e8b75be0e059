// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What a BSDF gives off of the light that it receives.

#include <cmath>

#include <gtest/gtest.h>

#include "bsdf_support.hpp"

namespace balcony::render::test {
namespace {

constexpr float roughnesses[] = {0.0F, 0.02F, 0.032F, 0.05F, 0.08F, 0.1F, 0.15F, 0.2F, 0.3F,
                                 0.4F, 0.5F,  0.6F,   0.7F,  0.8F,  0.9F, 0.97F, 1.0F};
constexpr float cosines[] = {0.002F, 0.01F, 0.03F, 0.07F, 0.15F, 0.25F,
                             0.4F,   0.55F, 0.7F,  0.85F, 1.0F};

// What is white and closed gives off all light that it receives, within half a percent.
void expect_white(const Appearance& appearance) {
    constexpr std::size_t samples = 16384;
    constexpr float tolerance = 5e-3F;
    for (const float cosine : cosines) {
        EXPECT_NEAR(albedo(flat(appearance), at_cosine(cosine), samples).y, 1.0F, tolerance)
            << "roughness " << appearance.roughness << ", cosine " << cosine;
    }
}

TEST(BsdfEnergy, AWhiteMetalReflectsAllLight) {
    for (const float roughness : roughnesses) {
        expect_white(metal(roughness));
    }
}

TEST(BsdfEnergy, AWhiteDielectricReflectsAllLight) {
    for (const float roughness : roughnesses) {
        for (const float ior : {1.0F, 1.5F, 2.5F}) {
            Appearance plastic = dielectric(roughness);
            plastic.ior = ior;
            expect_white(plastic);
        }
    }
}

TEST(BsdfEnergy, BetweenMetalAndDielectricNothingIsLost) {
    for (const float roughness : roughnesses) {
        Appearance both = dielectric(roughness);
        both.metallic = 0.3F;
        both.specular = 0.5F;
        expect_white(both);
    }
}

TEST(BsdfEnergy, NoMaterialGivesOffMoreThanItReceives) {
    Directions random(4);
    constexpr std::size_t samples = 1024;
    for (int trial = 0; trial < 2000; ++trial) {
        const NamedAppearance material = random.material();
        const V3f viewer = random.above({0.0F, 0.0F, 1.0F}, 0.01F);
        // The tables' half percent, and that of the mean of so few samples.
        EXPECT_LT(brightest(albedo(flat(material), viewer, samples)), 1.02F)
            << "metallic " << material.appearance.metallic << ", roughness "
            << material.appearance.roughness << ", cosine " << viewer.z;
    }
}

}  // namespace
}  // namespace balcony::render::test
