// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The direct integrator against the formulas of its lights and materials.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "shading/materials/bsdf.hpp"
#include "support.hpp"

namespace balcony::render::test::light_test {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

// A float's relative rounding, times the few dozen roundings of a shading formula.
constexpr float rounding = 64.0F * 6e-8F;

scene::Material matt() { return white(); }

// What a grey matt surface reflects where light and viewer are straight on, by its BSDF, whose laws
// have tests of their own.
float straight_on(float grey) {
    const V3f up(0.0F, 0.0F, 1.0F);
    Appearance appearance;
    appearance.base_color = Color3f(grey);
    return Bsdf(appearance, up, up).evaluate(up, up).reflected.x;
}

const float matt_straight_on = straight_on(1.0F);

scene::Light lamp_at(double x, double y, double z, float candela = 1.0F) {
    scene::Light light;
    light.position = V3d(x, y, z);
    light.intensity = Color3f(candela);
    return light;
}

// The radiance of the wall z = 0 at a point, seen straight on.
float radiance_at(const scene::Scene& scene, double x, double y, Request asked) {
    View view = view_down_z(x, y, 0.5);
    view.right *= 1e-6;
    view.up *= 1e-6;
    return render(scene, orthographic(view), asked).film.pixel(0, 0).g;
}

float radiance_at(const scene::Scene& scene, double x, double y) {
    return radiance_at(scene, x, y, request(1, 1, "direct"));
}

TEST(Light, FallsWithTheSquareOfTheDistance) {
    scene::Scene scene;
    add(scene, wall(0.0F, 10.0F), matt());
    for (const float distance : {1.0F, 2.0F, 5.0F}) {
        scene.lights = {lamp_at(0.0, 0.0, static_cast<double>(distance), 3.0F)};
        const float expected = 3.0F * matt_straight_on / (distance * distance);
        EXPECT_NEAR(radiance_at(scene, 0.0, 0.0), expected, expected * rounding);
    }
}

TEST(Light, CandelaCountByTheMetre) {
    scene::Scene scene;
    add(scene, wall(0.0F, 10.0F), matt());
    scene.meters_per_unit = 0.1;
    scene.lights = {lamp_at(0.0, 0.0, 2.0)};
    const float expected = matt_straight_on / 0.04F;
    EXPECT_NEAR(radiance_at(scene, 0.0, 0.0), expected, expected * rounding);
}

TEST(Light, SunHasItsIlluminanceEverywhere) {
    scene::Scene scene;
    add(scene, wall(0.0F, 10.0F), matt());
    scene::Light sun;
    sun.kind = scene::LightKind::directional;
    sun.intensity = Color3f(7.0F);
    scene.lights = {sun};
    for (const double x : {-8.0, 0.0, 5.0}) {
        EXPECT_NEAR(radiance_at(scene, x, 1.0), 7.0F * matt_straight_on, 7.0F * rounding);
    }
}

TEST(Light, RangeEndsALight) {
    scene::Scene scene;
    add(scene, wall(0.0F, 10.0F), matt());
    scene.lights = {lamp_at(0.0, 0.0, 2.0)};
    scene.lights[0].range = 4.0F;
    const float window = 1.0F - 1.0F / 16.0F;
    EXPECT_NEAR(radiance_at(scene, 0.0, 0.0), window * matt_straight_on / 4.0F, rounding);
    scene.lights[0].range = 1.9F;
    EXPECT_EQ(radiance_at(scene, 0.0, 0.0), 0.0F);
}

TEST(Light, SpotShinesInItsCone) {
    scene::Scene scene;
    add(scene, wall(0.0F, 10.0F), matt());
    scene.lights = {lamp_at(0.0, 0.0, 1.0)};
    const float everywhere = radiance_at(scene, 0.5, 0.0);
    scene.lights[0].kind = scene::LightKind::spot;
    scene.lights[0].inner_cone = 0.5F;
    scene.lights[0].outer_cone = 0.8F;
    // Seen from the lamp, x lies atan(x) off the axis.
    EXPECT_NEAR(radiance_at(scene, 0.5, 0.0), everywhere, rounding);
    const float between = radiance_at(scene, std::tan(0.65), 0.0);
    EXPECT_GT(between, 0.0F);
    EXPECT_LT(between, everywhere);
    EXPECT_EQ(radiance_at(scene, std::tan(0.81), 0.0), 0.0F);
    scene.lights[0].direction = V3d(0.0, 0.0, 1.0);
    EXPECT_EQ(radiance_at(scene, 0.0, 0.0), 0.0F);
}

// The falloff is at least 0.001 of cosine wide, as in the extension's reference code.
TEST(Light, ASpotHasASoftEdge) {
    const auto share = [](double cosine) {
        scene::Scene scene;
        add(scene, wall(0.0F, 10.0F), matt());
        scene.lights = {lamp_at(0.0, 0.0, 1.0)};
        const double x = std::tan(std::acos(cosine));
        const float everywhere = radiance_at(scene, x, 0.0);
        scene.lights[0].kind = scene::LightKind::spot;
        scene.lights[0].inner_cone = scene.lights[0].outer_cone = 0.8F;
        return radiance_at(scene, x, 0.0) / everywhere;
    };
    const double edge = std::cos(static_cast<double>(0.8F));
    EXPECT_EQ(share(edge - 1e-5), 0.0F);
    // Half of the width, squared: its derivative by the cosine is 1,000, and a place in floats has
    // an error of 1e-7.
    EXPECT_NEAR(share(edge + 0.0005), 0.25F, 2e-4F);
    EXPECT_NEAR(share(edge + 0.0011), 1.0F, rounding);
}

// A plate from x = 0 at half the lamp's height throws its edge's shadow to x = 0 - the lamp's x.
TEST(Light, ShadowOfAPlateEndsWhereTheLineThroughItsEdgeEnds) {
    scene::Scene scene;
    add(scene, wall(0.0F, 10.0F), matt());
    add(scene, parallelogram({0.0F, -5.0F, 1.0F}, {5.0F, 0.0F, 0.0F}, {0.0F, 10.0F, 0.0F}), matt());
    scene.lights = {lamp_at(-0.5, 0.0, 2.0)};
    constexpr double edge = 0.5;
    constexpr double close = 1e-4;
    EXPECT_GT(radiance_at(scene, edge - close, 0.0), 0.0F);
    EXPECT_EQ(radiance_at(scene, edge + close, 0.0), 0.0F);
}

TEST(Light, ObjectsBehindTheLampOrTheWallCastNoShadow) {
    scene::Scene scene;
    add(scene, wall(0.0F, 10.0F), matt());
    scene.lights = {lamp_at(0.0, 0.0, 2.0)};
    const float alone = radiance_at(scene, 0.0, 0.0);
    add(scene, wall(2.001F, 10.0F), matt());
    add(scene, wall(-0.001F, 10.0F), matt());
    EXPECT_EQ(radiance_at(scene, 0.0, 0.0), alone);
    scene.lights[0].position.z = -2.0;
    EXPECT_EQ(radiance_at(scene, 0.0, 0.0), 0.0F);
}

// Far from the origin floats are coarse; a surface must not shadow itself there either.
TEST(Light, NoSurfaceShadowsItself) {
    for (const double away : {0.0, 1e3, 1e6}) {
        scene::Scene scene;
        scene::M44d placed;
        placed.rotate(V3d(0.4, 0.3, 0.2));
        placed[3][0] = away;
        placed[3][1] = -away;
        add(scene, wall(0.0F, 10.0F), matt(), placed);
        scene::Light sun;
        sun.kind = scene::LightKind::directional;
        sun.direction = V3d(-0.6, 0.0, -0.8);
        scene.lights = {sun};
        View view = view_down_z(away, -away, 5.0);
        const Rendered picture = render(scene, orthographic(view), request(50, 50, "direct"));
        float minimum = 1.0F;
        for (std::size_t i = 0; i < 50 * 50; ++i) {
            minimum = std::min(minimum, picture.film.pixel(i % 50, i / 50).g);
        }
        EXPECT_GT(minimum, 0.5F / pi * 0.9F) << away;
    }
}

TEST(Light, TransparentSurfacesLetLightThrough) {
    scene::Scene scene;
    add(scene, wall(0.0F, 10.0F), matt());
    scene.lights = {lamp_at(0.0, 0.0, 2.0)};
    constexpr double x = 0.5;  // Off the walls' diagonals, where a ray meets two triangles.
    const float alone = radiance_at(scene, x, 0.0);
    scene::Material glass = matt();
    glass.alpha_mode = scene::AlphaMode::blend;
    glass.alpha = 0.25F;
    add(scene, wall(1.0F, 10.0F), glass);
    add(scene, wall(1.5F, 10.0F), glass);
    EXPECT_NEAR(radiance_at(scene, x, 0.0), alone * 0.75F * 0.75F, rounding);
    scene.materials[1].alpha_mode = scene::AlphaMode::mask;
    scene.materials[1].alpha_cutoff = 0.5F;
    EXPECT_NEAR(radiance_at(scene, x, 0.0), alone * 0.75F, rounding);
    scene.materials[1].alpha_cutoff = 0.2F;
    EXPECT_EQ(radiance_at(scene, x, 0.0), 0.0F);
}

TEST(Light, BlendedSurfacesAreSeenThrough) {
    scene::Scene scene;
    scene::Material glow = matt();
    glow.emission = Color3f(2.0F);
    add(scene, wall(0.0F, 10.0F), glow);
    scene::Material film = matt();
    film.emission = Color3f(1.0F);
    film.alpha_mode = scene::AlphaMode::blend;
    film.alpha = 0.25F;
    add(scene, wall(0.2F, 10.0F), film);
    EXPECT_NEAR(radiance_at(scene, 0.0, 0.0), 0.25F + 0.75F * 2.0F, rounding);
    scene.instances.erase(scene.instances.begin());
    const Rendered picture =
        render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)), request(1, 1, "direct"));
    EXPECT_NEAR(picture.film.pixel(0, 0).a, 0.25F, rounding);
    EXPECT_EQ(picture.film.layers->object[0], 2U);
}

