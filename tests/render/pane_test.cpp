// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Light that reaches surfaces through panes, which are smooth thin walls, and through other glass.

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::render::test::pane_test {
namespace {

const Color3f tint(0.9F, 0.6F, 0.3F);

scene::Material pane() {
    scene::Material glass = white();
    glass.base_color = tint;
    glass.transmission = 1.0F;
    glass.roughness = 0.0F;
    return glass;
}

scene::Material glowing(float radiance) {
    scene::Material material = white();
    material.base_color = Color3f(0.0F);
    material.emission = Color3f(radiance);
    return material;
}

// A floor under so many panes, seen from below them.
scene::Scene under_panes(std::size_t count, const scene::Material& glass, float roughness = 1.0F) {
    scene::Scene scene;
    scene::Material floor = white();
    floor.base_color = Color3f(0.5F);
    floor.specular = roughness < 1.0F ? 1.0F : 0.0F;
    floor.roughness = roughness;
    add(scene, wall(0.0F, 20.0F), floor);
    for (std::size_t i = 0; i < count; ++i) {
        add(scene, wall(0.5F + 0.1F * static_cast<float>(i), 20.0F), glass);
    }
    return scene;
}

// Its middle is on no common edge of two triangles, which a shadow ray would count twice.
camera::Camera below_panes() { return orthographic(view_down_z(0.3, 0.1, 0.4)); }

// What one pane lets pass: 1 less Schlick's reflectance of an index of 1.5, times its colour.
Color3f passed(double cosine) {
    const double reflected = 0.04 + 0.96 * std::pow(1.0 - cosine, 5.0);
    return static_cast<float>(1.0 - reflected) * tint;
}

// The only pixel, lit by a sun at an angle.
Color3f lit_by_sun(std::size_t panes, const scene::Material& glass, double angle,
                   const std::string& integrator) {
    scene::Scene scene = under_panes(panes, glass);
    scene::Light sun;
    sun.kind = scene::LightKind::directional;
    sun.angle = 0.0F;
    sun.direction = V3d(-std::sin(angle), 0.0, -std::cos(angle));
    scene.lights = {sun};
    Request asked = request(1, 1, integrator, 1);
    asked.path.bounces = {0, 0, 0, 0};
    asked.light.sky_beside_suns = false;
    const Color4f pixel = render(scene, below_panes(), asked).film.pixel(0, 0);
    return {pixel.r, pixel.g, pixel.b};
}

TEST(Pane, ASunShinesThroughPanesAtAllAngles) {
    for (const std::string integrator : {"direct", "path"}) {
        for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
            const double angle = degrees * std::numbers::pi / 180.0;
            const Color3f open = lit_by_sun(0, pane(), angle, integrator);
            Color3f expected = open;
            for (std::size_t panes = 1; panes <= 4; ++panes) {
                expected *= passed(std::cos(angle));
                const Color3f found = lit_by_sun(panes, pane(), angle, integrator);
                for (int channel = 0; channel < 3; ++channel) {
                    // A few rounding errors of floats for each pane.
                    EXPECT_NEAR(found[channel], expected[channel], 2e-5F * open[channel])
                        << integrator << ' ' << degrees << ' ' << panes;
                }
            }
        }
    }
}

TEST(Pane, RoughAndSolidGlassBlockShadowRays) {
    scene::Material frosted = pane();
    frosted.roughness = 0.3F;
    scene::Material solid = pane();
    solid.thin_walled = false;
    scene::Material unlit = pane();
    unlit.unlit = true;
    for (const scene::Material& glass : {frosted, solid, unlit}) {
        EXPECT_EQ(lit_by_sun(1, glass, 0.0, "path"), Color3f(0.0F));
    }
}

TEST(Pane, OpacityAndGlassAddUp) {
    scene::Material torn = pane();
    torn.alpha_mode = scene::AlphaMode::blend;
    torn.alpha = 0.25F;
    const Color3f open = lit_by_sun(0, torn, 0.0, "path");
    const Color3f found = lit_by_sun(1, torn, 0.0, "path");
    const Color3f expected = open * (Color3f(0.75F) + 0.25F * passed(1.0));
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(found[channel], expected[channel], 2e-5F * open[channel]);
    }
}

