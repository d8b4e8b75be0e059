// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What a BSDF gives off of the light that it receives.

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "bsdf_support.hpp"

namespace balcony::render::test::bsdf_energy_test {
namespace {

constexpr float roughnesses[] = {0.0F, 0.02F, 0.032F, 0.05F, 0.08F, 0.1F, 0.15F, 0.2F, 0.3F,
                                 0.4F, 0.5F,  0.6F,   0.7F,  0.8F,  0.9F, 0.97F, 1.0F};
constexpr float cosines[] = {0.002F, 0.01F, 0.03F, 0.07F, 0.15F, 0.25F,
                             0.4F,   0.55F, 0.7F,  0.85F, 1.0F};

std::string describe(const NamedAppearance& material) {
    const Appearance& a = material.appearance;
    std::ostringstream text;
    text << "roughness " << a.roughness << ", metallic " << a.metallic << ", ior " << a.ior
         << ", transmission " << a.transmission << (a.thin_walled ? "" : " into a solid")
         << (material.entering ? "" : " from inside") << ", clearcoat " << a.clearcoat << " of "
         << a.clearcoat_roughness << ", sheen " << brightest(a.sheen_color) << " of "
         << a.sheen_roughness;
    return text.str();
}

// Between these are the tables' nodes.
constexpr float some_roughnesses[] = {0.0F, 0.04F, 0.13F, 0.35F, 0.62F, 1.0F};

// What is white and closed gives off all light that it receives, within half a percent.
void expect_white(const Appearance& appearance, bool entering = true) {
    constexpr std::size_t samples = 16384;
    constexpr float tolerance = 5e-3F;
    for (const float cosine : cosines) {
        EXPECT_NEAR(albedo(flat({"", appearance, entering}), at_cosine(cosine), samples).y, 1.0F,
                    tolerance)
            << describe({"", appearance, entering}) << ", cosine " << cosine;
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

TEST(BsdfEnergy, AWhiteWallLosesNoLight) {
    for (const float roughness : roughnesses) {
        expect_white(wall(roughness));
        Appearance frosted = wall(roughness);
        frosted.transmission = 0.4F;
        expect_white(frosted);
    }
}

TEST(BsdfEnergy, WhiteGlassLosesNoLight) {
    for (const float roughness : {0.0F, 0.2F, 0.3F, 0.62F, 1.0F}) {
        for (const float ior : {1.1F, 1.5F, 3.0F}) {
            expect_white(glass(roughness, ior), true);
            expect_white(glass(roughness, ior), false);
        }
    }
}

TEST(BsdfEnergy, AClearcoatAbsorbsNothing) {
    for (const float roughness : some_roughnesses) {
        for (const float coat : {0.0F, 0.15F, 0.5F, 1.0F}) {
            expect_white(coated(metal(roughness), coat));
            expect_white(coated(dielectric(roughness), coat));
            Appearance half = coated(metal(roughness), coat);
            half.clearcoat = 0.5F;
            half.metallic = 0.5F;
            expect_white(half);
            expect_white(coated(wall(roughness), coat));
        }
    }
}

// A white material whose clearcoat is tilted towards the viewer, or away from the viewer.
Bsdf under_tilted(const Appearance& below, float coat_roughness, float angle) {
    return flat(
        {"", coated(below, coat_roughness), true, {std::sin(angle), 0.0F, std::cos(angle)}});
}

TEST(BsdfEnergy, ATiltedClearcoatAddsNoLight) {
    constexpr std::size_t samples = 16384;
    for (const float roughness : {0.0F, 0.35F, 1.0F}) {
        for (const float coat : {0.0F, 0.5F}) {
            for (const Appearance& below : {metal(roughness), dielectric(roughness)}) {
                for (const float angle : {-0.9F, -0.3F, -0.1F, 0.1F, 0.3F, 0.9F}) {
                    const Bsdf bsdf = under_tilted(below, coat, angle);
                    for (const float cosine : {0.01F, 0.07F, 0.25F, 0.55F, 1.0F}) {
                        EXPECT_LT(albedo(bsdf, at_cosine(cosine), samples).y, 1.005F)
                            << describe({"", coated(below, coat)}) << ", tilted by " << angle
                            << ", cosine " << cosine;
                    }
                }
            }
        }
    }
}

// Schlick's reflectance changes by at most 4.8 per radian, so that a tilt takes at most the part
// 4.8 tilt / (1 - E) from what is below, for either direction. Above a cosine of 0.25, E is less
// than 0.32.
TEST(BsdfEnergy, ASmallTiltOfTheClearcoatChangesLittle) {
    constexpr std::size_t samples = 16384;
    constexpr float tilt = 1e-3F;
    constexpr float change = 2.0F * 4.8F / 0.68F * tilt;
    for (const float roughness : {0.0F, 0.35F, 1.0F}) {
        for (const float coat : {0.0F, 0.5F}) {
            const Appearance below = metal(roughness);
            for (const float cosine : {0.25F, 0.55F, 1.0F}) {
                const V3f viewer = at_cosine(cosine);
                const float straight = albedo(flat(coated(below, coat)), viewer, samples).y;
                for (const float angle : {-tilt, tilt}) {
                    EXPECT_NEAR(albedo(under_tilted(below, coat, angle), viewer, samples).y,
                                straight, change);
                }
            }
        }
    }
}

// What a white material loses where its clearcoat has a normal of its own: at most these parts.
TEST(BsdfEnergy, ATiltedClearcoatSeenStraightOnLosesLittle) {
    constexpr std::size_t samples = 16384;
    constexpr float degree = std::numbers::pi_v<float> / 180.0F;
    constexpr std::pair<float, float> losses[] = {{10.0F, 0.025F}, {30.0F, 0.115F}};
    for (const auto& [tilt, most] : losses) {
        for (const float coat : some_roughnesses) {
            for (const Appearance& below : {dielectric(0.0F), dielectric(0.35F), dielectric(1.0F),
                                            metal(0.35F), metal(1.0F)}) {
                const Bsdf bsdf = under_tilted(below, coat, tilt * degree);
                const float left = albedo(bsdf, at_cosine(1.0F), samples).y;
                EXPECT_GT(left, 1.0F - most)
                    << describe({"", coated(below, coat)}) << ", tilted by " << tilt;
            }
        }
    }
}

TEST(BsdfEnergy, SheenAbsorbsNothing) {
    for (const float roughness : some_roughnesses) {
        for (const float sheen : {0.0F, 0.3F, 0.5F, 1.0F}) {
            expect_white(fibrous(metal(roughness), sheen, Color3f(1.0F)));
            expect_white(fibrous(dielectric(roughness), sheen, Color3f(1.0F)));
        }
    }
}

TEST(BsdfEnergy, NoMaterialGivesOffMoreThanItReceives) {
    Directions random(4);
    constexpr std::size_t samples = 8192;
    for (int trial = 0; trial < 300; ++trial) {
        const NamedAppearance material = random.material();
        const V3f viewer = random.above({0.0F, 0.0F, 1.0F}, 0.01F);
        // The tables' half percent, and that of the mean of so few samples.
        EXPECT_LT(brightest(albedo(flat(material), viewer, samples)), 1.02F)
            << describe(material) << ", cosine " << viewer.z;
    }
}

}  // namespace
}  // namespace balcony::render::test::bsdf_energy_test