TEST(Light, AmbientLightAndDefaultLight) {
    scene::Scene scene;
    scene::Material grey = matt();
    grey.base_color = Color3f(0.5F);
    add(scene, wall(0.0F, 10.0F), grey);
    Request asked = request(1, 1, "direct");
    asked.ambient = Color3f(0.3F);
    EXPECT_NEAR(radiance_at(scene, 0.0, 0.0, asked), 0.15F, rounding);
    scene.default_light = true;
    EXPECT_NEAR(radiance_at(scene, 0.0, 0.0), pi * straight_on(0.5F), rounding);
}

// A mirror in the plane z = -x turns rays along -z to -x... the glowing wall stands there.
TEST(Light, AMirrorShowsTheHitOfTheReflectedRay) {
    scene::Scene scene;
    scene::Material mirror;
    mirror.base_color = Color3f(0.8F, 0.6F, 0.4F);
    mirror.metallic = 1.0F;
    mirror.roughness = 0.0F;
    add(scene, parallelogram({-2.0F, -2.0F, 2.0F}, {4.0F, 0.0F, -4.0F}, {0.0F, 4.0F, 0.0F}),
        mirror);
    scene::Material glow;
    glow.emission = Color3f(1.0F);
    // Its upper half only, at x = 5.
    add(scene, parallelogram({5.0F, 0.0F, 10.0F}, {0.0F, 0.0F, -20.0F}, {0.0F, 20.0F, 0.0F}), glow);
    Request asked = request(2, 2, "direct");
    asked.background = Color3f(0.25F);
    const Rendered picture = render(scene, orthographic(view_down_z(0.0, 0.0, 4.0)), asked);
    // Schlick at 45 degrees, by colour.
    const float tilt = std::pow(1.0F - std::sqrt(0.5F), 5.0F);
    const auto reflectance = [tilt](float r) { return r + (1.0F - r) * tilt; };
    for (std::size_t x = 0; x < 2; ++x) {
        EXPECT_NEAR(picture.film.pixel(x, 0).r, reflectance(0.8F), rounding);
        EXPECT_NEAR(picture.film.pixel(x, 0).b, reflectance(0.4F), rounding);
        EXPECT_NEAR(picture.film.pixel(x, 1).g, 0.25F * reflectance(0.6F), rounding);
        EXPECT_EQ(picture.film.layers->object[x], 1U);
    }
}

