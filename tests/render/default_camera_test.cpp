// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Where the default camera stands, in scenes where there is one sensible place.

#include <gtest/gtest.h>

#include <cmath>

#include "balcony/probe.hpp"
#include "support.hpp"

namespace balcony::render::test::default_camera_test {
namespace {

/// A box that faces outwards.
scene::Mesh box(const V3f& low, const V3f& high) {
    scene::Mesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        const auto side = [&](int axis) { return (corner >> axis & 1) != 0 ? high : low; };
        mesh.positions.emplace_back(side(0).x, side(1).y, side(2).z);
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

std::uint32_t add_box(scene::Scene& scene, const V3f& low, const V3f& high) {
    return add(scene, box(low, high), white());
}

scene::Camera camera_of(const scene::Scene& scene) {
    const Result<scene::Camera> camera = default_camera(renderer_of(scene));
    EXPECT_TRUE(camera) << to_text(camera.diagnostics);
    return *camera;
}

// Where a point is in the picture: from -1 to 1 in x and y; NaN behind the camera.
Imath::V2d projected(const scene::Camera& camera, const V3d& point) {
    const V3d way = point - camera.position;
    const double depth = way.dot(camera.forward);
    const double scale = depth > 0.0 ? 1.0 / (depth * camera.half_height) : std::nan("");
    return {way.dot(camera.right) * scale / camera.aspect, way.dot(camera.up) * scale};
}

// The largest coordinate of the corners of a box in the picture.
double reach(const scene::Camera& camera, const V3d& low, const V3d& high) {
    double most = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const auto side = [&](int axis) { return (corner >> axis & 1) != 0 ? high : low; };
        const Imath::V2d at = projected(camera, {side(0).x, side(1).y, side(2).z});
        EXPECT_FALSE(std::isnan(at.x));
        most = std::max({most, std::abs(at.x), std::abs(at.y)});
    }
    return most;
}

bool is_within(const V3d& p, const V3d& low, const V3d& high) {
    return low.x < p.x && p.x < high.x && low.y < p.y && p.y < high.y && low.z < p.z &&
           p.z < high.z;
}

void expect_orthonormal(const scene::Camera& camera) {
    EXPECT_NEAR(camera.right.cross(camera.up).dot(-camera.forward), 1.0, 1e-9);
    EXPECT_NEAR(camera.right.y, 0.0, 1e-9) << "the horizon is level";
}

TEST(DefaultCamera, ShowsAnObjectAsLargeAsItFits) {
    for (const float size : {0.001F, 1.0F, 1e4F}) {
        scene::Scene scene;
        add_box(scene, V3f(-size), V3f(size, 2.0F * size, 3.0F * size));
        const scene::Camera camera = camera_of(scene);
        expect_orthonormal(camera);
        const double most = reach(camera, V3d(-size), V3d(size, 2.0F * size, 3.0F * size));
        EXPECT_GT(most, 0.85);
        EXPECT_LT(most, 0.95);
    }
}

TEST(DefaultCamera, OverlooksNoObjectOnALargeGroundOrUnderASky) {
    scene::Scene scene;
    add(scene, parallelogram({-60.0F, 0.0F, 60.0F}, {120.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -120.0F}),
        white());
    add_box(scene, {14.0F, 0.0F, 8.0F}, {15.0F, 2.0F, 9.0F});
    EXPECT_GT(reach(camera_of(scene), V3d(14, 0, 8), V3d(15, 2, 9)), 0.85);
    add_box(scene, V3f(-200.0F), V3f(200.0F));
    EXPECT_GT(reach(camera_of(scene), V3d(14, 0, 8), V3d(15, 2, 9)), 0.85);
}

// Six thick walls round two pieces of furniture.
scene::Scene furnished_room() {
    scene::Scene scene;
    constexpr float t = 0.2F;
    constexpr float w = 6.0F;
    constexpr float h = 3.0F;
    constexpr float d = 4.0F;
    add_box(scene, {-t, -t, -t}, {w + t, 0.0F, d + t});
    add_box(scene, {-t, h, -t}, {w + t, h + t, d + t});
    add_box(scene, {-t, 0.0F, -t}, {0.0F, h, d + t});
    add_box(scene, {w, 0.0F, -t}, {w + t, h, d + t});
    add_box(scene, {0.0F, 0.0F, -t}, {w, h, 0.0F});
    add_box(scene, {0.0F, 0.0F, d}, {w, h, d + t});
    add_box(scene, {2.5F, 0.0F, 1.5F}, {3.5F, 0.8F, 2.5F});
    add_box(scene, {5.0F, 0.0F, 0.5F}, {5.8F, 1.5F, 1.0F});
    return scene;
}

TEST(DefaultCamera, StandsInsideAClosedRoom) {
    scene::Scene scene = furnished_room();
    for (const Axes axes : {Axes::y_up, Axes::z_up}) {
        scene.axes = axes;
        const scene::Camera camera = camera_of(scene);
        EXPECT_TRUE(is_within(camera.position, V3d(0.0), V3d(6, 3, 4))) << camera.position;
    }
    scene.axes = Axes::y_up;
    const scene::Camera camera = camera_of(scene);
    expect_orthonormal(camera);
    EXPECT_LT(std::abs(projected(camera, V3d(3.0, 0.4, 2.0)).x), 1.0) << "the furniture is seen";
    // With a wall missing it is no closed room, and everything is seen from outside.
    scene.instances.erase(scene.instances.begin() + 5);
    EXPECT_FALSE(is_within(camera_of(scene).position, V3d(0.0), V3d(6, 3, 4)));
}

TEST(DefaultCamera, StandsInAnEmptyRoomOnlyIfItIsMeantToBeSeenFromInside) {
    scene::Scene scene;
    add_box(scene, V3f(-2.0F), V3f(2.0F));
    const V3d low(-2.0);
    const V3d high(2.0);
    EXPECT_FALSE(is_within(camera_of(scene).position, low, high)) << "a block";
    scene.lights.emplace_back();
    EXPECT_TRUE(is_within(camera_of(scene).position, low, high)) << "a lamp is inside";
    scene.lights[0].position = V3d(5.0);
    EXPECT_FALSE(is_within(camera_of(scene).position, low, high)) << "a lamp is outside";
    scene.lights.clear();
    for (auto& triangle : scene.meshes[0].edit().triangles) {
        std::swap(triangle[1], triangle[2]);
    }
    EXPECT_TRUE(is_within(camera_of(scene).position, low, high)) << "the walls face inwards";
}

TEST(DefaultCamera, RefusesWhatHasNoSize) {
    EXPECT_FALSE(default_camera(renderer_of(scene::Scene{})));
}

}  // namespace
}  // namespace balcony::render::test::default_camera_test
