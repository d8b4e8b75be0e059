// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The measures of scenes to which cameras are fitted.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

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

// Leans towards -y by a tilt, and is elsewhere.
V3f leaning(const V3f& p, double tilt) {
    const V3d q(p);
    return V3f(V3d(q.x + 3.0, q.y * std::cos(tilt) - q.z * std::sin(tilt) - 4.0,
                   q.y * std::sin(tilt) + q.z * std::cos(tilt) + 5.0));
}

std::vector<Imath::V2d> straight(double radius, double height, int rings) {
    std::vector<Imath::V2d> profile;
    for (int i = 0; i <= rings; ++i) {
        profile.emplace_back(radius, height * i / rings);
    }
    return profile;
}

}  // namespace

// With noise of the standard deviation s across the surface, N samples tell each direction of the
// axis with the deviation s*sqrt(2)/(sqrt(N)*h), where h is the deviation of heights, 6/sqrt(12):
// 6.4e-5. The point of the axis has s*sqrt(2/N) = 1.1e-4, and the largest of the 24 means of
// distances, each of some 680 samples, is above the radius by about 2*s/sqrt(680) = 8e-4. The
// tolerances are ten and two times as large, as weights that resist outliers waste some samples.
TEST(SceneExtent, FindsTheAxisOfALeaningColumn) {
    constexpr double tilt = 0.2;
    constexpr double deviation = 0.01;
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, deviation);
    for (const Axes axes : {Axes::z_up, Axes::y_up}) {
        scene::Mesh column = lathe(0.0, 0.0, straight(2.0, 6.0, 64), 256);
        for (V3f& p : column.positions) {
            const float factor = 1.0F + static_cast<float>(noise(random) / 2.0);
            p = turned(leaning({p.x * factor, p.y * factor, p.z}, tilt), Axes::z_up, axes);
        }
        scene::Scene scene = empty(axes);
        add(scene, column, white());
        const Result<SceneExtent> extent = measure_scene(renderer_of(scene));
        ASSERT_TRUE(extent && extent->revolution);
        const Revolution& found = *extent->revolution;
        const V3d axis(0.0, -std::sin(tilt), std::cos(tilt));
        EXPECT_LE((found.axis - axis).length(), 6.4e-4);
        const V3d middle(leaning({0.0F, 0.0F, 3.0F}, tilt));
        const V3d beside = found.center - middle;
        EXPECT_LE((beside - beside.dot(axis) * axis).length(), 1.1e-3);
        EXPECT_LE(std::abs(beside.dot(axis)), 2.0 * 6.4e-4);
        EXPECT_NEAR(found.length, 6.0, 2.0 * 2.0 * 6.4e-4);
        EXPECT_NEAR(found.radius, 2.0, 1.6e-3);
        EXPECT_NEAR(found.reach, 2.0 + 4.5 * deviation, 1.5 * deviation);
        EXPECT_EQ(found.arc, 2.0 * pi);
        ASSERT_EQ(found.profile.size(), 33U);
        for (const Imath::V2d& p : found.profile) {
            EXPECT_NEAR(p.x, 2.0, 6.0 * deviation);
        }
    }
}

// A vase with inner and outer walls, a bottom and a handle.
TEST(SceneExtent, FindsTheAxisOfAVase) {
    std::vector<Imath::V2d> profile;
    for (int i = 0; i <= 80; ++i) {
        profile.emplace_back(1.5 + std::sin(0.05 * i), 0.05 * i);
    }
    for (int i = 80; i >= 0; --i) {
        profile.emplace_back(1.3 + std::sin(0.05 * i), 0.05 * i + 0.1);
    }
    profile.emplace_back(1e-3, 0.1);
    scene::Mesh vase = lathe(0.0, 0.0, profile, 128);
    scene::Mesh handle = lathe(3.0, 0.5, straight(0.3, 2.0, 4), 16);
    for (scene::Mesh* mesh : {&vase, &handle}) {
        for (V3f& p : mesh->positions) {
            p = leaning(p, 0.3);
        }
    }
    scene::Scene scene = empty(Axes::z_up);
    add(scene, vase, white());
    add(scene, handle, white());
    const Result<SceneExtent> extent = measure_scene(renderer_of(scene));
    ASSERT_TRUE(extent && extent->revolution);
    // The profile is bent where the fit takes it for 24 lines.
    EXPECT_LE((extent->revolution->axis - V3d(0.0, -std::sin(0.3), std::cos(0.3))).length(), 2e-3);
    EXPECT_NEAR(extent->revolution->radius, 2.5, 0.01);
    EXPECT_NEAR(extent->revolution->reach, std::hypot(3.3, 0.5), 0.1);
}

TEST(SceneExtent, KnowsThePartOfTheWayAroundThatAWallTakes) {
    scene::Mesh wall;
    // 70 degrees around 100.
    constexpr int columns = 140;
    for (int ring = 0; ring <= 20; ++ring) {
        for (int i = 0; i <= columns; ++i) {
            const double angle = (65.0 + 0.5 * i) * pi / 180.0;
            wall.positions.emplace_back(static_cast<float>(5.0 * std::cos(angle)),
                                        static_cast<float>(5.0 * std::sin(angle)),
                                        0.15F * static_cast<float>(ring));
        }
    }
    for (std::uint32_t ring = 0; ring < 20; ++ring) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t a = ring * (columns + 1) + i;
            wall.triangles.push_back({a, a + 1, a + columns + 2});
            wall.triangles.push_back({a, a + columns + 2, a + columns + 1});
        }
    }
    scene::Scene scene = empty(Axes::z_up);
    add(scene, wall, white());
    const Result<SceneExtent> extent = measure_scene(renderer_of(scene));
    ASSERT_TRUE(extent && extent->revolution);
    const Revolution& found = *extent->revolution;
    EXPECT_EQ(found.axis, V3d(0.0, 0.0, 1.0));
    // Its facets leave the cylinder by 5*(1 - cos(0.25 deg)) = 5e-5, of which the radius and the
    // centre of an arc of this depth (0.9) are the fifth.
    EXPECT_NEAR(found.radius, 5.0, 1e-3);
    EXPECT_LE(found.center.x * found.center.x + found.center.y * found.center.y, 1e-6);
    EXPECT_NEAR(found.arc, 70.0 * pi / 180.0, 1e-3);
    EXPECT_NEAR(found.arc_middle, 100.0 * pi / 180.0, 1e-3);
}

TEST(SceneExtent, ARoomIsNoSurfaceOfRevolution) {
    for (const V3f& high : {V3f(8.0F, 6.0F, 3.0F), V3f(4.0F, 4.0F, 4.0F), V3f(1.0F, 1.0F, 9.0F)}) {
        scene::Scene scene = empty(Axes::z_up);
        add(scene, room({0.0F, 0.0F, 0.0F}, high), white());
        const Result<SceneExtent> extent = measure_scene(renderer_of(scene));
        ASSERT_TRUE(extent);
        EXPECT_FALSE(extent->revolution) << high;
    }
}

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
