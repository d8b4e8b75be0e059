// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Turned cameras against Rodrigues' formula for a rotation about an axis.

#include <cmath>
#include <numbers>

#include "balcony/picture.hpp"
#include "support.hpp"

namespace balcony::camera::turn_test {

namespace {

using std::numbers::pi;

constexpr double tolerance = 1e-12;  // Rounding alone.

Vector operator+(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

// Rodrigues: v cos a + (k x v) sin a + k (k . v) (1 - cos a).
Vector rotated(const Vector& v, const Vector& axis, double angle) {
    return std::cos(angle) * v + std::sin(angle) * cross(axis, v) +
           ((1.0 - std::cos(angle)) * dot(axis, v)) * axis;
}

// A camera without any symmetry.
Camera plain(Axes axes) {
    Camera::Parts parts;
    parts.name = "plain";
    parts.axes = axes;
    parts.eye = {range(-1.0, 1.0, -0.7, 0.9), {}, object("sphere"), {}};
    parts.look = look("normal");
    return camera(std::move(parts));
}

}  // namespace

TEST(Turn, RotatesRaysAboutTheVerticalAxisThroughItsCenter) {
    const Vector center{0.5, -1.5, 2.0};
    for (const Axes axes : {Axes::z_up, Axes::y_up}) {
        const Vector up = axes == Axes::z_up ? Vector{0.0, 0.0, 1.0} : Vector{0.0, 1.0, 0.0};
        const CameraProbe still(plain(axes), 30, 20);
        for (const double angle : {0.0, 0.3, 2.0, -4.0}) {
            const CameraProbe turned(
                plain(axes).with_turn({angle, {center[0], center[1], center[2]}, axes}), 30, 20);
            for (const auto& [x, y] : {std::array{3.0, 4.0}, std::array{29.0, 0.5}}) {
                const Ray before = still(x, y);
                const Ray after = turned(x, y);
                ASSERT_TRUE(before.valid && after.valid);
                expect_near(after.origin, center + rotated(before.origin - center, up, angle),
                            tolerance);
                expect_near(after.direction, rotated(before.direction, up, angle), tolerance);
            }
        }
    }
}

// The centre (x, y, z) with y up is (x, -z, y) with z up.
TEST(Turn, TakesItsCenterInOtherAxes) {
    const CameraProbe own(plain(Axes::z_up).with_turn({1.0, {1.0, -3.0, 2.0}, Axes::z_up}), 30, 20);
    const CameraProbe other(plain(Axes::z_up).with_turn({1.0, {1.0, 2.0, 3.0}, Axes::y_up}), 30,
                            20);
    expect_near(own(7.0, 8.0).origin, other(7.0, 8.0).origin, tolerance);
}

TEST(Turn, FollowsTime) {
    const Scalar angle(
        formula(0, [](Graph& graph, const auto&) { return std::vector{0.5 * pi * graph.time()}; }));
    const CameraProbe moving(plain(Axes::z_up).with_turn({angle, {}, Axes::z_up}), 30, 20);
    const CameraProbe still(plain(Axes::z_up), 30, 20);
    const Vector before = still(3.0, 4.0).origin;
    expect_near(moving(3.0, 4.0, 1.0).origin, {-before[1], before[0], before[2]}, tolerance);
    expect_near(moving(3.0, 4.0, 4.0).origin, before, tolerance);
}

TEST(Turn, ComesBeforeTheOwnTimeOfRays) {
    const Scalar angle(
        formula(0, [](Graph& graph, const auto&) { return std::vector{pi * graph.time()}; }));
    Camera::Parts parts = plain(Axes::z_up).parts();
    parts.time =
        formula(2, [](Graph& graph, const auto&) { return std::vector{graph.constant(1.0)}; });
    const CameraProbe late(camera(std::move(parts)).with_turn({angle, {}, Axes::z_up}), 30, 20);
    const CameraProbe still(plain(Axes::z_up), 30, 20);
    const Vector before = still(3.0, 4.0).origin;
    expect_near(late(3.0, 4.0).origin, {-before[0], -before[1], before[2]}, tolerance);
}

TEST(Turn, OfAPictureTurnsAllCamerasAndKeepsThemShared) {
    const Camera one = plain(Axes::z_up);
    const auto inner = std::make_shared<const Picture>(
        *Picture::make({.name = "inner", .layers = {{"c", one}}, .size = {}}));
    const Picture whole = *Picture::make(
        {.name = "whole", .layers = {{"a", one}, {"b", inner}, {"c", one}}, .size = {}});
    const Turn turn{1.0, {}, Axes::z_up};
    const std::vector<ShownCamera> shown = shown_cameras(whole.with_turn(turn));
    ASSERT_EQ(shown.size(), 1U);
    EXPECT_EQ(shown[0].uses.size(), 3U);
    EXPECT_TRUE(shown[0].camera.parts().turn.has_value());

    const Picture alone = Picture(one).with_turn(turn);
    ASSERT_NE(alone.only_camera(), nullptr);
    EXPECT_TRUE(alone.only_camera()->parts().turn.has_value());
}

TEST(Pose, RotatesAndShiftsAllRays) {
    const Vector axis{2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0};
    const double angle = 0.7;
    Pose pose{.rotation = {}, .position = {3.0, -2.0, 0.5}};
    for (std::size_t i = 0; i < 3; ++i) {
        Vector unit{};
        unit[i] = 1.0;
        const Vector image = rotated(unit, axis, angle);
        for (std::size_t row = 0; row < 3; ++row) {
            pose.rotation[row][i] = image[row];
        }
    }
    const auto z_up = [](const Vector& v, Axes from) {
        return from == Axes::z_up ? v : Vector{v[0], -v[2], v[1]};
    };
    for (const Axes axes : {Axes::z_up, Axes::y_up}) {
        const CameraProbe still(plain(axes), 30, 20);
        const CameraProbe posed(plain(axes).with_pose(pose), 30, 20);
        const Ray before = still(3.0, 4.0);
        const Ray after = posed(3.0, 4.0);
        ASSERT_TRUE(before.valid && after.valid);
        expect_near(z_up(after.origin, axes),
                    rotated(z_up(before.origin, axes), axis, angle) + Vector{3.0, -2.0, 0.5},
                    tolerance);
        expect_near(z_up(after.direction, axes), rotated(z_up(before.direction, axes), axis, angle),
                    tolerance);
    }
}

TEST(Pose, ComesBeforeATurn) {
    const Pose pose{.rotation = Pose().rotation, .position = {1.0, 0.0, 0.0}};
    const Turn quarter{pi / 2.0, {}, Axes::z_up};
    const CameraProbe still(plain(Axes::z_up), 30, 20);
    for (const Camera& camera : {plain(Axes::z_up).with_pose(pose).with_turn(quarter),
                                 plain(Axes::z_up).with_turn(quarter).with_pose(pose)}) {
        expect_near(
            CameraProbe(camera, 30, 20)(3.0, 4.0).origin,
            rotated(still(3.0, 4.0).origin + Vector{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, pi / 2.0),
            tolerance);
    }
}

}  // namespace balcony::camera::turn_test