// The mean of the green channel, and its standard error from the spread of the pixels, between
// which nothing is shared.
struct Mean {
    double value = 0.0;
    double error = 0.0;
};

Mean mean_of(const scene::Scene& scene, Request asked) {
    asked.path.reuse = false;
    const Film film = render(scene, below_panes(), asked).film;
    const auto count = static_cast<double>(film.sum.size());
    double sum = 0.0;
    double squares = 0.0;
    for (const Color4d& pixel : film.sum) {
        sum += pixel.g;
        squares += pixel.g * pixel.g;
    }
    const double mean = sum / count;
    return {mean, std::sqrt((squares / count - mean * mean) / (count - 1.0))};
}

void expect_one_light(const scene::Scene& scene, const Request& asked, const std::string& what) {
    const auto found = [&](LampSampling sampling) {
        Request with = asked;
        with.path.lamp_sampling = sampling;
        return mean_of(scene, with);
    };
    const Mean lamps = found(LampSampling::lamps);
    for (const LampSampling sampling : {LampSampling::both, LampSampling::surfaces}) {
        const Mean other = found(sampling);
        const double error = std::hypot(lamps.error, other.error);
        EXPECT_GT(lamps.value, 0.0) << what;
        EXPECT_LT(error, 0.02 * lamps.value) << what;
        EXPECT_NEAR(other.value, lamps.value, 4.0 * error)
            << what << ' ' << static_cast<int>(sampling);
    }
}

// The floor sees the panes and what is above them; paths have up to so many bounces. At the last
// bounce from a glossy floor, surfaces and lamps share the light as at the others.
TEST(Pane, SamplingLampsOrSurfacesOrBothFindsTheSameLight) {
    for (const std::size_t bounces : {0U, 3U}) {
        for (const std::size_t panes : {1U, 3U}) {
            scene::Scene scene = under_panes(panes, pane(), bounces == 0 ? 0.25F : 1.0F);
            add(scene, parallelogram({-1.0F, 1.0F, 1.5F}, {2.0F, 0.0F, 0.0F}, {0.0F, -2.0F, 0.0F}),
                glowing(1.0F));
            Request asked = request(64, 64, "path", 64);
            asked.path.bounces = {bounces, bounces, bounces, bounces};
            expect_one_light(scene, asked,
                             std::to_string(panes) + " panes, bounces " + std::to_string(bounces));
        }
    }
}

TEST(Pane, ASkyThroughPanesIsTheSameByAllMethods) {
    scene::Scene scene = under_panes(2, pane());
    Request asked = request(32, 32, "path", 64);
    asked.path.bounces = {4, 4, 4, 4};
    asked.light.environment = Environment::constant(Color3f(1.0F));
    expect_one_light(scene, asked, "sky");
}

// A pane inside of a coloured solid: the way before it is not absorbed twice.
TEST(Pane, APaneInASolidAbsorbsNothing) {
    const auto seen = [](bool with_pane) {
        scene::Scene scene;
        add(scene, wall(-1.0F, 20.0F), glowing(1.0F));
        scene::Material solid = white();
        solid.transmission = 1.0F;
        solid.roughness = 0.0F;
        solid.ior = 1.0F;
        solid.specular = 0.0F;
        solid.thin_walled = false;
        solid.absorption = Color3f(0.0F, 1.0F, 1.0F);
        add(scene, wall(0.4F, 20.0F), solid);
        add(scene, parallelogram({-20.0F, 20.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, -40.0F, 0.0F}),
            solid);
        if (with_pane) {
            scene::Material clear = solid;
            clear.thin_walled = true;
            clear.absorption = Color3f(0.0F);
            add(scene, wall(0.1F, 20.0F), clear);
        }
        return render(scene, orthographic(view_down_z(0.3, 0.1, 1.0)), request(1, 1, "path", 16))
            .film.pixel(0, 0)
            .g;
    };
    EXPECT_NEAR(seen(false), std::exp(-0.4F), 1e-4F);
    EXPECT_NEAR(seen(true), std::exp(-0.4F), 1e-4F);
}

