// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The laws of a BSDF.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "bsdf_support.hpp"
#include "shading/geometry/frame.hpp"

namespace balcony::render::test::bsdf_test {
namespace {

const V3f up(0.0F, 0.0F, 1.0F);

// The clearcoat of a material and nothing below it.
NamedAppearance coat_alone(const NamedAppearance& material) {
    NamedAppearance made = material;
    made.appearance = dielectric(1.0F, Color3f(0.0F));
    made.appearance.specular = 0.0F;
    made.appearance.clearcoat = material.appearance.clearcoat;
    made.appearance.clearcoat_roughness = material.appearance.clearcoat_roughness;
    return made;
}

// Of the clearcoat, by the cosines with its own normal, and of all that is below it.
TEST(Bsdf, ReflectionIsReciprocal) {
    Directions random(1);
    for (const NamedAppearance& material : all_kinds()) {
        const bool tilted = material.entering && material.coat_normal != up;
        for (int trial = 0; trial < 1000; ++trial) {
            const V3f normal = random.on_sphere();
            const Bsdf bsdf = on_plane(material, normal);
            const V3f a = random.above(normal, 0.02F);
            const V3f b = random.above(normal, 0.02F);
            Color3f there = bsdf.evaluate(a, b).reflected / normal.dot(b);
            Color3f back = bsdf.evaluate(b, a).reflected / normal.dot(a);
            if (tilted) {
                const Bsdf coat = on_plane(coat_alone(material), normal);
                const V3f coat_normal = Frame(normal).to_world(material.coat_normal);
                const float coat_there = coat.evaluate(a, b).reflected.x;
                const float coat_back = coat.evaluate(b, a).reflected.x;
                there -= Color3f(coat_there / normal.dot(b));
                back -= Color3f(coat_back / normal.dot(a));
                EXPECT_NEAR(coat_there * coat_normal.dot(a), coat_back * coat_normal.dot(b),
                            1e-5F * std::max(coat_there, 1.0F));
            }
            // The peak of the distribution is 1 / roughness^4 times as sensitive to the rounding of
            // the half vector as a float is precise: 0.3^-4 is 123. Fresnel's fifth power and two
            // divisions by cosines of 0.02 add a few roundings.
            constexpr float rounding = 130.0F * 16.0F * 6e-8F;
            EXPECT_NEAR(there.x, back.x, rounding * std::max(there.x, 1.0F));
            EXPECT_NEAR(there.z, back.z, rounding * std::max(there.z, 1.0F));
        }
    }
}

// Of f(viewer, light) n(viewer)^2.
TEST(Bsdf, TransmissionIsReciprocal) {
    Directions random(9);
    for (int trial = 0; trial < 20000; ++trial) {
        NamedAppearance material = random.material();
        material.appearance.roughness = std::max(material.appearance.roughness, 0.3F);
        material.entering = true;
        const Bsdf bsdf = flat(material);
        material.entering = material.appearance.thin_walled;
        Bsdf back_side(material.appearance, -up, -up, material.entering);
        back_side.set_coat_normal(-material.coat_normal);
        const V3f a = random.above(up, 0.05F);
        const V3f b = -random.above(up, 0.05F);
        const float n = material.appearance.thin_walled ? 1.0F : material.appearance.ior;
        const Color3f there = bsdf.evaluate(a, b).reflected / -b.z;
        const Color3f back = back_side.evaluate(b, a).reflected * n * n / a.z;
        EXPECT_NEAR(there.x, back.x, 1e-3F * std::max(there.x, 0.1F)) << trial;
    }
}

// A material that is prepared once, with its own row of the table of energies, reflects as one that
// is made for the point.
TEST(Bsdf, APreparedMaterialReflectsTheSame) {
    Directions random(10);
    for (const NamedAppearance& material : all_kinds()) {
        BsdfMaterial prepared(material.appearance, material.entering);
        const auto row = prepared.energies.keep_row();
        Bsdf shared(prepared, up, up);
        shared.set_coat_normal(material.coat_normal);
        const Bsdf own = flat(material);
        for (int trial = 0; trial < 200; ++trial) {
            const V3f viewer = random.above(up, 0.05F);
            const V3f light = random.above(up, 0.05F);
            const Bsdf::Value expected = own.evaluate(viewer, light);
            const Bsdf::Value found = shared.evaluate(viewer, light);
            // The same two interpolations, in another order: each of about ten operations rounds.
            const float rounding = 1e-6F * std::max(expected.reflected.x, 1.0F);
            EXPECT_NEAR(found.reflected.x, expected.reflected.x, rounding) << material.name;
            EXPECT_NEAR(found.pdf, expected.pdf, 1e-6F * std::max(expected.pdf, 1.0F))
                << material.name;
        }
    }
}

// The normal of shading and that of the geometry disagree about light between their horizons.
TEST(Bsdf, NoLightLeaksBetweenTheHorizons) {
    Directions random(2);
    for (const NamedAppearance& material : all_kinds()) {
        for (int trial = 0; trial < 200; ++trial) {
            const V3f geometric = random.on_sphere();
            const V3f normal = random.above(geometric, 0.3F);
            Bsdf bsdf(material.appearance, normal, geometric, material.entering);
            const V3f coat_normal =
                material.coat_normal == up ? normal : random.above(geometric, 0.3F);
            bsdf.set_coat_normal(coat_normal);
            const V3f viewer = random.above(normal, 0.01F);
            if (const V3f light = random.above(normal, 0.0F); light.dot(geometric) < 0.0F) {
                EXPECT_EQ(bsdf.evaluate(viewer, light).reflected, Color3f(0.0F)) << material.name;
                if (coat_normal.dot(light) >= 0.0F) {
                    EXPECT_EQ(bsdf.evaluate(viewer, -light).reflected, Color3f(0.0F))
                        << material.name;
                }
            }
            const V3f below = -random.above(normal, 0.0F);
            if (!bsdf.material().transmits() && coat_normal.dot(below) <= 0.0F) {
                EXPECT_EQ(bsdf.evaluate(viewer, below).reflected, Color3f(0.0F)) << material.name;
            }
            const auto sample = bsdf.sample(viewer, random.numbers());
            if (sample && viewer.dot(geometric) > 0.0F) {
                const float side = sample->to_light.dot(geometric);
                EXPECT_TRUE(sample->transmitted ? side < 0.0F : side > 0.0F) << material.name;
            }
        }
    }
}

TEST(Bsdf, ATiltedClearcoatReflectsAboutItsOwnNormal) {
    const V3f tilted = V3f(0.6F, 0.0F, 0.8F);
    const NamedAppearance coat = coat_alone({"", coated(dielectric(1.0F), 0.2F), true, tilted});
    const V3f to_peak = mirrored(up, tilted);
    EXPECT_GT(flat(coat).evaluate(up, to_peak).reflected.x,
              100.0F * flat(coat.appearance).evaluate(up, to_peak).reflected.x);
    // Also of light that the layers below it, bent the other way, cannot receive.
    const V3f other_way(-0.6F, 0.0F, 0.8F);
    EXPECT_LT(to_peak.dot(other_way), 0.0F);
    Bsdf bent(coat.appearance, other_way, up);
    bent.set_coat_normal(tilted);
    EXPECT_EQ(bent.evaluate(up, to_peak).reflected, flat(coat).evaluate(up, to_peak).reflected);
    EXPECT_EQ(bent.lit_side(), up);
}

// Through a thin wall light goes as if reflected at the wall.
TEST(Bsdf, AThinWallTransmitsWithoutRefraction) {
    Directions random(5);
    const Bsdf smooth = flat(wall(0.0F, {0.5F, 0.7F, 0.9F}));
    const Bsdf rough = flat(wall(0.4F));
    for (int trial = 0; trial < 200; ++trial) {
        const V3f viewer = random.above(up, 0.05F);
        const auto sample = smooth.sample(viewer, {0.999F, 0.5F, 0.5F});
        ASSERT_TRUE(sample && sample->delta && sample->transmitted);
        EXPECT_EQ(sample->to_light, -viewer);
        EXPECT_EQ(sample->eta, 1.0F);
        EXPECT_EQ(sample->lobe, BsdfLobe::transmission);
        // Both ways share the facets, by Fresnel's reflectance, which is that of the half vector.
        const V3f light = random.above(up, 0.05F);
        const float edge = std::pow(1.0F - viewer.dot((viewer + light).normalized()), 5.0F);
        const float reflectance = 0.04F + 0.96F * edge;
        const float back = rough.evaluate(viewer, light).reflected.x;
        const float on = rough.evaluate(viewer, {light.x, light.y, -light.z}).reflected.x;
        EXPECT_NEAR(on * reflectance, back * (1.0F - reflectance), 1e-5F * std::max(on, 1.0F));
    }
}

TEST(Bsdf, SmoothGlassRefractsBySnellsLaw) {
    Directions random(6);
    constexpr float ior = 1.5F;
    for (const bool entering : {true, false}) {
        const Bsdf bsdf = flat({"", glass(0.0F, ior, {0.5F, 0.7F, 0.9F}), entering});
        EXPECT_TRUE(bsdf.material().transmits());
        const float eta = entering ? 1.0F / ior : ior;
        for (int trial = 0; trial < 500; ++trial) {
            const V3f viewer = random.above(up, 0.01F);
            const float sine = std::sqrt(1.0F - viewer.z * viewer.z);
            const auto sample = bsdf.sample(viewer, {0.999F, 0.5F, 0.5F});
            ASSERT_TRUE(sample && sample->delta);
            EXPECT_EQ(sample->pdf, 0.0F);
            if (eta * sine >= 1.0F) {  // Total reflection.
                EXPECT_FALSE(sample->transmitted);
                EXPECT_NEAR(sample->to_light.z, viewer.z, 1e-6F);
                EXPECT_NEAR(sample->weight.x, 1.0F, 1e-6F);
                continue;
            }
            ASSERT_TRUE(sample->transmitted);
            EXPECT_EQ(sample->lobe, BsdfLobe::transmission);
            EXPECT_EQ(sample->eta, eta);
            EXPECT_NEAR(sample->to_light.x, -eta * viewer.x, 1e-6F);
            EXPECT_NEAR(sample->to_light.y, -eta * viewer.y, 1e-6F);
            EXPECT_LT(sample->to_light.z, 0.0F);
            EXPECT_NEAR(sample->weight.x / sample->weight.z, 5.0F / 9.0F, 1e-5F);
        }
    }
}

TEST(Bsdf, GlassHasFresnelsReflectance) {
    const auto reflectance = [](float cosine) {
        return flat(glass(0.0F, 1.5F)).sample_mirror(at_cosine(cosine))->weight.x;
    };
    EXPECT_NEAR(reflectance(1.0F), 0.04F, 1e-6F);
    // Brewster's angle: no light polarised along the plane, and of the other the square of
    // (n² - 1) / (n² + 1).
    const float brewster = 1.0F / std::sqrt(1.0F + 1.5F * 1.5F);
    EXPECT_NEAR(reflectance(brewster), 0.5F * std::pow(1.25F / 3.25F, 2.0F), 1e-6F);
    EXPECT_NEAR(reflectance(1e-4F), 1.0F, 1e-3F);
}

// A facet that refracts obeys Snell's law as well.
TEST(Bsdf, RoughGlassRefractsAtItsFacets) {
    Directions random(8);
    int found = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const bool entering = trial % 2 == 0;
        const Bsdf bsdf = flat({"", glass(0.2F, 1.5F), entering});
        const V3f viewer = random.above(up, 0.1F);
        const auto sample = bsdf.sample(viewer, random.numbers());
        if (!sample || !sample->transmitted || sample->roughness == 1.0F) {
            continue;
        }
        ++found;
        EXPECT_EQ(sample->eta, entering ? 1.0F / 1.5F : 1.5F);
        const V3f there = sample->to_light.cross(sample->facet_normal);
        const V3f here = viewer.cross(sample->facet_normal);
        EXPECT_NEAR((there + sample->eta * here).length(), 0.0F, 1e-5F);
    }
    EXPECT_GT(found, 500);
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
        // Schlick's reflectance.
        const float edge = std::pow(1.0F - viewer.dot(normal), 5.0F);
        EXPECT_NEAR(sample->weight.x, 0.8F + 0.2F * edge, 1e-6F);
        EXPECT_NEAR(sample->weight.z, 0.4F + 0.6F * edge, 1e-6F);
        // A mirror of metal is chosen always.
        const auto chosen = bsdf.sample(viewer, {0.9F, 0.5F, 0.5F});
        ASSERT_TRUE(chosen && chosen->delta);
        EXPECT_EQ(chosen->to_light, sample->to_light);
        EXPECT_EQ(bsdf.evaluate(viewer, sample->to_light).reflected, Color3f(0.0F));
        EXPECT_EQ(bsdf.evaluate(viewer, sample->to_light).pdf, 0.0F);
    }
    EXPECT_FALSE(flat(metal(0.5F)).sample_mirror({0.0F, 0.0F, 1.0F}));
}

TEST(Bsdf, BlackSurfacesGiveOffNothing) {
    const V3f normal(0.0F, 0.0F, 1.0F);
    const Bsdf bsdf = flat(metal(0.5F, Color3f(0.0F)));
    EXPECT_FALSE(bsdf.sample(normal, {0.5F, 0.0F, 0.0F}));
    EXPECT_EQ(bsdf.evaluate(normal, normal).reflected, Color3f(0.0F));
}

}  // namespace
}  // namespace balcony::render::test::bsdf_test
