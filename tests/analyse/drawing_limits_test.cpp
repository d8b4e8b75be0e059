// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Drawings and models of cameras that nobody can draw whole: they end, say what they leave out, and
// hold numbers alone.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "../laws/built_in_cameras.hpp"
#include "balcony/drawing.hpp"
#include "support.hpp"

namespace balcony::analyse::drawing_limits_test {
namespace {

constexpr std::size_t max_points = 2'000'000;  // What a drawing may follow lines with.

std::string map_and_eye(const std::string& map, const std::string& eye) {
    return "camera c {\n map " + map + "\n eye " + eye + "\n look normal\n}";
}

bool says(const Diagnostics& diagnostics, const std::string& text) {
    return std::any_of(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& one) {
        return one.message.find(text) != std::string::npos;
    });
}

std::size_t point_count(const Drawing& drawing) {
    std::size_t count = 0;
    for (const DrawingShape& shape : drawing.shapes) {
        count += shape.points.size();
    }
    return count;
}

void expect_numbers(const Drawing& drawing) {
    for (const DrawingShape& shape : drawing.shapes) {
        for (const V2d& point : shape.points) {
            ASSERT_TRUE(std::isfinite(point.x) && std::isfinite(point.y)) << point;
        }
    }
}

void expect_numbers(const scene::Scene& scene) {
    for (const scene::Mesh& mesh : scene.meshes) {
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            ASSERT_TRUE(std::isfinite(mesh.positions[i].length())) << mesh.positions[i];
            ASSERT_NEAR(mesh.normals[i].length(), 1.0F, 1e-3F);
        }
    }
}

// Lines that wind without end, that jump without end, and that do so in a small part of the object.
TEST(DrawingLimits, EndlessLinesAreLeftOutAndThatIsSaid) {
    for (const std::string& text :
         {map_and_eye("u = -1e9 .. 1e9, v = -0.5 .. 0.5", "sphere(1)"),
          map_and_eye("u = -1 .. 1, v = -1 .. 1", "surface(u, v) = [u, v, mod(1e9*u, 1)]"),
          map_and_eye("u = -1 .. 1, v = -1 .. 1", "surface(u, v) = [u, v, sqrt(sin(1e5*u))]"),
          map_and_eye("u = -1 .. 1, v = -1 .. 1",
                      "surface(u, v) = [u, v, sin(1e3/(u*u + v*v))]")}) {
        const camera::Camera camera = test::camera_of(text);
        const Result<Drawing> drawing = draw(camera);
        ASSERT_TRUE(drawing) << text;
        EXPECT_TRUE(says(drawing.diagnostics, "turn or jump too often")) << text;
        EXPECT_FALSE(has_errors(drawing.diagnostics));
        expect_numbers(*drawing);
        EXPECT_LE(point_count(*drawing), max_points) << text;
        const Result<scene::Scene> scene = model(camera);
        ASSERT_TRUE(scene) << text;
        EXPECT_TRUE(says(scene.diagnostics, "turn or jump too often")) << text;
        expect_numbers(*scene);
        EXPECT_LE(scene->triangle_count(), 5'000'000U) << text;
    }
}

TEST(DrawingLimits, AUsualCameraIsDrawnWhole) {
    for (const std::string& name : laws::single_built_in_cameras()) {
        // The seams of one repeat without end; the other has rays only outside a mirror's shadow.
        if (name == "droste" || name == "cylindrical_anamorphosis") {
            continue;
        }
        EXPECT_TRUE(draw(test::standard(name)).diagnostics.empty()) << name;
        EXPECT_TRUE(model(test::standard(name)).diagnostics.empty()) << name;
    }
    // A helix of a hundred turns, and a dozen jumps in a line.
    for (const std::string& text :
         {std::string("camera c { map u = 0 .. 36000deg, v = 0 .. 1 eye helix(1, 0.1)"
                      " toward point(9, 0, 0) look relative }"),
          map_and_eye("u = -1 .. 1, v = -1 .. 1", "surface(u, v) = [u, v, floor(6*u)]")}) {
        EXPECT_TRUE(draw(test::camera_of(text)).diagnostics.empty()) << text;
    }
}

// What is too far away for any scene is left out; the rest stays as large as it is.
TEST(DrawingLimits, FarPartsAreLeftOutAndThatIsSaid) {
    const camera::Camera far_target = test::camera_of(R"(camera c {
        map    u = 1 .. -1, v = -1e308 .. 1
        eye    circle(2)
        toward surface(u, v) = [1, 0, v]
    })");
    const Result<Drawing> drawing = draw(far_target);
    ASSERT_TRUE(drawing);
    EXPECT_TRUE(says(drawing.diagnostics, "its direction object are farther"));
    expect_numbers(*drawing);
    const Result<scene::Scene> scene = model(far_target);
    ASSERT_TRUE(scene);
    expect_numbers(*scene);

    const Result<Drawing> far_rays = draw(test::camera_of(
        map_and_eye("u = -1 .. 1, v = -1 .. 1", "surface(u, v) = [u, v, if(u > 0, 1e30, 0)]")));
    ASSERT_TRUE(far_rays);
    EXPECT_TRUE(says(far_rays.diagnostics, "its rays are farther"));
    expect_numbers(*far_rays);

    const Result<Drawing> all_far =
        draw(test::camera_of(map_and_eye("u = -1 .. 1, v = -1 .. 1", "sphere(1e200)")));
    ASSERT_FALSE(all_far);
    EXPECT_TRUE(says(all_far.diagnostics, "no valid point within 1e+18 units"));
}

TEST(DrawingLimits, SmallAndLargeCamerasAreDrawnAlike) {
    const auto ball = [](const char* radius) {
        return draw(test::camera_of(map_and_eye("u = 180deg .. -180deg, v = -80deg .. 80deg",
                                                std::string("sphere(") + radius + ")")));
    };
    const Result<Drawing> unit = ball("1");
    // Below about 1e-72 the squares of its normals have no digits left, and there are no rays.
    for (const char* radius : {"1e-60", "1e-20", "1e17"}) {
        const Result<Drawing> drawing = ball(radius);
        ASSERT_TRUE(drawing) << radius;
        expect_numbers(*drawing);
        EXPECT_NEAR(static_cast<double>(point_count(*drawing)),
                    static_cast<double>(point_count(*unit)),
                    0.1 * static_cast<double>(point_count(*unit)))
            << radius;
    }
}

}  // namespace
}  // namespace balcony::analyse::drawing_limits_test