scene::Material solid() {
    scene::Material glass = pane();
    glass.thin_walled = false;
    glass.absorption = Color3f(0.2F, 0.4F, 0.6F);
    return glass;
}

// A slab of glass over a floor.
scene::Scene under_a_slab() {
    scene::Scene scene = under_panes(0, pane());
    add(scene, wall(0.6F, 20.0F), solid());
    add(scene, parallelogram({-20.0F, 20.0F, 0.5F}, {40.0F, 0.0F, 0.0F}, {0.0F, -40.0F, 0.0F}),
        solid());
    return scene;
}

void add_ceiling_lamp(scene::Scene& scene) {
    add(scene, parallelogram({-1.0F, 1.0F, 1.5F}, {2.0F, 0.0F, 0.0F}, {0.0F, -2.0F, 0.0F}),
        glowing(1.0F));
}

// A lamp in a hollow globe of glass over a floor; 1 is its size.
scene::Scene with_globe(float size) {
    scene::Scene scene = under_panes(0, pane());
    const scene::M44d placed = scene::M44d().setTranslation(V3d(0.1, 0.0, 0.9));
    add(scene, coarse_sphere(0.25F * size, 16, 8), glowing(1.0F / size), placed);
    add(scene, coarse_sphere(0.4F * size, 32, 16), solid(), placed);
    add(scene, coarse_sphere(-0.35F * size, 32, 16), solid(), placed);
    return scene;
}

TEST(GuidedPath, AllMethodsFindTheSameLightBehindGlass) {
    scene::Material frosted = pane();
    frosted.roughness = 0.3F;
    scene::Scene slab = under_a_slab();
    add_ceiling_lamp(slab);
    // A screen behind frosted glass hides a part of the lamp.
    scene::Scene screen = under_panes(2, frosted);
    add_ceiling_lamp(screen);
    add(screen, parallelogram({-1.0F, 1.0F, 1.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, -2.0F, 0.0F}),
        glowing(0.0F));
    // A pane comes before the glass.
    scene::Scene both = under_a_slab();
    add(both, wall(0.4F, 20.0F), pane());
    add_ceiling_lamp(both);
    // Limits of indirect light take most from the method with the most noise.
    Request asked = request(64, 64, "path", 64);
    asked.path.exact = true;
    expect_one_light(slab, asked, "slab");
    expect_one_light(screen, asked, "screen");
    expect_one_light(both, asked, "pane and slab");
    expect_one_light(with_globe(1.0F), asked, "globe");
}

TEST(GuidedPath, ASkyBehindGlassIsTheSameByAllMethods) {
    Request asked = request(32, 32, "path", 64);
    asked.light.environment = Environment::constant(Color3f(1.0F));
    expect_one_light(under_a_slab(), asked, "sky");
}

// A pane in front of the glass mirrors a lamp that stands beside the floor that is seen, and is
// dark below.
TEST(GuidedPath, WhatAPaneMirrorsIsFoundOnce) {
    scene::Scene scene = under_a_slab();
    add(scene, wall(0.4F, 20.0F), pane());
    for (const float radiance : {0.0F, 20.0F}) {
        add(scene,
            parallelogram({1.4F, -2.0F, radiance > 0.0F ? 0.05F : 0.04F}, {2.0F, 0.0F, 0.0F},
                          {0.0F, 4.0F, 0.0F}),
            glowing(radiance));
    }
    Request asked = request(64, 64, "path", 128);
    asked.light.environment = Environment::constant(Color3f(1.0F));
    expect_one_light(scene, asked, "pane");
}

