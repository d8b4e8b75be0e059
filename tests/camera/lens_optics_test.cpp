// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Toroidal and cylindrical surfaces of lenses: where rays meet them, and their normals.

#include "camera/lenses/lens_optics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "balcony/prescription.hpp"

namespace balcony::camera::lens_optics_test {
namespace {

using Vector = std::array<double, 3>;

/// Rays through the plane of the vertex, up to 6 mm from it and 37 degrees from the axis.
template <class Check>
void at_rays(const Check& check) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const double a = 0.42 * uniform(random);
        const double b = 0.42 * uniform(random);
        check(std::array{4.2 * uniform(random), 4.2 * uniform(random)},
              Vector{a, b, std::sqrt(1.0 - a * a - b * b)});
    }
}

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double length(const Vector& a) { return std::sqrt(dot(a, a)); }

/// The point and the normal of the surface must lie on a ray and be of unit length.
template <class Formula>
void expect_meetings(const LensSurface& s, const Formula& toward_axis) {
    at_rays([&](const std::array<double, 2>& from, const Vector& d) {
        const Meeting<double> at = meeting_of(s, from, d);
        ASSERT_TRUE(at.exists);
        const double t = at.point[2] / d[2];
        EXPECT_NEAR(at.point[0], from[0] + t * d[0], 1e-12);
        EXPECT_NEAR(at.point[1], from[1] + t * d[1], 1e-12);
        EXPECT_NEAR(length(at.normal), 1.0, 1e-12);
        EXPECT_NEAR(dot(at.normal, d), at.cosine, 1e-12);
        // From the point to where its normal ends: as long as the radius, and along the normal.
        const auto [radius, to] = toward_axis(at.point);
        const Vector along{to[0] - at.point[0], to[1] - at.point[1], to[2] - at.point[2]};
        EXPECT_NEAR(length(along), std::abs(radius), 1e-11);
        EXPECT_NEAR(std::abs(dot(along, at.normal)), std::abs(radius), 1e-11);
    });
}

struct Radius {
    double length;
    Vector end;
};

}  // namespace

TEST(ToroidalSurface, WithEqualRadiiIsASphere) {
    for (const double curvature : {0.08, -0.05, 0.001}) {
        const LensSurface sphere{.curvature = curvature};
        const LensSurface toroid{.curvature = curvature, .curvature_x = curvature};
        at_rays([&](const std::array<double, 2>& from, const Vector& d) {
            const Meeting<double> a = meeting_of(sphere, from, d);
            const Meeting<double> b = meeting_of(toroid, from, d);
            ASSERT_TRUE(a.exists && b.exists);
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_NEAR(a.point[i], b.point[i], 1e-12);
                EXPECT_NEAR(a.normal[i], b.normal[i], 1e-12);
            }
            EXPECT_NEAR(a.cosine, b.cosine, 1e-12);
            EXPECT_NEAR(sphere.sag(from[0], from[1]), toroid.sag(from[0], from[1]), 1e-12);
        });
    }
}

// The normal goes through the centre of the upright circle, which is on a level circle around the
// line that the surface is turned about. z is towards the scene, so that centres are at -radius.
TEST(ToroidalSurface, IsAnUprightCircleTurned) {
    const double level = 14.0;
    for (const double upright : {30.0, 9.0, -25.0}) {
        expect_meetings(
            {.curvature = 1.0 / upright, .curvature_x = 1.0 / level}, [&](const Vector& p) {
                const double from_line = std::hypot(p[0], p[2] + level);
                const double to_center = (level - upright) / from_line;
                return Radius{upright, {to_center * p[0], 0.0, to_center * (p[2] + level) - level}};
            });
    }
}

TEST(ToroidalSurface, WithAFlatMeridianIsACylinder) {
    for (const double radius : {12.0, -20.0}) {
        expect_meetings({.curvature = 1.0 / radius, .curvature_x = 0.0}, [&](const Vector& p) {
            return Radius{radius, {p[0], 0.0, -radius}};
        });
        expect_meetings({.curvature = 0.0, .curvature_x = 1.0 / radius}, [&](const Vector& p) {
            return Radius{radius, {0.0, p[1], -radius}};
        });
    }
}

// The slopes by central differences: h² times third derivatives of the surfaces, of some 1e-3 per
// mm², is 1e-9, and rounding of 1e-16 over h is less.
TEST(ToroidalSurface, HasTheSlopesOfItsHeight) {
    constexpr double h = 1e-3;
    for (const LensSurface& s :
         {LensSurface{
              .curvature = 0.05, .conic = -2.0, .aspheric = {1e-4, 1e-6}, .curvature_x = 0.03},
          LensSurface{.curvature = -0.04, .conic = 0.5, .curvature_x = 0.06},
          LensSurface{.curvature = 0.02, .aspheric = {2e-4}, .curvature_x = 0.0}}) {
        at_rays([&](const std::array<double, 2>& at, const Vector&) {
            const auto [x, y] = at;
            const Height<double> here = height_at(s, x, y);
            ASSERT_TRUE(here.exists);
            EXPECT_NEAR(here.by_x, (s.sag(x - h, y) - s.sag(x + h, y)) / (2.0 * h), 1e-8);
            EXPECT_NEAR(here.by_y, (s.sag(x, y - h) - s.sag(x, y + h)) / (2.0 * h), 1e-8);
        });
    }
}

// Where the turned curve is a circle of the level meridian, whose points are 1/curvature_x from the
// line: beyond it there is none.
TEST(ToroidalSurface, EndsWithItsCircles) {
    const LensSurface s{.curvature = 0.02, .curvature_x = 0.1};
    EXPECT_NEAR(s.sag(8.0, 0.0), 10.0 - 6.0, 1e-12);
    EXPECT_FALSE(std::isfinite(s.sag(10.1, 0.0)));
    EXPECT_TRUE(std::isfinite(s.sag(0.0, 10.1)));
}

}  // namespace balcony::camera::lens_optics_test
