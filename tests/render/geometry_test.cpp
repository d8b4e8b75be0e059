// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What the data layers say of scenes whose geometry is known.

#include <cmath>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::render::test::geometry_test {
namespace {

// A float's relative rounding, times the handful of roundings between a vertex and a hit.
constexpr double rounding = 8.0 * 6e-8;

constexpr std::size_t side = 40;

double parameter(std::size_t pixel) {
    return 2.0 * (static_cast<double>(pixel) + 0.5) / static_cast<double>(side) - 1.0;
}

template <class Check>
void for_each_pixel(Check check) {
    for (std::size_t y = 0; y < side; ++y) {
        for (std::size_t x = 0; x < side; ++x) {
            check(x, y, y * side + x);
        }
    }
}

Request preview() { return request(side, side, "preview"); }

TEST(Geometry, PinholeOnAWallMeasuresTheLengthOfTheRay) {
    scene::Scene scene;
    const std::uint32_t id = add(scene, wall(-3.0F, 20.0F), white());
    const Rendered picture = render(scene, pinhole(view_down_z(0.5, 0.25, 2.0)), preview());
    const DataLayers& layers = *picture.film.layers;
    constexpr double wall_size = 40.0;
    for_each_pixel([&](std::size_t x, std::size_t y, std::size_t i) {
        const double u = parameter(x);
        const double v = -parameter(y);
        const double length = 5.0 * std::sqrt(1.0 + u * u + v * v);
        EXPECT_NEAR(layers.ray_length[i], length, wall_size * rounding);
        EXPECT_NEAR(layers.position[i].x, 0.5 + 5.0 * u, wall_size * rounding);
        EXPECT_NEAR(layers.position[i].y, 0.25 + 5.0 * v, wall_size * rounding);
        EXPECT_NEAR(layers.parameters[i].x, u, rounding);
        EXPECT_NEAR(layers.parameters[i].y, v, rounding);
        EXPECT_EQ(layers.object[i], id);
        EXPECT_EQ(layers.valid[i], 1);
        EXPECT_NEAR(layers.origin[i].z, 2.0, rounding);
        EXPECT_NEAR(layers.direction[i].length(), 1.0, rounding);
        EXPECT_LT(layers.direction[i].z, 0.0F);
    });
}

TEST(Geometry, OrthographicRaysHitATiltedPlaneByTheFormula) {
    scene::Scene scene;
    // The plane z = x / 2.
    add(scene, parallelogram({-4.0F, -4.0F, -2.0F}, {8.0F, 0.0F, 4.0F}, {0.0F, 8.0F, 0.0F}),
        white());
    const Rendered picture = render(scene, orthographic(view_down_z(0.0, 0.0, 3.0)), preview());
    for_each_pixel([&](std::size_t x, std::size_t, std::size_t i) {
        EXPECT_NEAR(picture.film.layers->ray_length[i], 3.0 - 0.5 * parameter(x), 8.0 * rounding);
    });
}

TEST(Geometry, NearestObjectIsSeenAndNothingBesideIt) {
    scene::Scene scene;
    add(scene, wall(-3.0F, 20.0F), white());
    const std::uint32_t near = add(scene, wall(-1.0F, 0.5F), white());
    scene::Scene alone = scene;
    alone.instances.erase(alone.instances.begin());
    const Rendered both = render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)), preview());
    const Rendered one = render(alone, orthographic(view_down_z(0.0, 0.0, 1.0)), preview());
    for_each_pixel([&](std::size_t x, std::size_t y, std::size_t i) {
        const bool inside = std::abs(parameter(x)) < 0.5 && std::abs(parameter(y)) < 0.5;
        EXPECT_EQ(both.film.layers->object[i], inside ? near : 1);
        EXPECT_EQ(one.film.layers->object[i], inside ? near : 0);
        EXPECT_EQ(one.film.pixel(x, y).a, inside ? 1.0F : 0.0F);
        EXPECT_EQ(std::isinf(one.film.layers->ray_length[i]), !inside);
    });
}

TEST(Geometry, NormalsAreUnitAndFaceTheRayFromBothSides) {
    scene::Scene scene;
    add(scene, parallelogram({-4.0F, -4.0F, -2.0F}, {8.0F, 0.0F, 4.0F}, {0.0F, 8.0F, 0.0F}),
        white());
    View behind = view_down_z(0.0, 0.0, -5.0);
    behind.forward = -behind.forward;
    const float length = std::sqrt(1.25F);
    const V3f front(-0.5F / length, 0.0F, 1.0F / length);
    const Rendered before = render(scene, orthographic(view_down_z(0.0, 0.0, 5.0)), preview());
    const Rendered after = render(scene, orthographic(behind), preview());
    for_each_pixel([&](std::size_t, std::size_t, std::size_t i) {
        EXPECT_LT((before.film.layers->normal[i] - front).length(), rounding);
        EXPECT_LT((after.film.layers->normal[i] + front).length(), rounding);
    });
}

