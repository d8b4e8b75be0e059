// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The cameras of the family `parallel` against the images of the axes that drawing books give.

#include <array>
#include <random>

#include "support.hpp"

namespace balcony::cameras::test::parallel_test {

namespace {

/// The pictures of unit vectors along x, y and z: (right, up), in units of the picture.
using Axes = std::array<V2d, 3>;

V2d polar(double length, double angle) {
    return {length * std::cos(angle), length * std::sin(angle)};
}

// A parallel projection is linear: the rays through the images of points contain the points.
void expect_axes(const Rays& camera, const Axes& axes, double width, const V3d& middle) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    const double pixels = camera.width() / width;
    for (int i = 0; i < 200; ++i) {
        const V3d p(part(random), part(random), part(random));
        const V2d image = axes[0] * p.x + axes[1] * p.y + axes[2] * p.z;
        const Ray ray = camera.at_pixel(0.5 * camera.width() + pixels * image.x,
                                        0.5 * camera.height() - pixels * image.y);
        ASSERT_TRUE(ray.valid);
        EXPECT_LE((middle + p - ray.origin).cross(ray.direction).length(), 1e-9);
        EXPECT_GT((middle + p - ray.origin).dot(ray.direction), 0.0) << "the ray starts behind";
    }
}

std::vector<lang::Override> at_a_place(std::vector<lang::Override> more = {}) {
    more.insert(more.end(), {{"width", "9"}, {"px", "4"}, {"py", "-3"}, {"pz", "2"}});
    return more;
}

const V3d place(4.0, -3.0, 2.0);

}  // namespace

TEST(ObliqueProjection, CavalierDrawsDepthInItsLengthAndCabinetInHalf) {
    for (const double angle : {30.0, 45.0, 135.0}) {
        const std::string text = std::to_string(angle) + "deg";
        const V2d left(-1.0, 0.0), up(0.0, 1.0);
        expect_axes(Rays("cavalier", at_a_place({{"angle", text}})),
                    {polar(1.0, angle * degree), left, up}, 9.0, place);
        expect_axes(Rays("cabinet", at_a_place({{"angle", text}})),
                    {polar(0.5, angle * degree), left, up}, 9.0, place);
    }
}

TEST(ObliqueProjection, MilitaryKeepsThePlanAndDrawsHeightsUp) {
    for (const double heights : {1.0, 0.75}) {
        expect_axes(
            Rays("military", at_a_place({{"yaw", "30deg"}, {"heights", std::to_string(heights)}})),
            {polar(1.0, 60.0 * degree), polar(1.0, 150.0 * degree), V2d(0.0, heights)}, 9.0, place);
    }
}

TEST(AxonometricProjection, IsometricHasOneScaleAndAxesAt120Degrees) {
    const double scale = std::sqrt(2.0 / 3.0);
    expect_axes(
        Rays("isometric", at_a_place()),
        {polar(scale, 30.0 * degree), polar(scale, 150.0 * degree), polar(scale, 90.0 * degree)},
        9.0, place);
}

// ISO 5456-3: the depth at 42 degrees (more exactly 41.41), the width at 7 (7.18), scales 1/2 to 1.
TEST(AxonometricProjection, DimetricHasTheStandardAnglesAndScales) {
    const double scale = 2.0 * std::sqrt(2.0) / 3.0;
    const double steep = std::acos(0.75);
    const double flat = std::asin(0.125);
    const Axes axes{polar(0.5 * scale, steep), polar(scale, 180.0 * degree - flat),
                    polar(scale, 90.0 * degree)};
    EXPECT_NEAR(steep / degree, 41.41, 0.005);
    EXPECT_NEAR(flat / degree, 7.18, 0.005);
    expect_axes(Rays("dimetric", at_a_place()), axes, 9.0, place);
    // The other side.
    expect_axes(Rays("dimetric", at_a_place({{"side", "-1"}})),
                {V2d(-axes[0].x, axes[0].y), V2d(axes[1].x, -axes[1].y), axes[2]}, 9.0, place);
}

// Gauss: with the images of the axes as complex numbers, the sum of their squares is 0.
TEST(AxonometricProjection, TrimetricFollowsTheTheoremOfGauss) {
    const double yaw = 25.0 * degree, pitch = -40.0 * degree;
    const V3d ahead(std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw),
                    std::sin(pitch));
    const V3d right = ahead.cross(V3d(0.0, 0.0, 1.0)).normalized();
    const V3d up = right.cross(ahead);
    const Axes axes{V2d(right.x, up.x), V2d(right.y, up.y), V2d(right.z, up.z)};
    V2d squares(0.0);
    for (const V2d& a : axes) {
        squares += V2d(a.x * a.x - a.y * a.y, 2.0 * a.x * a.y);
    }
    EXPECT_NEAR(squares.length(), 0.0, 1e-12);
    expect_axes(Rays("trimetric", at_a_place({{"yaw", "25deg"}, {"pitch", "-40deg"}})), axes, 9.0,
                place);
}

}  // namespace balcony::cameras::test::parallel_test
