// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The cameras of the family `fisheye` against the published formulas r(angle), which they invert.

#include <functional>

#include "support.hpp"

namespace balcony::cameras::test::fisheye_test {

namespace {

using Formula = std::function<double(double angle)>;

/// `formula` gives the distance from the centre of the picture, up to a factor.
void expect_formula(const std::string& name, double fov, const Formula& formula) {
    const Rays camera(name, {{"fov", std::to_string(fov) + "deg"}});
    const double edge = formula(0.5 * fov * degree);
    for (double part = 0.02; part < 1.0; part += 0.07) {
        const double angle = part * 0.5 * fov * degree;
        const double r = 0.5 * formula(angle) / edge;
        for (double around = 0.0; around < 6.2; around += 0.5) {
            const Ray ray = camera.at(0.5 + r * std::cos(around), 0.5 - r * std::sin(around));
            ASSERT_TRUE(ray.valid) << name;
            expect_near(ray.origin, V3d(0.0), 1e-12);
            expect_near(ray.direction,
                        {std::cos(angle), -std::sin(angle) * std::cos(around),
                         std::sin(angle) * std::sin(around)},
                        1e-9);
        }
    }
    expect_near(camera.at(0.5, 0.5).direction, {1.0, 0.0, 0.0}, 1e-9);
}

}  // namespace

TEST(Fisheye, EquisolidIsTwiceTheSineOfHalfTheAngle) {
    for (const double fov : {90.0, 180.0, 300.0}) {
        expect_formula("fisheye_equisolid", fov, [](double a) { return 2.0 * std::sin(a / 2.0); });
    }
}

TEST(Fisheye, StereographicIsTwiceTheTangentOfHalfTheAngle) {
    for (const double fov : {90.0, 180.0, 300.0}) {
        expect_formula("fisheye_stereographic", fov,
                       [](double a) { return 2.0 * std::tan(a / 2.0); });
    }
}

TEST(Fisheye, OrthographicIsTheSineOfTheAngle) {
    for (const double fov : {90.0, 179.0}) {
        expect_formula("fisheye_orthographic", fov, [](double a) { return std::sin(a); });
    }
}

TEST(Fisheye, ThobyIsItsMeasuredSine) {
    for (const double fov : {90.0, 180.0}) {
        expect_formula("fisheye_thoby", fov, [](double a) { return 1.47 * std::sin(0.713 * a); });
    }
}

TEST(Fisheye, PolynomialGivesTheAngleOfADistance) {
    const Rays camera(
        "fisheye_polynomial",
        {{"k1", "1.2"}, {"k2", "-0.1"}, {"k3", "0.05"}, {"k4", "0.02"}, {"k5", "-0.03"}});
    for (double r = 0.05; r < 1.0; r += 0.05) {
        const double angle = 1.2 * r - 0.1 * std::pow(r, 2) + 0.05 * std::pow(r, 3) +
                             0.02 * std::pow(r, 4) - 0.03 * std::pow(r, 5);
        const V3d d = camera.at(0.5 + 0.5 * r * 0.8, 0.5 - 0.5 * r * 0.6).direction;
        expect_near(d, {std::cos(angle), -0.8 * std::sin(angle), 0.6 * std::sin(angle)}, 1e-12);
    }
}

}  // namespace balcony::cameras::test::fisheye_test
