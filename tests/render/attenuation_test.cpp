// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What becomes of light on its way to the camera: mattes of veils, emission below a clearcoat,
// light inside a solid.

#include <array>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::render::test::attenuation_test {
namespace {

constexpr std::array integrators{"preview", "direct", "path"};

scene::Material glowing(float radiance) {
    scene::Material material = white();
    material.base_color = Color3f(0.0F);
    material.emission = Color3f(radiance);
    return material;
}

scene::Material veil(float opacity) {
    scene::Material material = white();
    material.alpha_mode = scene::AlphaMode::blend;
    material.alpha = opacity;
    return material;
}

// Shares by id of the only pixel.
std::map<std::uint32_t, float> shares(const std::vector<Matte>& mattes, std::size_t samples) {
    std::map<std::uint32_t, float> found;
    for (const Matte::Entry& entry : mattes[0].entries) {
        if (entry.id != 0) {
            found[entry.id] += entry.coverage / static_cast<float>(samples);
        }
    }
    return found;
}

TEST(Attenuation, AMatteIsSharedByAllThatIsSeenThroughVeils) {
    scene::Scene scene;
    add(scene, wall(0.0F, 10.0F), white());
    add(scene, wall(0.1F, 10.0F), veil(0.25F));
    add(scene, wall(0.2F, 10.0F), veil(0.5F));
    constexpr std::size_t samples = 4096;
    // Five standard errors of a share of 1/2 in independent samples.
    const double of_samples = 5.0 * std::sqrt(0.25 / samples);
    for (const std::string integrator : integrators) {
        Request asked = request(1, 1, integrator, samples);
        asked.layout.layers.insert(LayerId::crypto_object);
        asked.layout.layers.insert(LayerId::crypto_material);
        const Film film = render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)), asked).film;
        const double tolerance = integrator == "path" ? of_samples : 1e-5;
        for (const auto* mattes : {&film.means.objects, &film.means.materials}) {
            const auto found = shares(*mattes, samples);
            ASSERT_EQ(found.size(), 3U) << integrator;
            EXPECT_NEAR(found.at(3), 0.5, tolerance) << integrator;
            EXPECT_NEAR(found.at(2), 0.5 * 0.25, tolerance) << integrator;
            EXPECT_NEAR(found.at(1), 0.5 * 0.75, tolerance) << integrator;
        }
    }
}

TEST(Attenuation, GlassHasTheWholeMatte) {
    scene::Scene scene;
    add(scene, wall(0.0F, 10.0F), white());
    scene::Material glass = white();
    glass.transmission = 1.0F;
    glass.roughness = 0.0F;
    const std::uint32_t pane = add(scene, wall(0.1F, 10.0F), glass);
    for (const std::string integrator : integrators) {
        Request asked = request(1, 1, integrator, 16);
        asked.layout.layers.insert(LayerId::crypto_object);
        const Film film = render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)), asked).film;
        EXPECT_EQ(shares(film.means.objects, 16), (std::map{std::pair(pane, 1.0F)})) << integrator;
    }
}

// Thin glass passes what it does not reflect, 0.04, in its colour. Frosted glass is clear here.
TEST(Attenuation, DirectShowsWhatIsBehindThinGlass) {
    for (const float roughness : {0.0F, 0.05F, 0.5F}) {
        scene::Scene scene;
        add(scene, wall(0.0F, 10.0F), glowing(1.0F));
        scene::Material glass = white();
        glass.base_color = Color3f(0.5F, 0.7F, 0.9F);
        glass.transmission = 1.0F;
        glass.roughness = roughness;
        add(scene, wall(0.1F, 10.0F), glass);
        add(scene, wall(0.2F, 10.0F), glass);
        Request asked = request(1, 1, "direct", 1);
        const Color4f seen =
            render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)), asked).film.pixel(0, 0);
        EXPECT_NEAR(seen.r, 0.96 * 0.96 * 0.5 * 0.5, 1e-5) << roughness;
        EXPECT_NEAR(seen.g, 0.96 * 0.96 * 0.7 * 0.7, 1e-5) << roughness;
        EXPECT_NEAR(seen.b, 0.96 * 0.96 * 0.9 * 0.9, 1e-5) << roughness;
        EXPECT_EQ(seen.a, 1.0F) << roughness;
    }
}

