// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The measures of scenes to which cameras are fitted.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "balcony/probe.hpp"
#include "support.hpp"

namespace balcony::render::test::scene_extent_test {
namespace {

using std::numbers::pi;

/// A surface of revolution around the vertical axis through (x, y), as a mesh with z up.
scene::Mesh lathe(double x, double y, const std::vector<Imath::V2d>& profile, int sides) {
    scene::Mesh mesh;
    for (const Imath::V2d& p : profile) {
        for (int i = 0; i < sides; ++i) {
            const double angle = 2.0 * pi * i / sides;
            mesh.positions.emplace_back(static_cast<float>(x + p.x * std::cos(angle)),
                                        static_cast<float>(y + p.x * std::sin(angle)),
                                        static_cast<float>(p.y));
        }
    }
    for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring) {
        const auto n = static_cast<std::uint32_t>(sides);
        for (std::uint32_t i = 0; i < n; ++i) {
            const auto a = static_cast<std::uint32_t>(ring) * n + i;
            const auto b = static_cast<std::uint32_t>(ring) * n + (i + 1) % n;
            mesh.triangles.push_back({a, b, b + n});
            mesh.triangles.push_back({a, b + n, a + n});
        }
    }
    return mesh;
}

/// A room with walls that face inwards.
scene::Mesh room(const V3f& low, const V3f& high) {
    scene::Mesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        const auto side = [&](int axis) { return (corner >> axis & 1) != 0 ? high : low; };
        mesh.positions.emplace_back(side(0).x, side(1).y, side(2).z);
    }
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {4, 6, 5}, {5, 6, 7}, {0, 4, 1}, {1, 4, 5},
                      {2, 3, 6}, {3, 7, 6}, {0, 2, 4}, {2, 6, 4}, {1, 5, 3}, {3, 5, 7}};
    return mesh;
}

scene::Scene empty(Axes axes) {
    scene::Scene scene;
    scene.axes = axes;
    return scene;
}

}  // namespace

TEST(SceneExtent, FollowsAnObjectOfRevolution) {
    scene::Scene scene = empty(Axes::z_up);
    // A cone frustum with a bulge; its radius is linear in the height between these points.
    add(scene, lathe(3.0, -2.0, {{1.0, 0.0}, {2.0, 4.0}, {0.5, 8.0}}, 64), white());
    const Result<SceneExtent> extent = measure_scene(renderer_of(scene));
    ASSERT_TRUE(extent);
    EXPECT_NEAR(extent->radius, 2.0, 1e-6);
    EXPECT_NEAR(extent->bounds.min.z, 0.0, 1e-6);
    EXPECT_NEAR(extent->bounds.max.z, 8.0, 1e-6);
    ASSERT_EQ(extent->profile.size(), 33U);
    EXPECT_NEAR(extent->profile.front().y, -4.0, 1e-6);
    EXPECT_NEAR(extent->profile.back().y, 4.0, 1e-6);
    for (const Imath::V2d& p : extent->profile) {
        const double z = p.y + 4.0;
        const double radius = z < 4.0 ? 1.0 + z / 4.0 : 2.0 - (z - 4.0) * 1.5 / 4.0;
        // It contains the object, and no more than the interval of heights below or above needs,
        // which has a 32nd of the height.
        EXPECT_GE(p.x, radius - 1e-6) << z;
        EXPECT_LE(p.x, radius + 0.25 * 1.5 / 4.0 + 1e-6) << z;
    }
}

TEST(SceneExtent, StandsInARoomAtEyeLevel) {
    for (const Axes axes : {Axes::z_up, Axes::y_up}) {
        scene::Scene scene = empty(axes);
        scene::Mesh walls = room({10.0F, 20.0F, 0.0F}, {18.0F, 24.0F, 5.0F});
        for (V3f& p : walls.positions) {
            p = turned(p, Axes::z_up, axes);
        }
        add(scene, walls, white());
        const Result<SceneExtent> extent = measure_scene(renderer_of(scene));
        ASSERT_TRUE(extent);
        EXPECT_NEAR(extent->inside.x, 14.0, 1.0);
        EXPECT_NEAR(extent->inside.y, 22.0, 1.0);
        EXPECT_NEAR(extent->inside.z, 1.6, 1e-3);
        EXPECT_EQ(extent->bounds.min, (V3d{10.0, 20.0, 0.0}));
        EXPECT_EQ(extent->bounds.max, (V3d{18.0, 24.0, 5.0}));
    }
}

// A cupboard stands in the middle of the room.
TEST(SceneExtent, StandsInNothingSolid) {
    scene::Scene scene = empty(Axes::z_up);
    add(scene, room({0.0F, 0.0F, 0.0F}, {8.0F, 6.0F, 5.0F}), white());
    scene::Mesh cupboard = room({2.5F, 2.0F, 0.0F}, {5.5F, 4.0F, 4.0F});
    for (auto& triangle : cupboard.triangles) {
        std::swap(triangle[0], triangle[1]);
    }
    add(scene, cupboard, white());
    const Result<SceneExtent> extent = measure_scene(renderer_of(scene));
    ASSERT_TRUE(extent);
    const V3d p = extent->inside;
    EXPECT_TRUE(p.x < 2.5 || p.x > 5.5 || p.y < 2.0 || p.y > 4.0) << p;
    EXPECT_NEAR(p.z, 1.6, 1e-3);
}

TEST(SceneExtent, OfAFlatSceneHasNoSideOfLengthZero) {
    scene::Scene scene = empty(Axes::z_up);
    add(scene, parallelogram({0.0F, 0.0F, 5.0F}, {8.0F, 0.0F, 0.0F}, {0.0F, 6.0F, 0.0F}), white());
    const Result<SceneExtent> extent = measure_scene(renderer_of(scene));
    ASSERT_TRUE(extent);
    EXPECT_NEAR(extent->radius, 5.0, 1e-6);
    EXPECT_NEAR(extent->bounds.size().z, 5.0 / 50.0, 1e-6);
    EXPECT_EQ(extent->bounds.size().x, 8.0);
}

TEST(SceneExtent, KnowsObjectsByName) {
    scene::Scene scene = empty(Axes::z_up);
    add(scene, lathe(0.0, 0.0, {{1.0, 0.0}, {1.0, 1.0}}, 32), white());
    const std::uint32_t far = add(scene, lathe(9.0, 0.0, {{2.0, 0.0}, {2.0, 3.0}}, 32), white());
    scene.objects[far - 1].name = "far one";
    const Result<SceneExtent> extent = measure_scene(renderer_of(scene), "far one");
    ASSERT_TRUE(extent);
    EXPECT_NEAR(extent->bounds.min.x, 7.0, 1e-6);
    EXPECT_NEAR(extent->radius, 2.0, 1e-6);
    EXPECT_FALSE(measure_scene(renderer_of(scene), "near one"));
    EXPECT_FALSE(measure_scene(renderer_of(empty(Axes::z_up))));
}

}  // namespace balcony::render::test::scene_extent_test
