// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What a BSDF gives off of the light that it receives.

#include <sstream>
#include <string>

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
    // Two places that the nodes of the tables do not resolve: half a degree above the horizon under
    // a cover, where one percent is missing, and the edge of total reflection inside a solid, where
    // 0.7 % are.
    const bool is_covered = appearance.clearcoat > 0.0F || brightest(appearance.sheen_color) > 0.0F;
    for (const float cosine : cosines) {
        const float within = is_covered && cosine < 0.01F ? 1e-2F : entering ? tolerance : 7e-3F;
        EXPECT_NEAR(albedo(flat({"", appearance, entering}), at_cosine(cosine), samples).y, 1.0F,
                    within)
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
    for (const float roughness : {0.0F, 0.3F, 0.62F, 1.0F}) {
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
