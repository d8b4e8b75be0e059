// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The cameras of the family `perspective` against projection matrices.

#include <random>

#include <ImathMatrix.h>

#include "support.hpp"

namespace balcony::cameras::test::perspective_test {

namespace {

using Imath::M44d;

V3d random_point(std::mt19937_64& random, const V3d& min, const V3d& max) {
    std::uniform_real_distribution<double> part(0.0, 1.0);
    const auto between = [&](double a, double b) { return a + part(random) * (b - a); };
    return {between(min.x, max.x), between(min.y, max.y), between(min.z, max.z)};
}

// The distance of a point from the line of a ray.
double distance(const Ray& ray, const V3d& point) {
    return (point - ray.origin).cross(ray.direction).length();
}

/// The camera at a position, with angles in radians: forward, left and up are x, y and z (Imath
/// multiplies row vectors from the left).
M44d camera_from_world(const V3d& at, double yaw, double pitch, double roll) {
    const M44d turned = M44d().rotate(V3d(roll, 0.0, 0.0)) * M44d().rotate(V3d(0.0, -pitch, 0.0)) *
                        M44d().rotate(V3d(0.0, 0.0, yaw)) * M44d().translate(at);
    return turned.inverse();
}

/// The pinhole projection with a principal point beside the middle of the picture: the offsets are
/// in widths of the picture, to the right and upwards.
V2d shifted_pinhole(const V3d& in_camera, double fov, double shift, double rise, double width,
                    double height) {
    const double focal = 0.5 * width / std::tan(0.5 * fov);
    return {0.5 * width - shift * width - focal * in_camera.y / in_camera.x,
            0.5 * height + rise * width - focal * in_camera.z / in_camera.x};
}

}  // namespace

TEST(TwoPointPerspective, IsAPinholeWithItsPrincipalPointBesideTheMiddle) {
    const Rays camera("two_point", {{"fov", "50deg"},
                                    {"shift", "-0.3"},
                                    {"rise", "0.4"},
                                    {"yaw", "35deg"},
                                    {"px", "1"},
                                    {"py", "-2"},
                                    {"pz", "1.5"}});
    const V3d eye(1.0, -2.0, 1.5);
    const M44d to_camera = camera_from_world(eye, 35.0 * degree, 0.0, 0.0);
    std::mt19937_64 random(1);
    for (int i = 0; i < 300; ++i) {
        const V3d seen = random_point(random, {2.0, -4.0, -4.0}, {9.0, 4.0, 4.0});
        const V3d point = seen * to_camera.inverse();
        const V2d at =
            shifted_pinhole(seen, 50.0 * degree, -0.3, 0.4, camera.width(), camera.height());
        const Ray ray = camera.at_pixel(at.x, at.y);
        expect_near(ray.origin, eye, 1e-12);
        EXPECT_LE(distance(ray, point), 1e-9);
        EXPECT_GT((point - eye).dot(ray.direction), 0.0);
    }
}

TEST(TwoPointPerspective, KeepsVerticalsParallel) {
    const Rays camera("two_point", {{"rise", "0.5"}, {"yaw", "20deg"}});
    for (const double x : {0.1, 0.4, 0.9}) {
        // All rays of a column are in one vertical plane.
        const V3d n = camera.at(x, 0.0).direction.cross(camera.at(x, 1.0).direction);
        EXPECT_NEAR(n.normalized().z, 0.0, 1e-12);
    }
}

TEST(ThreePointPerspective, IsATiltedPinholeWithShift) {
    const Rays camera("three_point", {{"fov", "65deg"},
                                      {"shift", "0.1"},
                                      {"rise", "-0.2"},
                                      {"yaw", "-40deg"},
                                      {"pitch", "25deg"},
                                      {"roll", "10deg"},
                                      {"px", "3"}});
    const V3d eye(3.0, 0.0, 0.0);
    const M44d to_camera = camera_from_world(eye, -40.0 * degree, 25.0 * degree, 10.0 * degree);
    std::mt19937_64 random(2);
    for (int i = 0; i < 300; ++i) {
        const V3d seen = random_point(random, {2.0, -4.0, -4.0}, {9.0, 4.0, 4.0});
        const V3d point = seen * to_camera.inverse();
        const V2d at =
            shifted_pinhole(seen, 65.0 * degree, 0.1, -0.2, camera.width(), camera.height());
        EXPECT_LE(distance(camera.at_pixel(at.x, at.y), point), 1e-9);
    }
    // The vertical axis vanishes where its direction is seen.
    const V3d up = V3d(0.0, 0.0, 1.0) * to_camera - V3d(0.0) * to_camera;
    const V2d vanishing =
        shifted_pinhole(up, 65.0 * degree, 0.1, -0.2, camera.width(), camera.height());
    expect_near(camera.at_pixel(vanishing.x, vanishing.y).direction, {0.0, 0.0, 1.0}, 1e-9);
}

TEST(ReversePerspective, EnlargesByTheDistanceToItsPoint) {
    const Rays camera("reverse", {{"width", "8"}, {"distance", "20"}, {"px", "-2"}, {"pz", "1"}});
    std::mt19937_64 random(3);
    double before = 0.0;
    for (int i = 0; i < 300; ++i) {
        const double depth = 15.0 * i / 300.0;
        const V3d offset = random_point(random, {0.0, -0.5, -0.5}, {0.0, 0.5, 0.5});
        const double enlargement = 20.0 / (20.0 - depth);
        EXPECT_GE(enlargement, before);
        before = enlargement;
        const double pixels = camera.width() / 8.0 * enlargement;
        const Ray ray = camera.at_pixel(0.5 * camera.width() - pixels * offset.y,
                                        0.5 * camera.height() - pixels * offset.z);
        EXPECT_LE(distance(ray, V3d(depth - 2.0, offset.y, 1.0 + offset.z)), 1e-9);
    }
}

}  // namespace balcony::cameras::test::perspective_test