// An instance's matrix has a rotation, unequal scales and a reflection.
TEST(Geometry, SharedMeshesRenderLikeSeparateMeshes) {
    scene::M44d placed;
    placed.rotate(V3d(0.3, 0.5, 0.2));
    placed.scale(V3d(0.5, -1.5, 0.75));
    placed[3][0] = 0.25;
    placed[3][2] = -1.0;
    // Tilted, so that unequal scales turn its normal otherwise than its edges.
    const V3f right(1.6F, 0.0F, 0.8F);
    const V3f up(0.0F, 1.6F, 0.3F);
    scene::Scene own;
    add(own, parallelogram({-0.8F, -0.8F, -0.4F}, right, up), white(), placed);
    scene::Scene shared = own;
    shared.objects.push_back({"far away"});
    scene::M44d far_away;
    far_away[3][0] = 1e4;
    shared.instances.push_back({scene::MeshIndex(0), far_away, 1});
    const camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 1.0));
    const Rendered a = render(own, camera, preview());
    const Rendered b = render(shared, camera, preview());
    std::size_t hits = 0;
    for_each_pixel([&](std::size_t, std::size_t, std::size_t i) {
        ASSERT_EQ(a.film.layers->object[i], b.film.layers->object[i]);
        if (a.film.layers->object[i] == 0) {
            return;
        }
        ++hits;
        EXPECT_NEAR(a.film.layers->ray_length[i], b.film.layers->ray_length[i], 4.0 * rounding);
        EXPECT_LT((a.film.layers->normal[i] - b.film.layers->normal[i]).length(), 4.0 * rounding);
        EXPECT_LT(a.film.layers->normal[i].dot(a.film.layers->direction[i]), 0.0F);
        for (const V3d& edge : {V3d(right), V3d(up)}) {
            V3d placed_edge;
            placed.multDirMatrix(edge, placed_edge);
            EXPECT_NEAR(V3d(a.film.layers->normal[i]).dot(placed_edge), 0.0, 4.0 * rounding);
        }
    });
    EXPECT_GT(hits, side);
}

TEST(Geometry, CameraAxesAreTurnedIntoTheScenes) {
    // Camera axes z up, looking along +y from the origin: in a scene with y up that is -z.
    const View forward_y{{1.0, 2.0, 3.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
    scene::Scene y_up;
    add(y_up, wall(-10.0F, 50.0F), white());
    const Rendered turned = render(y_up, pinhole(forward_y, Axes::z_up), preview());
    const DataLayers& layers = *turned.film.layers;
    for_each_pixel([&](std::size_t x, std::size_t y, std::size_t i) {
        EXPECT_EQ(layers.origin[i], V3f(1.0F, 3.0F, -2.0F));
        EXPECT_GT(layers.direction[i].x * parameter(x), 0.0);
        EXPECT_LT(layers.direction[i].y * parameter(y), 0.0);
        EXPECT_LT(layers.direction[i].z, 0.0F);
    });

    scene::Scene z_up = y_up;
    z_up.axes = Axes::z_up;
    const Rendered back = render(z_up, pinhole(view_down_z(1.0, 2.0, 3.0), Axes::y_up), preview());
    EXPECT_EQ(back.film.layers->origin[0], V3f(1.0F, -3.0F, 2.0F));
    EXPECT_GT(back.film.layers->direction[0].y, 0.0F);
    EXPECT_GT(back.film.layers->direction[0].z, 0.0F);
}

TEST(Geometry, PreviewShadesByTheCosineToTheRay) {
    scene::Scene scene;
    scene::Material material = white();
    material.base_color = scene::Color3f(0.5F, 0.25F, 1.0F);
    add(scene, wall(-3.0F, 20.0F), material);
    const Rendered picture = render(scene, pinhole(view_down_z(0.0, 0.0, 0.0)), preview());
    for_each_pixel([&](std::size_t x, std::size_t y, std::size_t) {
        const double cosine =
            1.0 / std::sqrt(1.0 + parameter(x) * parameter(x) + parameter(y) * parameter(y));
        EXPECT_NEAR(picture.film.pixel(x, y).g, 0.25 * cosine, rounding);
    });
}

}  // namespace
}  // namespace balcony::render::test::geometry_test
