// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Unrolled surfaces against the surfaces: where rays meet them, and to which scale.

#include <cmath>

#include "support.hpp"

namespace balcony::cameras::test::unroll_test {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double tolerance = 1e-12;

// Where a ray first meets the sphere of a radius around the origin.
V3d on_sphere(const Ray& ray, double radius) {
    const double middle = -(ray.origin ^ ray.direction);
    const double root = radius * radius - ray.origin.length2() + middle * middle;
    return ray.origin + (middle - std::sqrt(root)) * ray.direction;
}

// A profile of a sphere as --fit gives it: 33 points at even heights.
std::string profile_of_sphere(double radius) {
    std::string list;
    for (int i = 0; i <= 32; ++i) {
        const double z = radius * (i / 16.0 - 1.0);
        list += (list.empty() ? "[" : ", ") +
                ("(" + std::to_string(std::max(std::sqrt(radius * radius - z * z), 1e-3)) + ", " +
                 std::to_string(z) + ")");
    }
    return list + "]";
}

}  // namespace

// Equal steps of the picture are equal lengths on a cylinder of the radius, in both directions.
TEST(Rollout, UnrollsACylinderToScale) {
    const Rays rays(
        make("rollout", {{"radius", "2"}, {"height", "3"}, {"distance", "0.5"}, {"pz", "1"}}));
    const double pixel = 2.0 * pi * 2.0 / rays.width();
    EXPECT_NEAR(pixel, 3.0 / rays.height(), tolerance);
    for (const double x : {0.1, 0.25, 0.5, 0.8}) {
        for (const double y : {0.0, 0.3, 0.9}) {
            const Ray ray = rays.at(x, y);
            EXPECT_NEAR(std::hypot(ray.origin.x, ray.origin.y), 2.5, tolerance);
            EXPECT_NEAR(ray.direction.z, 0.0, tolerance);
            const V3d met = ray.origin + 0.5 * ray.direction;
            expect_near(
                met,
                {2.0 * std::cos(2.0 * pi * x), 2.0 * std::sin(2.0 * pi * x), 1.0 + 3.0 * (0.5 - y)},
                tolerance);
        }
    }
    // The side towards a viewer who looks along x is in the middle.
    expect_near(rays.at(0.5, 0.5).direction, {1.0, 0.0, 0.0}, tolerance);
    // Half of it from another seam.
    const Rays half(make("rollout", {{"width", "180deg"}, {"seam", "90deg"}}));
    expect_near(half.at(0.0, 0.5).direction, {0.0, -1.0, 0.0}, tolerance);
    expect_near(half.at(1.0, 0.5).direction, {0.0, 1.0, 0.0}, tolerance);
}

// Rays towards a leaning axis meet its cylinder at even arc lengths and heights.
TEST(Rollout, UnrollsALeaningCylinderToScale) {
    const Rays rays(make("rollout", {{"radius", "2"},
                                     {"height", "3"},
                                     {"distance", "0.5"},
                                     {"tilt", "30deg"},
                                     {"tilt_toward", "90deg"},
                                     {"pz", "1"}}));
    const V3d axis(0.0, 0.5, std::sqrt(0.75));
    for (const double x : {0.1, 0.5, 0.8}) {
        for (const double y : {0.0, 0.3, 0.9}) {
            const Ray ray = rays.at(x, y);
            EXPECT_NEAR(ray.direction ^ axis, 0.0, tolerance);
            const V3d met = ray.origin + 0.5 * ray.direction - V3d(0.0, 0.0, 1.0);
            EXPECT_NEAR(met ^ axis, 3.0 * (0.5 - y), tolerance);
            EXPECT_NEAR((met - (met ^ axis) * axis).length(), 2.0, tolerance);
            // x stays across the tilt.
            EXPECT_NEAR(met.x, 2.0 * std::cos(2.0 * pi * x), tolerance);
        }
    }
}

// Unrolled by the profile of a sphere, the latitude is the angle of the place in the picture.
TEST(RolloutProfile, MeetsASphereAtRightAnglesAndEvenLatitudes) {
    const double radius = 2.0;
    const Rays rays(make("rollout_profile", {{"profile", profile_of_sphere(radius)},
                                             {"radius", "2"},
                                             {"length", std::to_string(pi * radius)},
                                             {"distance", "0.3"}}));
    EXPECT_NEAR(rays.width() / rays.height(), 2.0, 1e-6);
    for (const double x : {0.1, 0.4, 0.75}) {
        for (const double y : {0.2, 0.35, 0.5, 0.7}) {
            const Ray ray = rays.at(x, y);
            ASSERT_TRUE(ray.valid);
            const V3d met = on_sphere(ray, radius);
            // The spline through 33 points leaves the circle by less than a hundredth of a step.
            EXPECT_LE((met.normalized() + ray.direction).length(), 0.01);
            EXPECT_NEAR(std::asin(met.z / radius), (0.5 - y) * pi, 0.01);
            EXPECT_NEAR(ray.origin.length(), radius + 0.3, 0.01);
            const double turn = std::remainder(std::atan2(met.y, met.x) - 2.0 * pi * x, 2.0 * pi);
            EXPECT_NEAR(turn, 0.0, tolerance);
        }
    }
}

TEST(RolloutProfile, LooksHorizontallyWithoutSlant) {
    const Rays rays(make("rollout_profile", {{"slant", "0"}}));
    for (const double y : {0.1, 0.5, 0.9}) {
        expect_near(rays.at(0.5, y).direction, {1.0, 0.0, 0.0}, tolerance);
        expect_near(rays.at(0.25, y).direction, {0.0, -1.0, 0.0}, tolerance);
    }
}

// The length that fit gives is that of the fitted profile.
TEST(RolloutProfile, FitsTheLengthOfTheProfile) {
    lang::SceneMeasures cone{.min = {-4.0, -4.0, 0.0},
                             .max = {4.0, 4.0, 3.0},
                             .inside = {0.0, 0.0, 1.0},
                             .radius = 4.0,
                             .profile = {}};
    for (int i = 0; i <= 32; ++i) {
        cone.profile.push_back({4.0 - i / 8.0 + 1e-3, 3.0 * (i / 32.0 - 0.5)});
    }
    lang::Workspace workspace;
    workspace.fit_to(cone);
    const Result<camera::Picture> made = workspace.make_picture("rollout_profile");
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_NEAR(made->aspect(), 2.0 * pi * 4.0 / 5.0, tolerance);
}

}  // namespace balcony::cameras::test::unroll_test
