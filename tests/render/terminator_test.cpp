// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Shadows of coarse meshes with smooth normals on themselves.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support.hpp"

namespace balcony::render::test::terminator_test {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

scene::Light sun(const V3d& direction) {
    scene::Light light;
    light.kind = scene::LightKind::directional;
    light.direction = direction.normalized();
    return light;
}

// The part of the pixels of a sphere that are lit by their normals but black.
double wrongly_dark(const scene::Scene& scene, const V3d& to_light) {
    constexpr std::size_t side = 160;
    const Film film =
        render(scene, orthographic(view_down_z(0.0, 0.0, 5.0)), request(side, side, "direct")).film;
    std::size_t lit = 0;
    std::size_t dark = 0;
    for (std::size_t i = 0; i < side * side; ++i) {
        const bool faces_light = V3d(film.layers->normal[i]).dot(to_light) > 0.05;
        if (film.layers->object[i] == 1 && faces_light) {
            ++lit;
            dark += film.pixel(i % side, i / side).g > 0.0F ? 0 : 1;
        }
    }
    EXPECT_GT(lit, side);
    return static_cast<double>(dark) / static_cast<double>(lit);
}

// The smooth sphere has no shadow on itself where its normal faces the light.
TEST(Terminator, OfACoarseSphereIsThatOfTheSphere) {
    for (const std::uint32_t columns : {8U, 16U, 24U}) {
        scene::Scene scene;
        add(scene, coarse_sphere(0.9F, columns, columns / 2), white());
        for (const V3d& to_light : {V3d(1, 0, 0), V3d(1, 1, 0.3), V3d(-0.2, 1, 0.1)}) {
            scene.lights = {sun(-to_light)};
            EXPECT_EQ(wrongly_dark(scene, to_light.normalized()), 0.0) << columns;
            // A lamp far away.
            scene.lights[0].kind = scene::LightKind::point;
            scene.lights[0].intensity = Color3f(1e6F);
            scene.lights[0].position = 1000.0 * to_light.normalized();
            EXPECT_EQ(wrongly_dark(scene, to_light.normalized()), 0.0) << columns;
        }
    }
}

TEST(Terminator, LeavesShadowsOfOtherObjects) {
    scene::Scene scene;
    add(scene, coarse_sphere(0.9F, 16, 8), white());
    // A wall in front of the light.
    add(scene, parallelogram({2.0F, -2.0F, -2.0F}, {0.0F, 4.0F, 0.0F}, {0.0F, 0.0F, 4.0F}),
        white());
    scene.lights = {sun(V3d(-1, 0, 0))};
    EXPECT_EQ(wrongly_dark(scene, V3d(1, 0, 0)), 1.0);
}

// Inside a sphere the surface is concave: it shadows nothing and is moved nowhere.
TEST(Terminator, IsRightInsideASphereToo) {
    scene::Scene scene;
    add(scene, coarse_sphere(3.0F, 16, 8), white());
    scene.lights.emplace_back();
    scene.lights[0].position = V3d(0.5, 0.2, 0.0);
    const Film film =
        render(scene, orthographic(view_down_z(0.0, 0.0, 0.0)), request(60, 60, "direct")).film;
    for (std::size_t i = 0; i < 60 * 60; ++i) {
        ASSERT_GT(film.pixel(i % 60, i / 60).g, 0.0F) << i;
    }
}

}  // namespace
}  // namespace balcony::render::test::terminator_test
