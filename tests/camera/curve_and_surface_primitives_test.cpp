// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Segment, arc, helix; disc, ring, cone, paraboloids and Möbius band against their definitions.

#include <functional>
#include <numbers>
#include <random>

#include "support.hpp"

namespace balcony::camera::curve_and_surface_primitives_test {

namespace {

using std::numbers::pi;
// Co-ordinates here are at most about 30; a formula rounds a handful of times.
constexpr double tolerance = 1e-13;

void at_random_parameters(const std::function<void(double u, double v)>& check) {
    std::mt19937_64 random(72);
    std::uniform_real_distribution<double> any(-3.1, 3.1);
    for (int i = 0; i < 300; ++i) {
        check(any(random), any(random));
    }
}

Vector normal_of(const Sample& s) {
    const Vector n = cross(s.along_u, s.along_v);
    return (1.0 / length(n)) * n;
}

}  // namespace

TEST(Segment, RunsFromEndToEndAndNoFurther) {
    const GeneratorProbe segment(
        object("segment", {{"from", numbers({1.0, 2.0, 3.0})}, {"to", numbers({2.0, 0.0, 7.0})}}));
    expect_near(segment(0.0).point, {1.0, 2.0, 3.0}, 0.0);
    expect_near(segment(1.0).point, {2.0, 0.0, 7.0}, 0.0);
    expect_near(segment(0.25).point, {1.25, 1.5, 4.0}, tolerance);
    for (const double u : {-1e-9, 1.0 + 1e-9, -3.0, 4.0}) {
        EXPECT_FALSE(segment(u).valid) << u;
    }
    EXPECT_TRUE(segment(0.0).valid && segment(1.0).valid);
}

TEST(Arc, RunsFromAngleToAngleAtOneSpeed) {
    const GeneratorProbe arc(object(
        "arc", {{"radius", numbers({2.5})}, {"from", numbers({2.0})}, {"to", numbers({-1.0})}}));
    for (double u = 0.0; u <= 1.0; u += 0.125) {
        const double angle = 2.0 - 3.0 * u;
        expect_near(arc(u).point, {2.5 * std::cos(angle), 2.5 * std::sin(angle), 0.0}, tolerance);
        EXPECT_NEAR(length(arc(u).along_u), 7.5, tolerance);
    }
    EXPECT_TRUE(arc(0.0).valid && arc(1.0).valid);
    EXPECT_FALSE(arc(-1e-9).valid || arc(1.0 + 1e-9).valid);
}

TEST(Helix, RisesByItsPitchInATurnAtAConstantSlope) {
    const GeneratorProbe helix(
        object("helix", {{"radius", numbers({2.0})}, {"pitch", numbers({3.0})}}));
    at_random_parameters([&](double u, double) {
        const Sample s = helix(u);
        EXPECT_NEAR(std::hypot(s.point[0], s.point[1]), 2.0, tolerance);
        expect_near(helix(u + 2.0 * pi).point - s.point, {0.0, 0.0, 3.0}, tolerance);
        EXPECT_NEAR(s.along_u[2] / length(s.along_u), 3.0 / std::hypot(3.0, 4.0 * pi), tolerance);
    });
}

TEST(Ring, LiesBetweenItsCircles) {
    const GeneratorProbe ring(
        object("ring", {{"inner", numbers({2.0})}, {"outer", numbers({5.0})}}));
    at_random_parameters([&](double u, double v) {
        const Sample s = ring(u, v);
        EXPECT_EQ(s.valid, 0.0 <= v && v <= 1.0);
        if (s.valid) {
            EXPECT_NEAR(std::hypot(s.point[0], s.point[1]), 2.0 + 3.0 * v, tolerance);
            EXPECT_NEAR(std::atan2(s.point[1], s.point[0]), u, tolerance);
            EXPECT_EQ(s.point[2], 0.0);
        }
    });
    EXPECT_TRUE(ring(0.0, 0.0).valid && ring(0.0, 1.0).valid);
}

TEST(Disc, ByAngleIsTheRingWithoutAHole) {
    const GeneratorProbe disc(object("disc", {{"radius", numbers({3.0})}}));
    const GeneratorProbe ring(
        object("ring", {{"inner", numbers({0.0})}, {"outer", numbers({3.0})}}));
    at_random_parameters([&](double u, double v) {
        expect_near(disc(u, v).point, ring(u, v).point, tolerance);
        EXPECT_EQ(disc(u, v).valid, ring(u, v).valid);
    });
}

// Squares round the centre become circles, in steps of one size; the square of area 4 becomes the
// disc of area 9 pi evenly.
TEST(Disc, ConcentricKeepsAreasInProportion) {
    const GeneratorProbe disc(
        object("disc", {{"radius", numbers({3.0})}, {"by", std::string("concentric")}}));
    at_random_parameters([&](double u, double v) {
        const Sample s = disc(u / 3.1, v / 3.1);
        EXPECT_NEAR(length(s.point), 3.0 * std::max(std::fabs(u), std::fabs(v)) / 3.1, tolerance);
        expect_near(cross(s.along_u, s.along_v), {0.0, 0.0, 9.0 * pi / 4.0}, 1e-12);
        EXPECT_TRUE(s.valid);
    });
    for (const double end : {-1.0, 1.0}) {  // the corners of the square, from both sides
        expect_near(disc(end, 1.0).point, disc(end, 1.0 - 1e-15).point, tolerance);
        EXPECT_FALSE(disc(1.01 * end, 0.0).valid || disc(0.0, 1.01 * end).valid);
    }
    expect_near(disc(0.0, 0.0).point, {0.0, 0.0, 0.0}, 0.0);
}

TEST(FlatSurfaces, LookUpInEveryParametrisationAndInTheCentre) {
    for (const auto& flat :
         {object("disc"), object("disc", {{"by", std::string("concentric")}}), object("ring")}) {
        Camera::Parts parts;
        parts.name = "flat";
        parts.eye = {range(-1.0, 1.0, 0.0, 1.0), {}, flat, {}};
        parts.look = look("normal");
        const CameraProbe rays(camera(parts), 8.0, 8.0);
        for (const double y : {8.0, 5.0, 0.5}) {  // the first is the centre
            expect_near(rays(4.0, y).direction, {0.0, 0.0, 1.0}, 0.0);
            EXPECT_TRUE(rays(4.0, y).valid);
        }
    }
}

TEST(Cone, NarrowsFromItsRadiusToItsTopAndEndsAtItsApex) {
    const GeneratorProbe cone(
        object("cone", {{"radius", numbers({2.0})}, {"height", numbers({4.0})}}));
    const GeneratorProbe frustum(object(
        "cone", {{"radius", numbers({2.0})}, {"top", numbers({1.0})}, {"height", numbers({3.0})}}));
    at_random_parameters([&](double u, double v) {
        const Vector p = cone(u, v).point;
        EXPECT_NEAR(std::hypot(p[0], p[1]), 2.0 - 0.5 * v, tolerance);
        EXPECT_NEAR(std::atan2(p[1], p[0]), u, tolerance);
        EXPECT_EQ(p[2], v);
        EXPECT_NEAR(std::hypot(frustum(u, v).point[0], frustum(u, v).point[1]), 2.0 - v / 3.0,
                    tolerance);
        // Outwards, and rising by the radius over the height.
        const double across = 4.0 / std::hypot(4.0, 2.0);
        expect_near(normal_of(cone(u, v)),
                    {across * std::cos(u), across * std::sin(u), 0.5 * across}, tolerance);
    });
    EXPECT_TRUE(cone(0.0, 3.999).valid);
    EXPECT_FALSE(cone(0.0, 4.001).valid);
}

TEST(Paraboloid, SolvesItsImplicitEquationInEveryParametrisation) {
    const Given axes{{"a", numbers({2.0})}, {"b", numbers({0.5})}};
    for (const auto& [name, by, sign] :
         {std::tuple("paraboloid", "polar", 1.0), std::tuple("paraboloid", "cartesian", 1.0),
          std::tuple("hyperbolic_paraboloid", "", -1.0)}) {
        Given given = axes;
        given["by"] = std::string(by);
        const GeneratorProbe surface(object(name, given));
        at_random_parameters([&](double u, double v) {
            const Vector p = surface(u, v).point;
            EXPECT_NEAR(p[2], p[0] * p[0] / 4.0 + sign * p[1] * p[1] / 0.25, tolerance);
        });
    }
}

TEST(Paraboloid, HasItsFrontOnTheSideThatItSays) {
    const GeneratorProbe polar(object("paraboloid"));
    const GeneratorProbe cartesian(object("paraboloid", {{"by", std::string("cartesian")}}));
    const GeneratorProbe saddle(object("hyperbolic_paraboloid"));
    at_random_parameters([&](double u, double v) {
        EXPECT_LT(normal_of(polar(u, std::fabs(v) + 0.1))[2], 0.0);
        EXPECT_GT(normal_of(cartesian(u, v))[2], 0.0);
        EXPECT_GT(normal_of(saddle(u, v))[2], 0.0);
    });
}

TEST(MobiusBand, ComesBackTurnedOverByHalfTurns) {
    for (const double half_turns : {0.0, 1.0, 2.0, 3.0}) {
        const GeneratorProbe band(object(
            "mobius_band", {{"radius", numbers({2.0})}, {"half_turns", numbers({half_turns})}}));
        const double flip = std::fmod(half_turns, 2.0) == 0.0 ? 1.0 : -1.0;
        at_random_parameters([&](double u, double v) {
            const double across = v / 3.0;
            const Sample s = band(u, across);
            const Sample after = band(u + 2.0 * pi, flip * across);
            expect_near(after.point, s.point, tolerance);
            expect_near(normal_of(after), flip * normal_of(s), 1e-12);
            // v is the distance from the middle circle, on a line through the axis' plane of u.
            const Vector middle{2.0 * std::cos(u), 2.0 * std::sin(u), 0.0};
            EXPECT_NEAR(length(s.point - middle), std::fabs(across), tolerance);
        });
    }
}

}  // namespace balcony::camera::curve_and_surface_primitives_test