// KHR_materials_clearcoat: emission * (1 - clearcoat * Fresnel).
TEST(Attenuation, AClearcoatAttenuatesTheEmissionBelowIt) {
    const auto expected = [](double clearcoat, double cosine) {
        return 1.0 - clearcoat * (0.04 + 0.96 * std::pow(1.0 - cosine, 5.0));
    };
    for (const std::string integrator : integrators) {
        for (const double degrees : {0.0, 60.0, 80.0}) {
            for (const float clearcoat : {1.0F, 0.5F}) {
                const double angle = degrees * 3.14159265358979 / 180.0;
                scene::Scene scene;
                scene::Material lamp = glowing(1.0F);
                lamp.clearcoat = clearcoat;
                lamp.specular = 0.0F;
                add(scene, wall(0.0F, 100.0F), lamp);
                View view;
                view.eye = V3d(std::sin(angle), 0.0, std::cos(angle));
                view.forward = -view.eye;
                view.right = V3d(0.0, 1e-3, 0.0);
                view.up = V3d(-1e-3 * std::cos(angle), 0.0, 1e-3 * std::sin(angle));
                const Film film =
                    render(scene, orthographic(view), request(1, 1, integrator, 1)).film;
                EXPECT_NEAR(static_cast<double>(film.pixel(0, 0).g),
                            expected(static_cast<double>(clearcoat), std::cos(angle)), 1e-5)
                    << integrator << ' ' << degrees;
            }
        }
    }
}

// Sampling the lamp, or the surface that it lights, finds the same light.
TEST(Attenuation, ACoatedLampLightsAsItIsSeen) {
    scene::Scene scene;
    add(scene, wall(0.0F, 10.0F), white());
    scene::Material lamp = glowing(1.0F);
    lamp.clearcoat = 1.0F;
    lamp.specular = 0.0F;
    add(scene, parallelogram({2.0F, -1.0F, 0.0F}, {0.0F, 2.0F, 0.0F}, {0.0F, 0.0F, 0.5F}), lamp);
    const auto found = [&](LampSampling sampling) {
        Request asked = request(16, 16, "path", 256);
        asked.path.lamp_sampling = sampling;
        asked.path.bounces.all = 1;
        const Film film = render(scene, orthographic(view_down_z(0.0, 0.0, 3.0)), asked).film;
        double sum = 0.0;
        for (const Color4d& one : film.sum) {
            sum += one.g;
        }
        return sum;
    };
    const double by_lamps = found(LampSampling::lamps);
    // 65,536 directions, a hundredth of which find the lamp: a standard error of four percent at
    // most; without the coat it would be a fifth more.
    EXPECT_NEAR(found(LampSampling::surfaces) / by_lamps, 1.0, 0.12);
}

// A pane whose far faces make the offset of rays large: 8 rounding errors of 400.
TEST(Attenuation, AbsorptionCountsTheWholeWayInAWidePane) {
    scene::Scene scene;
    add(scene, wall(-1.0F, 200.0F), glowing(1.0F));
    scene::Material glass = white();
    glass.transmission = 1.0F;
    glass.roughness = 0.0F;
    glass.ior = 1.0F;
    glass.specular = 0.0F;
    glass.thin_walled = false;
    glass.absorption = Color3f(0.0F, 2.0F, 2.0F);  // Red ends no path.
    constexpr float thickness = 0.3F;
    add(scene, wall(thickness, 200.0F), glass);
    add(scene, parallelogram({-200.0F, 200.0F, 0.0F}, {400.0F, 0.0F, 0.0F}, {0.0F, -400.0F, 0.0F}),
        glass);
    const Film film =
        render(scene, orthographic(view_down_z(0.3, 0.1, 1.0)), request(1, 1, "path", 64)).film;
    // 4.1e-4 of length would be 8e-4 of the light.
    EXPECT_NEAR(film.pixel(0, 0).g, std::exp(-2.0F * thickness), 1e-4F);
}

}  // namespace
}  // namespace balcony::render::test::attenuation_test