TEST(GuidedPath, ASmallLampInAGlobeMakesLittleNoise) {
    Request asked = request(64, 64, "path", 64);
    const scene::Scene scene = with_globe(0.1F);
    const Mean guided = mean_of(scene, asked);
    asked.path.lamp_sampling = LampSampling::surfaces;
    EXPECT_GT(guided.value, 0.0);
    EXPECT_LT(guided.error, 0.1 * mean_of(scene, asked).error);
}

TEST(GuidedPath, APointLampIsFoundBehindSoftenedGlass) {
    scene::Scene scene = under_a_slab();
    scene::Light lamp;
    lamp.position = V3d(0.0, 0.0, 1.5);
    lamp.intensity = Color3f(10.0F);
    scene.lights.push_back(lamp);
    Request asked = request(32, 32, "path", 16);
    EXPECT_EQ(mean_of(scene, asked).value, 0.0);
    asked.path.exact = false;
    EXPECT_GT(mean_of(scene, asked).value, 0.01);
}

TEST(GuidedPath, TheOrderOfPathsDoesNotMatter) {
    scene::Scene scene = with_globe(0.5F);
    add(scene, parallelogram({-2.0F, 2.0F, 2.0F}, {4.0F, 0.0F, 0.0F}, {0.0F, -4.0F, 0.0F}),
        white());
    View view = view_down_z(0.0, 0.0, 1.8);
    Request asked = request(96, 48, "path", 4);
    asked.path.exact = false;
    const Film whole = render(scene, pinhole(view), asked).film;
    asked.layout.window = Region{21, 5, 50, 37};
    const Film part = render(scene, pinhole(view), asked).film;
    for (std::size_t y = 5; y < 42; ++y) {
        for (std::size_t x = 21; x < 71; ++x) {
            ASSERT_EQ(part.sum[part.index(x, y)], whole.sum[whole.index(x, y)]);
        }
    }
}

// Heads and tails of shared paths do not see each other through panes.
TEST(Pane, PathReuseKeepsTheMeanBesideAPane) {
    scene::Scene scene = under_panes(0, pane());
    add(scene, parallelogram({0.0F, -2.0F, 0.0F}, {0.0F, 4.0F, 0.0F}, {0.0F, 0.0F, 0.4F}), pane());
    // All light comes from a ceiling that is on one side of the pane and lit from below.
    add(scene, parallelogram({-1.0F, 1.0F, 0.5F}, {1.0F, 0.0F, 0.0F}, {0.0F, -2.0F, 0.0F}),
        white());
    scene::Light lamp;
    lamp.kind = scene::LightKind::spot;
    lamp.position = V3d(-0.5, 0.1, 0.02);
    lamp.direction = V3d(0.0, 0.0, 1.0);
    scene.lights = {lamp};
    // The pane is in the middle of each group of pixels, of which this side counts.
    View view = view_down_z(0.0, 0.1, 0.4);
    view.right *= 0.05;
    const auto mean = [&](bool reuse, std::uint32_t seed) {
        Request asked = request(4, 64, "path", 256);
        asked.path.reuse = reuse;
        asked.path.bounces = {3, 3, 3, 3};
        asked.sampling.seed = seed;
        const Film film = render(scene, orthographic(view), asked).film;
        double sum = 0.0;
        for (std::size_t y = 0; y < film.height; ++y) {
            sum += film.sum[film.index(0, y)].g + film.sum[film.index(1, y)].g;
        }
        return sum;
    };
    // Renders with other seeds are independent.
    const auto mean_and_error = [&](bool reuse) {
        constexpr std::uint32_t count = 12;
        double sum = 0.0;
        double squares = 0.0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const double one = mean(reuse, i + (reuse ? 100 : 0));
            sum += one / count;
            squares += one * one / count;
        }
        return Mean{sum, std::sqrt((squares - sum * sum) / (count - 1.0))};
    };
    const Mean with = mean_and_error(true);
    const Mean without = mean_and_error(false);
    const double error = std::hypot(with.error, without.error);
    EXPECT_LT(error, 0.01 * without.value);
    EXPECT_NEAR(with.value, without.value, 4.0 * error);
}

}  // namespace
}  // namespace balcony::render::test::pane_test
