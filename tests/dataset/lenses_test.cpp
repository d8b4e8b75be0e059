// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/format.h>

#include "support.hpp"

namespace balcony::dataset::lenses_test {
namespace {

class Lenses : public test::RoomTest {
protected:
    // The camera, as it is planned for pictures of 64 x 48.
    [[nodiscard]] PlannedCamera planned(const std::string& camera) const {
        write("lens.cam", camera);
        const auto recipe = read(
            "scenes = [\"room.obj\"]\ncameras = [\"lens.cam\"]\n"
            "[render]\nsize = \"64x48\"\n[[poses]]\n"
            "list = [[[1,0,0,0],[0,1,0,0],[0,0,1,0]]]\n");
        EXPECT_TRUE(recipe) << to_text(recipe.diagnostics);
        const auto plan = make_plan(*recipe);
        EXPECT_TRUE(plan) << to_text(plan.diagnostics);
        return plan->scenes[0].cameras[0];
    }

    static void expect_numbers(const PlannedCamera& camera, std::string_view model,
                               const std::vector<double>& numbers, double tolerance) {
        ASSERT_TRUE(camera.lens);
        EXPECT_EQ(camera.lens->model, model);
        ASSERT_EQ(camera.lens->numbers.size(), numbers.size());
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            EXPECT_NEAR(camera.lens->numbers[i], numbers[i], tolerance) << camera.lens->names[i];
        }
    }
};

// Half a pixel is between OpenCV's pixels and ours.
TEST_F(Lenses, APinholeHasItsNumbers) {
    expect_numbers(planned("camera c { eye opencv_pinhole(width = 64, height = 48, fx = 60, "
                           "fy = 66, cx = 29.5, cy = 26) }"),
                   "pinhole", {60, 66, 30, 26.5}, 1e-9);
}

TEST_F(Lenses, ADistortedLensHasItsNumbers) {
    // Coefficients of high powers are known as well as these are large in the picture.
    expect_numbers(planned("camera c { eye opencv_pinhole(width = 64, height = 48, fx = 60, "
                           "fy = 66, cx = 33, cy = 21, k1 = -0.2, k2 = 0.05, p1 = 0.002, "
                           "p2 = -0.003, k3 = 0.01) }"),
                   "opencv", {60, 66, 33.5, 21.5, -0.2, 0.05, 0.002, -0.003, 0.01}, 1e-6);
}

TEST_F(Lenses, AFisheyeHasItsNumbers) {
    expect_numbers(planned("camera c { eye opencv_fisheye(width = 64, height = 48, fx = 30, "
                           "fy = 33, cx = 30, cy = 25, k1 = 0.02, k2 = -0.01, k3 = 0.003, "
                           "k4 = 0.001) }"),
                   "opencv_fisheye", {30, 33, 30.5, 25.5, 0.02, -0.01, 0.003, 0.001}, 1e-6);
}

TEST_F(Lenses, AnOmnidirectionalLensHasItsNumbers) {
    expect_numbers(planned("camera c { eye omnidirectional(width = 64, height = 48, xi = 1.3, "
                           "fx = 70, fy = 74, cx = 33, cy = 22, k1 = -0.1, k2 = 0.02) }"),
                   "omnidirectional", {70, 74, 33.5, 22.5, -0.1, 0.02, 0, 0, 1.3}, 1e-4);
}

// A turned pinhole is one, with its own place and axes: the columns are ahead, left and up.
TEST_F(Lenses, APinholeMayStandAsideAndLookAnotherWay) {
    const PlannedCamera camera = planned(
        "camera c {\n map u = 0.5 .. -0.5, v = square\n eye point(0, 0, 0)\n"
        " toward plane((1, 0, 0))\n move rotate(z, 30deg), translate(1, 2, 3)\n}");
    ASSERT_TRUE(camera.lens);
    EXPECT_EQ(camera.lens->model, "pinhole");
    EXPECT_EQ(camera.lens->in_camera.position, (std::array{1.0, 2.0, 3.0}));
    const auto& rotation = camera.lens->in_camera.rotation;
    EXPECT_NEAR(rotation[0][0], std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(rotation[1][0], 0.5, 1e-12);
    EXPECT_NEAR(rotation[2][2], 1.0, 1e-12);
}

// Seen from the sphere itself, Mei's model is the stereographic projection.
TEST_F(Lenses, AStereographicFisheyeIsOmnidirectional) {
    const PlannedCamera camera = planned(
        "camera c {\n map u = 1.5 .. -1.5, v = square\n eye point(0, 0, 0)\n"
        " toward surface(u, v) = [1 - (u^2 + v^2)/4, u, v]\n}");
    ASSERT_TRUE(camera.lens);
    EXPECT_EQ(camera.lens->model, "omnidirectional");
    // Distortion stands in for xi, so that 1e-6 of a pixel leaves it this open.
    EXPECT_NEAR(camera.lens->number("xi"), 1.0, 1e-4);
    // Half the tangent of half the angle is at 64/3 pixels a unit, and the model has twice as many.
    EXPECT_NEAR(camera.lens->number("fx"), 2.0 * 64.0 / 3.0, 1e-2);
}

// A picture that turns by 180 degrees is one of a camera that stands on its head.
TEST_F(Lenses, AMirrorImageHasNone) {
    const auto flipped = [](const char* u, const char* v) {
        return fmt::format(
            "camera c {{\n map u = {}, v = {}\n eye point(0, 0, 0)\n"
            " toward plane((1, 0, 0))\n}}",
            u, v);
    };
    EXPECT_FALSE(planned(flipped("-0.5 .. 0.5", "-0.375 .. 0.375")).lens);
    EXPECT_FALSE(planned(flipped("0.5 .. -0.5", "0.375 .. -0.375")).lens);
    const PlannedCamera turned = planned(flipped("-0.5 .. 0.5", "0.375 .. -0.375"));
    ASSERT_TRUE(turned.lens);
    EXPECT_NEAR(turned.lens->in_camera.rotation[2][2], -1.0, 1e-12);
}

// Between two models: a panorama is a pinhole along its columns and a fisheye along its rows.
TEST_F(Lenses, WhatIsOnlyNearIsNotTaken) {
    const PlannedCamera camera = planned(
        "camera c {\n map u = 0.5 .. -0.5, v = square\n eye point(0, 0, 0)\n"
        " toward surface(u, v) = [cos(u), sin(u), v]\n}");
    EXPECT_TRUE(camera.viewpoint);
    EXPECT_FALSE(camera.lens);
}

TEST_F(Lenses, RaysFromSeveralPointsHaveNone) {
    const PlannedCamera camera = planned(
        "camera c {\n map u = 0.5 .. -0.5, v = square\n eye line((0, 0, 0), (0, 1, 0))\n"
        " toward plane((1, 0, 0))\n}");
    EXPECT_FALSE(camera.lens);
    EXPECT_FALSE(camera.viewpoint);
}

}  // namespace
}  // namespace balcony::dataset::lenses_test
