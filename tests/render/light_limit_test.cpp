// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What a path finds at once of indirect light is limited, less from pass to pass.

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::render::test::light_limit_test {
namespace {

// No highlights, so nothing is softened.
scene::Material plaster(float albedo) {
    scene::Material material = white();
    material.base_color = Color3f(albedo);
    material.specular = 0.0F;
    return material;
}

// A closed room of side 2.
scene::Scene room(float albedo) {
    scene::Scene scene;
    const V3f x(2.0F, 0.0F, 0.0F);
    const V3f y(0.0F, 2.0F, 0.0F);
    const V3f z(0.0F, 0.0F, 2.0F);
    const V3f low(-1.0F);
    for (const auto& [corner, right, up] :
         {std::array{low, x, z}, std::array{low + y, x, z}, std::array{low, x, y},
          std::array{low + z, x, y}, std::array{low, y, z}, std::array{low + x, y, z}}) {
        add(scene, parallelogram(corner, right, up), plaster(albedo));
    }
    return scene;
}

scene::Material lamp(float radiance) {
    scene::Material material = plaster(0.0F);
    material.emission = Color3f(radiance);
    return material;
}

// A lamp lights a spot, of this radius, that few rays from a wall meet; a dim lamp lights the rest.
scene::Scene room_with_spot(float intensity, float radius) {
    scene::Scene scene = room(0.5F);
    add(scene, parallelogram({-0.5F, 0.99F, -0.5F}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}),
        lamp(0.3F));
    scene::Light spot;
    spot.kind = scene::LightKind::spot;
    spot.position = V3d(0.5, 0.0, 0.5);
    spot.direction = V3d(0.0, -1.0, 0.0);
    spot.inner_cone = 0.9F * radius;
    spot.outer_cone = radius;
    spot.intensity = Color3f(intensity);
    scene.lights = {spot};
    return scene;
}

Request request_of(bool exact, std::size_t samples, bool reuse = false) {
    Request asked = request(32, 32, "path", samples);
    asked.path.exact = exact;
    asked.path.reuse = reuse;
    return asked;
}

camera::Camera camera_at_wall() {
    return pinhole({{0.9, 0.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, -0.5}, {0.0, 0.5, 0.0}});
}

// Of a wall alone.
Rendered picture_of(const scene::Scene& scene, const Request& asked) {
    return render(scene, camera_at_wall(), asked);
}

std::vector<double> light_of(const Film& film) {
    std::vector<double> light;
    for (const Color4d& sum : film.sum) {
        light.push_back(sum.g);
    }
    return light;
}

double total(const Film& film) {
    double sum = 0.0;
    for (const double light : light_of(film)) {
        sum += light;
    }
    return sum;
}

TEST(LightLimit, WhatItLeavesOutGoesToNothingAsSamplesGrow) {
    const scene::Scene scene = room_with_spot(4.0F, 0.1F);
    double before = 0.2;
    for (const std::size_t samples : {32U, 128U, 512U}) {
        // The paths are the same.
        const Rendered limited = picture_of(scene, request_of(false, samples));
        const Rendered exact = picture_of(scene, request_of(true, samples));
        const double left_out = 1.0 - total(limited.film) / total(exact.film);
        EXPECT_GT(left_out, 0.0) << samples;
        EXPECT_LT(left_out, 0.7 * before) << samples;
        EXPECT_NEAR(limited.summary.layers.front().share_left_out(), left_out, 1e-4);
        EXPECT_EQ(exact.summary.layers.front().share_left_out(), 0.0);
        before = left_out;
    }
}

TEST(LightLimit, LeavesNoSpecks) {
    const scene::Scene scene = room_with_spot(100.0F, 0.05F);
    const auto specks = [&](bool exact, bool reuse) {
        std::vector<double> light = light_of(picture_of(scene, request_of(exact, 64, reuse)).film);
        std::sort(light.begin(), light.end());
        const double middle = light[light.size() / 2];
        return std::count_if(light.begin(), light.end(),
                             [&](double one) { return one > 2.0 * middle; });
    };
    for (const bool reuse : {false, true}) {
        EXPECT_GT(specks(true, reuse), 10) << reuse;
        EXPECT_EQ(specks(false, reuse), 0) << reuse;
    }
}

// Light that walls scatter among each other has no outliers, and neither has that of a bright part
// of a wall that a hundredth of the rays meet.
TEST(LightLimit, LeavesNothingOutWhereLightIsCommon) {
    scene::Scene scene = room(0.9F);
    add(scene, parallelogram({0.2F, 0.9F, 0.3F}, {0.4F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.4F}),
        lamp(10.0F));
    for (const bool reuse : {false, true}) {
        const Rendered limited = picture_of(scene, request_of(false, 16, reuse));
        const Rendered exact = picture_of(scene, request_of(true, 16, reuse));
        EXPECT_NEAR(total(limited.film) / total(exact.film), 1.0, 0.005);
        EXPECT_LT(limited.summary.layers.front().share_left_out(), 0.005);
    }
}

// The wall in view receives next to nothing but direct light, which is far above the limit.
TEST(LightLimit, DirectLightIsLeftAlone) {
    scene::Scene scene = room_with_spot(100.0F, 0.05F);
    for (scene::Material& material : scene.materials) {
        material.base_color = Color3f(0.01F);
    }
    scene.materials[4].base_color = Color3f(0.5F);
    const double exact = total(picture_of(scene, request_of(true, 16)).film);
    EXPECT_NEAR(total(picture_of(scene, request_of(false, 16)).film), exact, 0.01 * exact);
}

// The limits are those of the whole picture, of any pass, for any number of threads.
TEST(LightLimit, PartsHaveTheLightOfTheWhole) {
    const scene::Scene scene = room_with_spot(100.0F, 0.05F);
    Request asked = request_of(false, 8, true);
    const Film whole = picture_of(scene, asked).film;
    EXPECT_NE(whole.sum, picture_of(scene, request_of(true, 8, true)).film.sum);
    asked.threads = 1;
    EXPECT_EQ(picture_of(scene, asked).film.sum, whole.sum);
    asked.layout.window = Region{7, 5, 20, 9};
    const Film part = picture_of(scene, asked).film;
    for (std::size_t y = 5; y < 14; ++y) {
        for (std::size_t x = 7; x < 27; ++x) {
            ASSERT_EQ(part.pixel(x, y), whole.pixel(x, y)) << x << ' ' << y;
        }
    }
}

// Samples that are added later, or made as a shard, have the limits of their places in the whole.
TEST(LightLimit, LaterSamplesHaveTheLimitsOfTheWhole) {
    const scene::Scene scene = room_with_spot(100.0F, 0.05F);
    const Renderer renderer = renderer_of(scene);
    const Request asked = request_of(false, 8, true);
    const auto add_passes = [&](Film& film, std::size_t count) {
        Request part = asked;
        part.samples = count;
        ASSERT_TRUE(render::render(renderer, camera_at_wall(), part, film));
    };
    const Film whole = picture_of(scene, asked).film;
    Film resumed = *make_film(asked.layout);
    add_passes(resumed, 3);
    Film shards = resumed;
    add_passes(resumed, 8);
    EXPECT_EQ(resumed.sum, whole.sum);
    // One pass each, so that the sums are rounded in the same order.
    for (std::size_t pass = 3; pass < 8; ++pass) {
        Film shard = *make_film(asked.layout);
        shard.first_pass = pass;
        add_passes(shard, 1);
        for (std::size_t i = 0; i < shards.sum.size(); ++i) {
            shards.sum[i] += shard.sum[i];
        }
    }
    EXPECT_EQ(shards.sum, whole.sum);
}

}  // namespace
}  // namespace balcony::render::test::light_limit_test
