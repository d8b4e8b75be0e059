// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Cameras of scenes against the formulas of perspective and parallel projection.

#include "balcony/scene_camera.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace balcony::data::scene_camera_test {
namespace {

using scene::V3d;

constexpr double rounding = 1e-12;

/// Somewhere, tilted.
scene::Camera tilted_camera(scene::Projection projection, double near) {
    scene::Camera camera;
    camera.name = "Eye";
    camera.projection = projection;
    camera.position = V3d(3, -2, 5);
    camera.forward = V3d(1, 2, -2) / 3.0;
    camera.up = V3d(2, 1, 2) / 3.0;
    camera.right = camera.forward.cross(camera.up);
    camera.half_height = 0.75;
    camera.aspect = 1.6;
    camera.near = near;
    return camera;
}

struct Ray {
    V3d origin;
    V3d direction;
};

Ray ray_at(const scene::Camera& camera, double x, double y, double width, double height) {
    const Result<camera::Camera> made = make_camera(camera, Axes::y_up);
    EXPECT_TRUE(made && made.diagnostics.empty()) << to_text(made.diagnostics);
    EXPECT_EQ(made->name(), "Eye");
    EXPECT_EQ(made->parts().aspect, camera.aspect);
    EXPECT_EQ(made->parts().axes, Axes::y_up);
    expr::Graph graph;
    const camera::RayExpressions ray = made->emit(graph, width, height);
    const std::vector<expr::Expr> all{ray.origin.x,    ray.origin.y,    ray.origin.z,
                                      ray.direction.x, ray.direction.y, ray.direction.z,
                                      ray.valid};
    const std::vector<double> found = expr::evaluate(all, {x, y});
    EXPECT_EQ(found[6], 1.0);
    return {{found[0], found[1], found[2]}, {found[3], found[4], found[5]}};
}

// The picture's coordinates of a pixel's point: up to half_height at the top.
V3d offset(const scene::Camera& camera, double x, double y, double width, double height) {
    const double scale = 2.0 * camera.half_height / height;
    return (x - 0.5 * width) * scale * camera.right + (0.5 * height - y) * scale * camera.up;
}

constexpr double sizes[][2] = {{160, 100}, {100, 100}, {300, 100}};
constexpr double places[][2] = {{0.5, 0.5}, {50.0, 50.0}, {99.5, 3.0}, {20.0, 80.0}};

TEST(SceneCamera, PerspectiveRaysPassThroughTheNearPlane) {
    for (const double near : {0.0, 0.1, 40.0}) {
        const scene::Camera camera = tilted_camera(scene::Projection::perspective, near);
        for (const auto& [width, height] : sizes) {
            for (const auto& [x, y] : places) {
                const Ray ray = ray_at(camera, x, y, width, height);
                const V3d way = camera.forward + offset(camera, x, y, width, height);
                EXPECT_TRUE(ray.direction.equalWithAbsError(way.normalized(), rounding));
                EXPECT_TRUE(ray.origin.equalWithAbsError(camera.position + near * way,
                                                         (1.0 + near) * rounding));
            }
        }
    }
}

TEST(SceneCamera, OrthographicRaysAreParallel) {
    for (const double near : {0.0, 0.1, 40.0}) {
        const scene::Camera camera = tilted_camera(scene::Projection::orthographic, near);
        for (const auto& [width, height] : sizes) {
            for (const auto& [x, y] : places) {
                const Ray ray = ray_at(camera, x, y, width, height);
                EXPECT_TRUE(ray.direction.equalWithAbsError(camera.forward, 1e-10));
                const V3d start =
                    camera.position + near * camera.forward + offset(camera, x, y, width, height);
                EXPECT_TRUE(ray.origin.equalWithAbsError(start, (1.0 + near) * rounding));
            }
        }
    }
}

TEST(SceneCamera, HasAScaleIfItIsOrthographic) {
    const scene::Camera flat = tilted_camera(scene::Projection::orthographic, 1.0);
    const auto made = make_camera(flat, Axes::y_up);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->parts().sides,
              (std::array{2.0 * flat.half_height * flat.aspect, 2.0 * flat.half_height}));
    const auto deep = make_camera(tilted_camera(scene::Projection::perspective, 1.0), Axes::y_up);
    ASSERT_TRUE(deep);
    EXPECT_FALSE(deep->parts().sides);
}

}  // namespace
}  // namespace balcony::data::scene_camera_test