// A mirror that reflects nothing but what is behind the scene: its background, or the ambient
// light.
TEST(Light, AMirrorReflectsTheBackgroundOrTheSky) {
    scene::Scene scene;
    scene::Material mirror = white();
    mirror.base_color = Color3f(0.8F, 0.6F, 0.4F);
    mirror.metallic = 1.0F;
    mirror.roughness = 0.0F;
    add(scene, wall(0.0F, 10.0F), mirror);
    Request asked = request(1, 1, "direct");
    asked.ambient = Color3f(30.0F);
    const camera::Camera camera = orthographic(view_down_z(0.0, 0.0, 1.0));
    Film film = render(scene, camera, asked).film;
    EXPECT_NEAR(film.light(0, 0).g, 0.6F * 30.0F, 18.0F * rounding);
    EXPECT_EQ(film.display_color(0, 0), Color4f(0.0F));
    EXPECT_EQ(film.surface_light(0, 0), Color4f(0.0F, 0.0F, 0.0F, 1.0F));
    asked.background = Color3f(0.5F);
    film = render(scene, camera, asked).film;
    EXPECT_NEAR(film.display_color(0, 0).g, 0.6F * 0.5F, rounding);
    EXPECT_EQ(film.light(0, 0), Color4f(0.0F, 0.0F, 0.0F, 1.0F));
}

