// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The cameras of "Ray Tracing with Extended Cameras" (H. Löffelmann and E. Gröller, 1996) against
// its formulas, or against the implicit equations of its surfaces.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support.hpp"

namespace balcony::cameras::test::paper_test {

namespace {

using std::numbers::pi;

const std::vector<double> fractions{0.03, 0.14, 0.27, 0.36, 0.46, 0.58, 0.71, 0.83, 0.98};

double power_with_sign(double x, double exponent) {
    return std::copysign(std::pow(std::abs(x), exponent), x);
}

struct HalfAxes {
    double a, b, c;
};

// Rays of a superhyperboloid of two sheets, |x/a|^e - |y/b|^e - |z/c|^e = 1 with e = 2/gamma, whose
// sheet x > 0 has its vertex at the origin of the camera and bends away from where it looks, so
// that its x axis is opposite to that of the camera.
void expect_superhyperboloid(const std::string& name, const HalfAxes& axes) {
    constexpr double unit = 0.8;
    constexpr double e = 8.0;
    const Rays rays(name, {{"unit", "0.8"}});
    const double size = unit / (2.0 * axes.b);
    for (const double x : fractions) {
        for (const double y : fractions) {
            const Ray ray = rays.at(x, y);
            ASSERT_TRUE(ray.valid) << x << ' ' << y;
            const V3d q(axes.a - ray.origin.x / size, -ray.origin.y / size, ray.origin.z / size);
            const double left =
                std::pow(q.x / axes.a, e) - std::pow(q.y / axes.b, e) - std::pow(q.z / axes.c, e);
            // Differences of numbers of this size.
            const double scale = std::pow(q.x / axes.a, e);
            EXPECT_NEAR(left, 1.0, 1e-12 * e * scale) << x << ' ' << y;
            const V3d gradient(power_with_sign(q.x / axes.a, e - 1.0) / axes.a,
                               -power_with_sign(q.y / axes.b, e - 1.0) / axes.b,
                               -power_with_sign(q.z / axes.c, e - 1.0) / axes.c);
            expect_near(ray.direction, V3d(gradient.x, gradient.y, -gradient.z).normalized(), 1e-7);
        }
    }
}

}  // namespace

TEST(PaperSuperhyperbolic, OneLooksAlongTheNormalsOfItsImplicitSurface) {
    expect_superhyperboloid("superhyperbolic_one", {45.0, 25.0, 25.0});
}

// The flat part, between parameters of -1 and 1, is as wide as stated and appears undistorted.
TEST(PaperSuperhyperbolic, OneEnlargesItsMiddle) {
    const Rays rays("superhyperbolic_one", {{"unit", "3"}});
    const auto at = [&](double u, double v) {
        return rays.at(0.5 + u / 4.3, 0.5 - v / 4.8).origin;
    };
    // Where |u| = 1 and v = 0, y = b.
    EXPECT_NEAR(at(1.0, 0.0).y, -1.5, 1e-9);
    EXPECT_NEAR(at(-1.0, 0.0).y, 1.5, 1e-9);
    EXPECT_NEAR(at(0.0, 1.0).z, 1.5, 1e-9);
    EXPECT_NEAR(at(0.5, 0.0).y, 0.5 * at(1.0, 0.0).y, 1e-9);
    EXPECT_GE(rays.at(0.5 + 0.7 / 4.3, 0.5).direction.x, 0.99);
}

TEST(PaperSuperhyperbolic, TwoLooksAlongTheNormalsOfItsImplicitSurface) {
    expect_superhyperboloid("superhyperbolic_two", {40.5, 22.5, 22.5});
}

// sinh^gamma u is 1/2 where sinh u = 2^-4: a strip of 3.6 % of the width holds half of the flat
// part.
TEST(PaperSuperhyperbolic, TwoHurriesPastItsMiddle) {
    const Rays rays("superhyperbolic_two", {{"unit", "2"}});
    const double u = std::asinh(std::pow(0.5, 4.0));
    EXPECT_NEAR(rays.at(0.5 + u / 3.5, 0.5).origin.y, -0.5, 1e-9);
    EXPECT_NEAR(rays.at(0.5 - u / 3.5, 0.5).origin.y, 0.5, 1e-9);
}

// As `pinhole` beyond the radius; `strength` times as large in the middle of the zoom.
TEST(PaperBalcony, IsAPinholeWithAnEnlargedPart) {
    const Rays rays("balcony", {{"at_yaw", "10deg"}, {"at_pitch", "-5deg"}, {"radius", "0.4"}});
    const double half = std::tan(40.0 * degree);
    const double height = half * rays.height() / rays.width();
    const double at_u = std::tan(10.0 * degree);
    const double at_v = std::tan(-5.0 * degree) / std::cos(10.0 * degree);
    const auto plane = [](const Ray& ray) {
        return V2d(ray.direction.y / ray.direction.x, ray.direction.z / ray.direction.x);
    };
    const V2d middle(0.5 - at_u / (2.0 * half), 0.5 - at_v / (2.0 * height));
    const V3d toward(std::cos(-5.0 * degree) * std::cos(10.0 * degree),
                     std::cos(-5.0 * degree) * std::sin(10.0 * degree), std::sin(-5.0 * degree));
    expect_near(rays.at(middle.x, middle.y).direction, toward, 1e-12);
    constexpr double step = 1e-5;
    const V2d by_x =
        (plane(rays.at(middle.x + step, middle.y)) - plane(rays.at(middle.x - step, middle.y))) /
        (2.0 * step);
    EXPECT_NEAR(by_x.x, -2.0 * half / 3.0, 1e-6);
    EXPECT_NEAR(by_x.y, 0.0, 1e-6);
    int beyond = 0;
    for (const double x : fractions) {
        for (const double y : fractions) {
            const V2d expected((1.0 - 2.0 * x) * half, (1.0 - 2.0 * y) * height);
            if ((expected - V2d(at_u, at_v)).length() > 0.4 * half) {
                ++beyond;
                EXPECT_LE((plane(rays.at(x, y)) - expected).length(), 1e-12) << x << ' ' << y;
            }
        }
    }
    EXPECT_GE(beyond, 40);
}

// The formula of Acquisto and Gröller with a Gaussian: points p of the plane through the centre of
// interest c go to p + strength exp(-|p - c|^2/radius^2) (c - p).
TEST(PaperCoin, AttractsRaysToAPointOfTheScene) {
    const V3d eye(1.0, 2.0, 1.5);
    const V3d coin(4.0, 2.5, 1.2);
    const Rays rays("coin", {{"px", "1"},
                             {"py", "2"},
                             {"pz", "1.5"},
                             {"coin_x", "4"},
                             {"coin_y", "2.5"},
                             {"coin_z", "1.2"},
                             {"radius", "0.9"},
                             {"strength", "0.6"}});
    const double distance = (coin - eye).length();
    const double half = std::tan(40.0 * degree);
    for (const double x : fractions) {
        for (const double y : fractions) {
            const V3d p = eye + V3d(1.0, (1.0 - 2.0 * x) * half,
                                    (1.0 - 2.0 * y) * half * rays.height() / rays.width()) *
                                    distance;
            const double pull = 0.6 * std::exp(-(p - coin).length2() / 0.81);
            const Ray ray = rays.at(x, y);
            expect_near(ray.origin, eye, 1e-12);
            expect_near(ray.direction, (p + (coin - p) * pull - eye).normalized(), 1e-12);
        }
    }
}

// Origins on a tilted circle, directions at right angles to it: a quarter of a torus is seen.
TEST(PaperTorusFlight, FollowsACircleThroughATorus) {
    const Rays rays("torus_flight", {{"radius", "3"}, {"tilt", "25deg"}, {"pz", "7"}});
    const V3d axis(0.0, std::sin(25.0 * degree), std::cos(25.0 * degree));
    double climbed = -10.0;
    for (const double x : fractions) {
        const V3d origin = rays.at(x, 0.5).origin - V3d(0, 0, 7);
        EXPECT_NEAR(origin.length(), 3.0, 1e-12);
        EXPECT_NEAR(origin.dot(axis), 0.0, 1e-12);
        EXPECT_GT(origin.z, climbed);
        climbed = origin.z;
        const V3d outward = origin.normalized();
        for (const double y : fractions) {
            const Ray ray = rays.at(x, y);
            const double angle = (0.5 - y) * 100.0 * degree;
            expect_near(ray.origin, origin + V3d(0, 0, 7), 1e-12);
            expect_near(ray.direction, outward * std::cos(angle) + axis * std::sin(angle), 1e-12);
        }
    }
    EXPECT_GT(rays.at(0.0, 0.5).origin.y, 2.7);
    EXPECT_LT(rays.at(1.0, 0.5).origin.y, -2.7);
}

// The line and the cylinder around it; with the overshoot, the look goes back and forth once.
TEST(PaperSwing, SwingsBackOnItsWay) {
    const Rays rays("swing", {{"length", "6"}, {"radius", "0.7"}});
    int turns = 0;
    double before = 0.0;
    double last = 0.0;
    for (int k = 0; k <= 400; ++k) {
        const double u = -1.0 + 2.0 * k / 400.0;
        const double seen = u * (1.0 - 1.6 * std::exp(-4.0 * u * u));
        const double angle = 30.0 * degree;
        const Ray ray = rays.at(k / 400.0, 0.25);
        const V3d eye(0.0, -3.0 * u, 0.0);
        const V3d through(0.7 * std::cos(angle), -3.0 * seen, 0.7 * std::sin(angle));
        expect_near(ray.origin, eye, 1e-12);
        expect_near(ray.direction, (through - eye).normalized(), 1e-12);
        // Where the ray meets the cylinder.
        const double place =
            ray.origin.y + ray.direction.y * 0.7 / std::hypot(ray.direction.x, ray.direction.z);
        if (k > 1 && (place - last) * (last - before) < 0.0) {
            ++turns;
        }
        before = last;
        last = place;
    }
    EXPECT_EQ(turns, 2);
}

}  // namespace balcony::cameras::test::paper_test
