// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Strip cameras against their published projections: every point of a ray is projected to the place
// in the picture that the ray belongs to.

#include <cmath>
#include <functional>
#include <random>

#include "support.hpp"

namespace balcony::cameras::test::strip_test {

namespace {

constexpr double tolerance = 1e-9;

// Projects points of the rays; fractions from the top left corner.
void expect_projection(const Rays& rays, const std::function<V2d(const V3d&)>& project) {
    std::mt19937_64 random{5};
    std::uniform_real_distribution<double> place(0.0, 1.0);
    for (int i = 0; i < 100; ++i) {
        const V2d at(place(random), place(random));
        const Ray ray = rays.at(at.x, at.y);
        ASSERT_TRUE(ray.valid);
        for (const double distance : {2.0, 9.0}) {
            const V2d found = project(ray.origin + distance * ray.direction);
            EXPECT_NEAR(found.x, at.x, tolerance);
            EXPECT_NEAR(found.y, at.y, tolerance);
        }
    }
}

// How far what lies at a distance moves to the right from pixel to pixel.
double step_to_the_right(const Ray& ray, double distance) {
    const V3d right = ray.direction % V3d(0.0, 0.0, 1.0);
    return (ray.origin_by_x + distance * ray.direction_by_x) ^ right.normalized();
}

}  // namespace

// Orthographic along the street, perspective from the eye across it.
TEST(StreetStrip, IsParallelAlongTheStreetAndPerspectiveAcross) {
    const Rays rays("street_strip");  // length 20, distance 8, above 8, below 1.6
    EXPECT_NEAR(rays.width() / rays.height(), 20.0 / 9.6, tolerance);
    expect_projection(
        rays, [](const V3d& p) { return V2d(0.5 - p.y / 20.0, (8.0 - 8.0 * p.z / p.x) / 9.6); });
}

TEST(StreetStrip, ConvergesToAPinhole) {
    const Rays rays(make("street_strip", {{"converging", "1"}}));
    expect_projection(rays, [](const V3d& p) {
        return V2d(0.5 - 8.0 * p.y / p.x / 20.0, (8.0 - 8.0 * p.z / p.x) / 9.6);
    });
}

// Gupta and Hartley: one coordinate is the place of the scanner when its plane of view meets the
// point, the other the perspective projection in this plane.
TEST(Pushbroom, IsLinearAlongTheFlightAndPerspectiveAcross) {
    const Rays rays(make("pushbroom", {{"pz", "20"}, {"tilt", "10deg"}}));  // length 20, fov 30
    const double half_width = std::tan(15.0 * degree);
    EXPECT_NEAR(rays.width() / rays.height(), 2.0 * half_width, tolerance);
    expect_projection(rays, [&](const V3d& p) {
        const double depth = 20.0 - p.z;
        const double flown = p.x - depth * std::tan(10.0 * degree);
        return V2d(0.5 - p.y / depth / (2.0 * half_width), 0.5 - flown / 20.0);
    });
}

TEST(Pushbroom, ScansLaterWhatLiesAhead) {
    const Rays rays(make("pushbroom", {{"duration", "4"}}));
    EXPECT_NEAR(rays.at(0.5, 1.0, 10.0).time.value(), 10.0, tolerance);
    EXPECT_NEAR(rays.at(0.5, 0.25, 10.0).time.value(), 13.0, tolerance);
}

// Zomet et al., equation of parallel orthogonal slits: each coordinate is a perspective projection
// from its own slit, here to the plane at the depth 8.
TEST(CrossedSlits, ProjectsFromOneSlitInEachDirection) {
    for (const double behind : {0.0, 10.0, 1e4}) {
        const Rays rays(make("crossed_slits", {{"behind", std::to_string(behind)}}));
        const double height = 10.0 * rays.height() / rays.width();
        expect_projection(rays, [&](const V3d& p) {
            return V2d(0.5 - p.y * (8.0 + behind) / (p.x + behind) / 10.0,
                       0.5 - p.z * 8.0 / p.x / height);
        });
    }
}

// Along a straight path, this is the street strip to its side.
TEST(PathStrip, IsAStreetStripAlongAStraightPath) {
    for (const double side : {1.0, -1.0}) {
        const Rays rays(make("path_strip", {{"path", "[(0, 0), (3, 0), (10, 0)]"},
                                            {"length", "10"},
                                            {"side", std::to_string(side)}}));
        expect_projection(rays, [&](const V3d& p) {  // distance 4, above 4, below 2
            const double along = side > 0.0 ? p.x / 10.0 : 1.0 - p.x / 10.0;
            return V2d(along, (4.0 - 4.0 * p.z / (side * p.y)) / 6.0);
        });
    }
}

// On a bent path, rays start at even steps of its length, at right angles to it, and the picture is
// not mirrored on either side.
TEST(PathStrip, FollowsABentPath) {
    for (const std::string side : {"1", "-1"}) {
        const Rays rays(make("path_strip", {{"side", side}, {"distance", "1"}}));
        const double pixel = 25.8 / rays.width();
        for (double x = 0.05; x < 1.0; x += 0.1) {
            const Ray ray = rays.at(x, 4.0 / 6.0);
            EXPECT_NEAR(ray.direction.z, 0.0, tolerance);
            EXPECT_NEAR(ray.origin_by_x.length() / pixel, 1.0, 0.01);
            EXPECT_NEAR(ray.origin_by_x ^ ray.direction, 0.0, tolerance);
            EXPECT_GT(step_to_the_right(ray, 0.0), 0.0);
        }
    }
}

}  // namespace balcony::cameras::test::strip_test
