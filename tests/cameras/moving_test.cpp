// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The built-in cameras that move, against the formulas of their ways.

#include <algorithm>
#include <cmath>

#include "support.hpp"

namespace balcony::cameras::test::moving_test {

namespace {

V3d unit(const V3d& v) { return v.normalized(); }

}  // namespace

// Every ray is in the plane of the axis and turns within it, from arctan(r tan(fov/2)) to r wide/2.
TEST(Moving, PinholeToFisheyeTurnsEachRayInItsPlane) {
    const double fov = 60.0 * degree;
    const double wide = 180.0 * degree;
    const Rays rays("pinhole_to_fisheye");
    for (const double time : {-1.0, 0.0, 1.0, 2.5, 4.0, 9.0}) {
        const double s = std::clamp(time / 4.0, 0.0, 1.0);
        const double amount = s * s * (3.0 - 2.0 * s);
        for (const double x : {0.0, 0.2, 0.6, 0.97}) {
            for (const double y : {0.1, 0.5, 0.8}) {
                const Ray ray = rays.at(x, y, time);
                ASSERT_TRUE(ray.valid);
                const V2d p(1.0 - 2.0 * x, (1.0 - 2.0 * y) * rays.height() / rays.width());
                const double r = p.length();
                const double angle =
                    (1.0 - amount) * std::atan(r * std::tan(fov / 2.0)) + amount * r * wide / 2.0;
                const V3d wanted(std::cos(angle), std::sin(angle) * p.x / r,
                                 std::sin(angle) * p.y / r);
                expect_near(ray.direction, wanted, 1e-12);
                expect_near(ray.origin, V3d(0.0), 0.0);
            }
        }
    }
}

TEST(Moving, PinholeToFisheyeCanBeHeldAndTurned) {
    const Rays held("pinhole_to_fisheye", {{"amount", "1/2"}, {"yaw", "90deg"}, {"pz", "2"}});
    const Ray middle = held.at(0.5, 0.5, 100.0);
    expect_near(middle.direction, V3d(0.0, 1.0, 0.0), 1e-14);
    expect_near(middle.origin, V3d(0.0, 0.0, 2.0), 1e-14);
    const Ray left = held.at(0.0, 0.5, 3.0);
    const double angle = 0.5 * (30.0 * degree + 90.0 * degree);
    expect_near(left.direction, V3d(-std::sin(angle), std::cos(angle), 0.0), 1e-12);
}

TEST(Moving, TurntableViewGoesRoundItsPointAndFacesIt) {
    const Rays rays("turntable_view", {{"px", "2"}, {"py", "-1"}, {"pz", "3"}, {"angle", "30deg"}});
    for (const double time : {0.0, 1.7, 6.0, 10.0, 12.5}) {
        const double angle = (30.0 + 36.0 * time) * degree;
        const V3d at(2.0 + 5.0 * std::cos(angle), -1.0 + 5.0 * std::sin(angle), 4.5);
        const Ray middle = rays.at(0.5, 0.5, time);
        expect_near(middle.origin, at, 1e-13);
        expect_near(middle.direction, unit(V3d(2.0, -1.0, 3.0) - at), 1e-13);
        // The picture stays upright: its middle row is level.
        const Ray right = rays.at(1.0, 0.5, time);
        const V3d across =
            right.direction / right.direction.dot(middle.direction) - middle.direction;
        EXPECT_NEAR(across.z, 0.0, 1e-13);
        EXPECT_NEAR(across.length(), std::tan(20.0 * degree), 1e-12);
    }
}

TEST(Moving, WalkthroughGoesThroughItsPointsAtConstantSpeed) {
    const Rays rays("walkthrough",
                    {{"path", "[(0, 0, 1), (3, 1, 1), (5, 4, 2), (5, 8, 2)]"}, {"seconds", "8"}});
    expect_near(rays.at(0.5, 0.5, 0.0).origin, V3d(0.0, 0.0, 1.0), 1e-9);
    expect_near(rays.at(0.5, 0.5, 8.0).origin, V3d(5.0, 8.0, 2.0), 1e-9);
    expect_near(rays.at(0.5, 0.5, 99.0).origin, V3d(5.0, 8.0, 2.0), 1e-9);
    // The length of the way is the speed times the derivative of the ease: 6 s (1 - s)/8.
    constexpr double h = 1e-4;
    double length = 0.0;
    for (const double time : {1.0, 2.0, 4.0, 5.5, 7.0}) {
        const V3d velocity =
            (rays.at(0.5, 0.5, time + h).origin - rays.at(0.5, 0.5, time - h).origin) / (2.0 * h);
        const double s = time / 8.0;
        const double whole = velocity.length() / (6.0 * s * (1.0 - s) / 8.0);
        length = length > 0.0 ? length : whole;
        EXPECT_NEAR(whole, length, 1e-4 * length);
        const Ray middle = rays.at(0.5, 0.5, time);
        expect_near(middle.direction, unit(velocity), 1e-5);
    }
    // A curve through the points is a little longer than the polygon.
    const double polygon = std::sqrt(10.0) + std::sqrt(14.0) + 4.0;
    EXPECT_GT(length, polygon);
    EXPECT_LT(length, 1.1 * polygon);
}

}  // namespace balcony::cameras::test::moving_test
