// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Superconics against their implicit equations, in every parametrisation.

#include <numbers>

#include "support.hpp"

namespace balcony::camera::superconics_test {

namespace {

using std::numbers::pi;
constexpr std::array gammas{0.05, 0.25, 0.3, 0.5, 1.0, 1.5, 2.0};

Given parts(double gamma, std::string_view by) {
    return {{"a", numbers({3.0})},
            {"b", numbers({0.5})},
            {"gamma", numbers({gamma})},
            {"by", std::string(by)}};
}

// x^e turns a relative error r of x into e r; e is at most 40, and r a few roundings.
double tolerance(double gamma) { return 1e-14 * (1.0 + 2.0 / gamma); }

double powers(const Vector& p, double gamma, double sign) {
    const double e = 2.0 / gamma;
    return std::pow(std::fabs(p[0] / 3.0), e) + sign * std::pow(std::fabs(p[1] / 0.5), e);
}

}  // namespace

TEST(Superellipse, SolvesItsImplicitEquationInEveryParametrisation) {
    for (const std::string_view by : {"angle_centre", "trigonometric", "arc_length"}) {
        for (const double gamma : gammas) {
            const GeneratorProbe curve(object("superellipse", parts(gamma, by)));
            for (double u = -7.0; u < 7.0; u += 0.0731) {
                const Sample s = curve(u);
                EXPECT_TRUE(s.valid);
                EXPECT_NEAR(powers(s.point, gamma, 1.0), 1.0, tolerance(gamma))
                    << by << ' ' << gamma;
                EXPECT_EQ(s.point[2], 0.0);
            }
        }
    }
}

TEST(Superellipse, AngleCentreIsAtItsAngle) {
    for (const double gamma : gammas) {
        const GeneratorProbe curve(object("superellipse", parts(gamma, "angle_centre")));
        for (double u = -3.1; u < 3.1; u += 0.0731) {
            const Vector p = curve(u).point;
            EXPECT_NEAR(std::atan2(p[1] / 0.5, p[0] / 3.0), u, 1e-14);
        }
    }
}

TEST(Superellipse, TrigonometricIsTheSignedPowerOfTheCircle) {
    for (const double gamma : gammas) {
        const GeneratorProbe curve(object("superellipse", parts(gamma, "trigonometric")));
        for (double u = -3.1; u < 3.1; u += 0.0731) {
            const auto power = [&](double x) {
                return std::copysign(std::pow(std::fabs(x), gamma), x);
            };
            expect_near(curve(u).point, {3.0 * power(std::cos(u)), 0.5 * power(std::sin(u)), 0.0},
                        1e-14);
        }
    }
}

TEST(Superellipse, OfGammaOneIsTheEllipseSmoothOnItsAxes) {
    for (const std::string_view by : {"angle_centre", "trigonometric", "arc_length"}) {
        const Sample s = GeneratorProbe(object("superellipse", parts(1.0, by)))(0.0);
        expect_near(s.point, {3.0, 0.0, 0.0}, 1e-14);
        EXPECT_GT(length(s.along_u), 0.1) << by;
    }
}

TEST(Superhyperbola, SolvesItsImplicitEquationInEveryParametrisation) {
    const std::pair<std::string_view, double> ends[] = {
        {"cartesian", 4.0}, {"hyperbolic", 2.0}, {"trigonometric", 1.5}, {"angle_centre", 0.78}};
    for (const auto& [by, end] : ends) {
        for (const double gamma : gammas) {
            const GeneratorProbe curve(object("superhyperbola", parts(gamma, by)));
            for (double u = -end; u <= end; u += end / 40.0) {
                const Sample s = curve(u);
                EXPECT_TRUE(s.valid) << by << ' ' << u;
                EXPECT_GT(s.point[0], 0.0);
                // The difference of two powers is as exact as the larger one is.
                const double larger = std::pow(s.point[0] / 3.0, 2.0 / gamma);
                EXPECT_NEAR(powers(s.point, gamma, -1.0), 1.0, tolerance(gamma) * larger)
                    << by << ' ' << gamma << ' ' << u;
            }
        }
    }
}

TEST(Superhyperbola, IsParametrisedAsItSays) {
    const GeneratorProbe cartesian(object("superhyperbola", parts(0.25, "cartesian")));
    const GeneratorProbe hyperbolic(object("superhyperbola", parts(0.25, "hyperbolic")));
    const GeneratorProbe trigonometric(object("superhyperbola", parts(0.25, "trigonometric")));
    const GeneratorProbe angle_centre(object("superhyperbola", parts(0.25, "angle_centre")));
    for (double u = 0.05; u < 0.75; u += 0.1) {
        EXPECT_NEAR(cartesian(u).point[1] / 0.5, u, 1e-15);
        EXPECT_NEAR(hyperbolic(u).point[0] / 3.0, std::pow(std::cosh(u), 0.25), 1e-15);
        EXPECT_NEAR(trigonometric(u).point[1] / 0.5, std::pow(std::tan(u), 0.25), 1e-15);
        const Vector p = angle_centre(u).point;
        EXPECT_NEAR(std::atan2(p[1] / 0.5, p[0] / 3.0), u, 1e-15);
    }
}

TEST(Superhyperbola, EndsWhereItsParametrisationDoes) {
    for (const double gamma : gammas) {
        const GeneratorProbe trigonometric(object("superhyperbola", parts(gamma, "trigonometric")));
        const GeneratorProbe angle_centre(object("superhyperbola", parts(gamma, "angle_centre")));
        const double margin = 1e-9;
        for (const double sign : {-1.0, 1.0}) {
            EXPECT_TRUE(trigonometric(sign * (pi / 2.0 - margin)).valid);
            EXPECT_FALSE(trigonometric(sign * (pi / 2.0 + margin)).valid);
            EXPECT_FALSE(trigonometric(sign * pi).valid);
            EXPECT_TRUE(angle_centre(sign * (pi / 4.0 - margin)).valid);
            EXPECT_FALSE(angle_centre(sign * (pi / 4.0 + margin)).valid);
            EXPECT_FALSE(angle_centre(sign * pi).valid);
        }
    }
}

}  // namespace balcony::camera::superconics_test
