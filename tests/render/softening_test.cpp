// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Mirrors and glass are softened for light that surfaces have scattered.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "shading/materials/appearance.hpp"
#include "support.hpp"

namespace balcony::render::test::softening_test {
namespace {

scene::Material plaster() {
    scene::Material material = white();
    material.base_color = Color3f(0.7F);
    material.specular = 0.0F;
    return material;
}

scene::Material mirror() {
    scene::Material material = white();
    material.base_color = Color3f(0.95F);
    material.metallic = 1.0F;
    material.roughness = 0.0F;
    return material;
}

// A closed room of side 2 with a small bright lamp; one wall is a mirror.
scene::Scene room_with_mirror() {
    scene::Scene scene;
    const V3f x(2.0F, 0.0F, 0.0F);
    const V3f y(0.0F, 2.0F, 0.0F);
    const V3f z(0.0F, 0.0F, 2.0F);
    const V3f low(-1.0F);
    add(scene, parallelogram(low, x, z), plaster());
    add(scene, parallelogram(low + y, x, z), plaster());
    add(scene, parallelogram(low, x, y), plaster());
    add(scene, parallelogram(low + z, x, y), plaster());
    add(scene, parallelogram(low, y, z), plaster());
    add(scene, parallelogram(low + x, y, z), mirror());
    scene::Material lamp = white();
    lamp.base_color = Color3f(0.0F);
    lamp.emission = Color3f(400.0F);
    add(scene, parallelogram({0.2F, 0.8F, 0.5F}, {0.08F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.08F}), lamp);
    return scene;
}

struct Picture {
    std::vector<double> light;  // Of the pixels, in order.
    double mean = 0.0;
    double error = 0.0;  // The standard error of the mean; pixels count as independent.
    double softened = 0.0;

