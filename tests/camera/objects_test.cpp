// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The primitives against their textbook equations.

#include <functional>
#include <random>

#include "support.hpp"

namespace balcony::camera::objects_test {

namespace {

// Co-ordinates here are at most about 30; a formula rounds a handful of times.
constexpr double tolerance = 1e-13;

void at_random_parameters(const std::function<void(double u, double v)>& check) {
    std::mt19937_64 random(71);
    std::uniform_real_distribution<double> any(-3.1, 3.1);
    for (int i = 0; i < 300; ++i) {
        check(any(random), any(random));
    }
}

}  // namespace

TEST(Point, IsConstant) {
    const GeneratorProbe point(
        object("point", {{"x", numbers({1.0})}, {"y", numbers({2.0})}, {"z", numbers({-3.0})}}));
    at_random_parameters([&](double u, double v) {
        expect_near(point(u, v).point, {1.0, 2.0, -3.0}, 0.0);
    });
}

TEST(Line, StartsAtItsPointAndFollowsItsStep) {
    const GeneratorProbe line(
        object("line", {{"at", numbers({1.0, 2.0, 3.0})}, {"along", numbers({0.5, -1.0, 2.0})}}));
    at_random_parameters([&](double u, double v) {
        expect_near(line(u, v).point, {1.0 + 0.5 * u, 2.0 - u, 3.0 + 2.0 * u}, tolerance);
    });
}

TEST(Circle, IsAtItsRadiusAndAngle) {
    const GeneratorProbe circle(object("circle", {{"radius", numbers({2.5})}}));
    at_random_parameters([&](double u, double v) {
        const Vector p = circle(u, v).point;
        EXPECT_NEAR(std::hypot(p[0], p[1]), 2.5, tolerance);
        EXPECT_NEAR(std::atan2(p[1], p[0]), u, tolerance);
        EXPECT_EQ(p[2], 0.0);
    });
}

TEST(Plane, IsSpannedByItsSteps) {
    const GeneratorProbe plane(object("plane", {{"at", numbers({1.0, 2.0, 3.0})},
                                                {"along_u", numbers({0.5, -1.0, 2.0})},
                                                {"along_v", numbers({3.0, 0.0, 1.0})}}));
    at_random_parameters([&](double u, double v) {
        expect_near(plane(u, v).point, {1.0 + 0.5 * u + 3.0 * v, 2.0 - u, 3.0 + 2.0 * u + v},
                    tolerance);
    });
}

TEST(Sphere, IsAtItsRadiusLongitudeAndLatitude) {
    const GeneratorProbe sphere(object("sphere", {{"radius", numbers({3.0})}}));
    at_random_parameters([&](double u, double v) {
        const double latitude = v / 2.0;
        const Vector p = sphere(u, latitude).point;
        EXPECT_NEAR(length(p), 3.0, tolerance);
        EXPECT_NEAR(std::atan2(p[1], p[0]), u, 1e-12);       // near a pole the angle loses digits
        EXPECT_NEAR(std::asin(p[2] / 3.0), latitude, 1e-7);  // and at it the arcsine loses half
    });
}

TEST(Cylinder, IsAtItsRadiusAngleAndHeight) {
    const GeneratorProbe cylinder(object("cylinder", {{"radius", numbers({2.0})}}));
    at_random_parameters([&](double u, double v) {
        const Vector p = cylinder(u, v).point;
        EXPECT_NEAR(std::hypot(p[0], p[1]), 2.0, tolerance);
        EXPECT_NEAR(std::atan2(p[1], p[0]), u, tolerance);
        EXPECT_EQ(p[2], v);
    });
}

TEST(Torus, SolvesItsImplicitEquation) {
    const GeneratorProbe torus(
        object("torus", {{"major", numbers({5.0})}, {"minor", numbers({2.0})}}));
    at_random_parameters([&](double u, double v) {
        const Vector p = torus(u, v).point;
        const double from_tube = std::hypot(p[0], p[1]) - 5.0;
        EXPECT_NEAR(from_tube * from_tube + p[2] * p[2], 4.0, tolerance);
        EXPECT_NEAR(std::atan2(p[1], p[0]), u, tolerance);
        EXPECT_NEAR(std::atan2(p[2], from_tube), v, tolerance);
    });
}

TEST(SphericalProduct, IsTheProductOfItsCurves) {
    const auto g = object("superellipse", {{"a", numbers({2.0})}, {"gamma", numbers({0.5})}});
    const auto h = object("superhyperbola", {{"b", numbers({3.0})}});
    const GeneratorProbe product(object("product", {{"g", g}, {"h", h}}));
    const GeneratorProbe horizontal(g);
    const GeneratorProbe vertical(h);
    at_random_parameters([&](double u, double v) {
        const Vector p = horizontal(u).point;
        const Vector q = vertical(v).point;
        expect_near(product(u, v).point, {p[0] * q[0], p[1] * q[0], q[1]}, tolerance);
    });
}

TEST(SphericalProduct, OfTwoCirclesIsASphere) {
    const auto circle = object("circle");
    const GeneratorProbe product(object("product", {{"g", circle}, {"h", circle}}));
    const GeneratorProbe sphere(object("sphere"));
    at_random_parameters([&](double u, double v) {
        expect_near(product(u, v).point, sphere(u, v).point, tolerance);
    });
}

TEST(SphericalProduct, TakesOnlyPlaneCurves) {
    const auto upright = object("line", {{"along", numbers({0.0, 0.0, 1.0})}});
    for (const std::string_view factor : {"g", "h"}) {
        const auto made = try_stage(StageKind::object_generator, "product", {{factor, upright}});
        ASSERT_FALSE(made);
        EXPECT_NE(made.diagnostics.front().message.find("plane curve"), std::string::npos);
    }
}

// The normal rule takes the cross product of the tangents, which must point outward.
TEST(Normals, PointOutwardOnClosedObjects) {
    const auto ellipse = object("superellipse", {{"a", numbers({3.0})}, {"b", numbers({2.0})}});
    const GeneratorProbe sphere(object("sphere"));
    const GeneratorProbe ellipsoid(object(
        "product", {{"g", object("superellipse", {{"b", numbers({0.4})}})}, {"h", ellipse}}));
    const GeneratorProbe cylinder(object("cylinder"));
    const GeneratorProbe torus(
        object("torus", {{"major", numbers({5.0})}, {"minor", numbers({2.0})}}));
    at_random_parameters([&](double u, double v) {
        const auto outward = [](const Sample& s, const Vector& from) {
            return dot(cross(s.along_u, s.along_v), s.point - from) > 0.0;
        };
        EXPECT_TRUE(outward(sphere(u, v / 2.0), {0.0, 0.0, 0.0}));
        EXPECT_TRUE(outward(ellipsoid(u, v / 2.0), {0.0, 0.0, 0.0}));
        EXPECT_TRUE(outward(cylinder(u, v), {0.0, 0.0, v}));
        EXPECT_TRUE(outward(torus(u, v), {5.0 * std::cos(u), 5.0 * std::sin(u), 0.0}));
    });
}

}  // namespace balcony::camera::objects_test
