// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The Panini projection against its published formula, and mirrors against the law of conics.

#include <random>

#include "support.hpp"

namespace balcony::camera::panini_and_mirrors_test {

TEST(Panini, IsThePublishedProjection) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    for (const double d : {0.0, 0.5, 1.0, 3.0}) {
        for (const double s : {0.0, 0.4, 1.0}) {
            const GeneratorProbe probe(
                object("panini", {{"d", numbers({d})}, {"s", numbers({s})}}));
            for (int i = 0; i < 200; ++i) {
                const double longitude = part(random) * (s == 0.0 && d == 1.0 ? 2.6 : 1.2);
                const double latitude = part(random);
                const double scale = (d + 1.0) / (d + std::cos(longitude));
                const double u = scale * std::sin(longitude);
                const double v = std::tan(latitude) * ((1.0 - s) * scale + s / std::cos(longitude));
                const Sample at = probe(u, v);
                EXPECT_TRUE(at.valid);
                expect_near(at.point,
                            {std::cos(longitude) * std::cos(latitude),
                             std::sin(longitude) * std::cos(latitude), std::sin(latitude)},
                            1e-12);
            }
        }
    }
    // With s = 1, a horizontal line across the view is straight: the image of (1, y, z) is at v =
    // z.
    const GeneratorProbe straight(object("panini", {{"d", numbers({1.0})}, {"s", numbers({1.0})}}));
    for (const double u : {0.0, 0.5, 1.0, 1.5}) {
        const Vector p = straight(u, 0.7).point;
        EXPECT_NEAR(p[2] / p[0], 0.7, 1e-14) << u;
    }
    // With d = 3, the image of the circle ends at (d + 1)/√(d² − 1).
    const GeneratorProbe probe(object("panini", {{"d", numbers({3.0})}}));
    EXPECT_TRUE(probe(1.4142, 0.0).valid);
    EXPECT_FALSE(probe(1.4143, 0.0).valid);
}

TEST(Mirrors, LieOnTheirQuadricsAheadOfTheCamera) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> part(-0.5, 0.5);
    const GeneratorProbe hyperbolic(
        object("hyperbolic_mirror", {{"a", numbers({0.6})}, {"b", numbers({0.8})}}));
    const GeneratorProbe spherical(
        object("spherical_mirror", {{"radius", numbers({0.9})}, {"distance", numbers({1.2})}}));
    const GeneratorProbe parabolic(object("parabolic_mirror", {{"radius", numbers({0.7})}}));
    for (int i = 0; i < 500; ++i) {
        const double u = part(random);
        const double v = part(random);
        const Vector h = hyperbolic(u, v).point;
        EXPECT_NEAR(length(h) - length(h - Vector{2.0, 0.0, 0.0}), 1.2, 1e-13);
        expect_near((1.0 / h[0]) * h, {1.0, u, v}, 1e-14);
        const Vector s = spherical(u, v).point;
        EXPECT_NEAR(length(s - Vector{1.2, 0.0, 0.0}), 0.9, 1e-13);
        expect_near((1.0 / s[0]) * s, {1.0, u, v}, 1e-14);
        EXPECT_LT(s[0], 1.2);
        // As far from the focus as from the directrix x = -h.
        const Vector p = parabolic(u, v).point;
        EXPECT_NEAR(length(p), p[0] + 0.7, 1e-14);
        EXPECT_EQ(p[1], u);
        EXPECT_EQ(p[2], v);
    }
    EXPECT_FALSE(hyperbolic(1.4, 0.0).valid);  // beyond the asymptotes: 0.6 √(1 + q) >= 1
    EXPECT_FALSE(spherical(1.2, 0.0).valid);   // 0.81 (1 + q) <= 1.44 q
    EXPECT_FALSE(try_stage(StageKind::object_generator, "spherical_mirror",
                           {{"radius", numbers({2.0})}, {"distance", numbers({1.0})}}));
}

// Single viewpoint: the rays after the reflection in a conic mirror come from its inner focus.
TEST(Mirrors, ReflectAsIfFromTheirFocus) {
    struct Case {
        ObjectGeneratorPointer mirror, seen_from;
        Vector focus;
    };
    const std::array cases{
        Case{object("hyperbolic_mirror", {{"a", numbers({0.6})}, {"b", numbers({0.8})}}),
             object("point", {{"x", numbers({0.0})}, {"y", numbers({0.0})}, {"z", numbers({0.0})}}),
             {2.0, 0.0, 0.0}},
        Case{object("parabolic_mirror", {{"radius", numbers({0.7})}}),
             object("plane", {{"at", numbers({-3.0, 0.0, 0.0})},
                              {"along_u", numbers({0.0, 1.0, 0.0})},
                              {"along_v", numbers({0.0, 0.0, 1.0})}}),
             {0.0, 0.0, 0.0}}};
    for (const Case& one : cases) {
        const Path eye{range(0.8, -0.8, -0.8, 0.8), {}, one.mirror, {}};
        const Path toward{range(0.8, -0.8, -0.8, 0.8), {}, one.seen_from, {}};
        const CameraProbe rays(camera({.name = "mirror",
                                       .arrangers = {},
                                       .eye = eye,
                                       .toward = toward,
                                       .look = look("reflect")}),
                               40.0, 40.0);
        for (double x = 0.5; x < 40.0; x += 3.0) {
            for (double y = 0.5; y < 40.0; y += 3.0) {
                const Ray ray = rays(x, y);
                ASSERT_TRUE(ray.valid);
                const Vector from_focus = ray.origin - one.focus;
                expect_near(ray.direction, (1.0 / length(from_focus)) * from_focus, 1e-13);
            }
        }
    }
}

}  // namespace balcony::camera::panini_and_mirrors_test