// A tenth of what a white surface turned to the lamp shows, wherever the camera sees it lit.
TEST(Light, AmbientLightFollowsTheLamps) {
    scene::Scene scene;
    add(scene, wall(0.0F, 10.0F), matt());
    scene::Light sun;
    sun.kind = scene::LightKind::directional;
    sun.direction = V3d(-0.6, 0.0, -0.8);
    sun.intensity = Color3f(1000.0F);
    scene.lights = {sun};
    Request asked = request(40, 30, "direct");
    asked.ambient.reset();
    const camera::Camera camera = orthographic(view_down_z(0.0, 0.0, 5.0));
    const auto ambient = [&] { return render(scene, camera, asked).summary.ambient.x; };
    const float whole = 0.1F * 1000.0F / pi;
    EXPECT_NEAR(ambient(), whole, whole * rounding);
    // Shadow over less than half of the picture does not count, nor does darkness.
    add(scene, parallelogram({-1.0F, -1.0F, 0.5F}, {0.6F, 0.0F, 0.0F}, {0.0F, 2.0F, 0.0F}), matt());
    EXPECT_NEAR(ambient(), whole, whole * rounding);
    scene.lights[0].direction.z = 0.8;
    EXPECT_EQ(ambient(), 0.3F);
    // It depends on the picture, not on its window.
    scene.lights[0].direction.z = -0.8;
    asked.layout.window = Region{3, 4, 5, 6};
    EXPECT_NEAR(ambient(), whole, whole * rounding);
    scene.lights.clear();
    scene.default_light = true;
    EXPECT_NEAR(ambient(), 0.1F, rounding);
    scene.default_light = false;
    scene.materials[0].emission = Color3f(50.0F);
    EXPECT_NEAR(ambient(), 5.0F, 5.0F * rounding);
}

TEST(Light, MirrorsFacingEachOtherEnd) {
    scene::Scene scene;
    scene::Material mirror = white();
    mirror.metallic = 1.0F;
    mirror.roughness = 0.0F;
    mirror.emission = Color3f(1.0F);
    add(scene, wall(0.0F, 10.0F), mirror);
    add(scene, wall(1.0F, 10.0F), mirror);
    Request asked = request(1, 1, "direct");
    asked.direct.mirror_depth = 5;
    EXPECT_NEAR(radiance_at(scene, 0.0, 0.0, asked), 6.0F, 6.0F * rounding);
    asked.direct.mirror_depth = 0;
    EXPECT_NEAR(radiance_at(scene, 0.0, 0.0, asked), 1.0F, rounding);
}

}  // namespace
}  // namespace balcony::render::test::light_test