    [[nodiscard]] std::size_t specks() const {
        const double limit = 5.0 * light[light.size() / 2];
        return static_cast<std::size_t>(light.end() -
                                        std::upper_bound(light.begin(), light.end(), limit));
    }
};

Picture picture_of(const scene::Scene& scene, bool exact, std::size_t samples, bool reuse = false) {
    Request asked = request(32, 32, "path", samples);
    asked.path.exact = exact;
    asked.path.reuse = reuse;
    asked.layout.second_moment = true;
    // Away from the mirror and the lamp.
    const View view{{0.9, 0.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, -0.8}, {0.0, 0.8, 0.0}};
    const Rendered made = render(scene, pinhole(view), asked);
    Picture picture;
    double variance = 0.0;
    for (std::size_t y = 0; y < 32; ++y) {
        for (std::size_t x = 0; x < 32; ++x) {
            picture.light.push_back(double{made.film.surface_light(x, y).g});
            picture.mean += picture.light.back() / 1024.0;
            variance += made.film.variance(x, y).g / made.film.samples(x, y);
        }
    }
    std::sort(picture.light.begin(), picture.light.end());
    picture.error = std::sqrt(variance) / 1024.0;
    picture.softened = made.summary.layers.front().softened_share();
    return picture;
}

TEST(Softening, ALampInAMirrorMakesNoSpecks) {
    for (const bool reuse : {false, true}) {
        const Picture exact = picture_of(room_with_mirror(), true, 64, reuse);
        const Picture softened = picture_of(room_with_mirror(), false, 64, reuse);
        EXPECT_GT(exact.specks(), 2U);
        EXPECT_EQ(softened.specks(), 0U);
        EXPECT_LT(softened.error, 0.3 * exact.error);
    }
}

TEST(Softening, MovesLightAndTellsHowMuch) {
    const Picture exact = picture_of(room_with_mirror(), true, 1024);
    const Picture softened = picture_of(room_with_mirror(), false, 64);
    EXPECT_NEAR(softened.mean, exact.mean,
                4.0 * std::hypot(softened.error, exact.error) + 0.02 * exact.mean);
    EXPECT_GT(softened.softened, 0.1);
    EXPECT_LT(softened.softened, 0.9);
    EXPECT_EQ(exact.softened, 0.0);
}

// A spot of light that a lamp throws by way of a mirror onto a wall: the more samples, the sharper.
TEST(Softening, GoesToNothingAsSamplesGrow) {
    scene::Scene scene;
    add(scene, wall(0.0F, 20.0F), plaster());
    // Half of a mirror that faces the wall; the edge of its light is above x = 0.
    add(scene, parallelogram({-20.0F, 20.0F, 1.0F}, {20.0F, 0.0F, 0.0F}, {0.0F, -40.0F, 0.0F}),
        mirror());
    scene::Light lamp;
    lamp.kind = scene::LightKind::spot;
    lamp.position = V3d(0.0, 0.0, 0.01);
    lamp.direction = V3d(0.0, 0.0, 1.0);
    lamp.outer_cone = 1.5F;
    scene.lights = {lamp};
    // What arrives beyond the edge, over what arrives before it.
    const auto beyond = [&](std::size_t samples) {
        Request asked = request(2, 128, "path", samples);
        asked.path.exact = false;
        asked.path.reuse = false;
        View view = view_down_z(0.0, 0.0, 0.5);
        view.right *= 0.8;
        view.up *= 0.2;
        const Film film = render(scene, orthographic(view), asked).film;
        std::array<float, 2> light{};
        for (std::size_t y = 0; y < 128; ++y) {
            light[0] += film.pixel(0, y).g;
            light[1] += film.pixel(1, y).g;
        }
        return light[1] / light[0];
    };
    const float first = beyond(16);
    const float later = beyond(1024);
    const float last = beyond(8192);
    EXPECT_GT(last, 0.0F);
    EXPECT_LT(later, 0.8F * first);
    EXPECT_LT(last, 0.9F * later);
}

TEST(Softening, WhatTheCameraSeesDirectlyStaysSharp) {
    // A mirror at 45 degrees shows a lamp with an edge; nothing has scattered the light before.
    scene::Scene scene;
    add(scene, parallelogram({-1.0F, -1.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, {0.0F, 2.0F, 2.0F}),
        mirror());
    scene::Material lamp = white();
    lamp.base_color = Color3f(0.0F);
    lamp.specular = 0.0F;
    lamp.emission = Color3f(1.0F);
    add(scene, parallelogram({-0.03F, -3.0F, -5.0F}, {0.0F, 0.0F, 10.0F}, {5.0F, 0.0F, 0.0F}),
        lamp);
    const auto picture = [&](bool exact) {
        Request asked = request(16, 16, "path", 4);
        asked.path.exact = exact;
        return render(scene, orthographic(view_down_z(0.0, 0.0, 4.0)), asked).film.sum;
    };
    const std::vector<Color4d> found = picture(false);
    EXPECT_EQ(found, picture(true));
    EXPECT_GT(found[8 * 16 + 12].g, 3.0);
}

// Nothing, or a coat on top of it.
void expect_softened_coat_alone(Appearance& appearance) {
    EXPECT_FALSE(appearance.softened(0.5F));
    appearance.clearcoat = 1.0F;
    const std::optional<Appearance> softened = appearance.softened(0.5F);
    ASSERT_TRUE(softened);
    EXPECT_EQ(softened->roughness, appearance.roughness);
    EXPECT_EQ(softened->clearcoat_roughness, 0.5F);
    appearance.clearcoat = 0.0F;
}

TEST(Softening, LeavesPanesAlone) {
    Appearance pane;
    pane.base_color = Color3f(1.0F);
    pane.roughness = 0.0F;
    pane.transmission = 1.0F;
    expect_softened_coat_alone(pane);
    pane.thin_walled = false;
    EXPECT_TRUE(pane.softened(0.5F));
}

TEST(Softening, LeavesWideHighlightsAlone) {
    Appearance rough;
    rough.base_color = Color3f(0.5F);
    rough.roughness = 0.3F;
    expect_softened_coat_alone(rough);
}

}  // namespace
}  // namespace balcony::render::test::softening_test
