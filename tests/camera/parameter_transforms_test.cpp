// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <functional>
#include <random>

#include "support.hpp"

namespace balcony::camera::parameter_transforms_test {

namespace {

using Pair = std::array<double, 2>;

void expect_pair(const Pair& found, const Pair& wanted, double tolerance) {
    EXPECT_NEAR(found[0], wanted[0], tolerance);
    EXPECT_NEAR(found[1], wanted[1], tolerance);
}

// Values of everyday size, rounded a few times.
constexpr double tolerance = 1e-14;

ParameterTransformerPointer zoom(double strength) {
    return warp("zoom", {{"at", numbers({0.6, -0.2})},
                         {"radius", numbers({0.5, 0.25})},
                         {"strength", numbers({strength})}});
}

// Along a ray from the zoom's point: the offset that comes out for one in units of the radius.
double pulled(double strength, double offset, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const Pair p = warped(zoom(strength), 0.6 + 0.5 * offset * c, -0.2 + 0.25 * offset * s);
    return (p[0] - 0.6) / 0.5 * c + (p[1] + 0.2) / 0.25 * s;
}

// The least slope of the offset along a ray, by differences.
double min_slope(double strength) {
    constexpr double h = 1e-4;
    double minimum = 1.0;
    for (double offset = 0.0; offset < 1.0; offset += 1e-3) {
        const double rise = pulled(strength, offset + h, 0.3) - pulled(strength, offset - h, 0.3);
        minimum = std::min(minimum, rise / (2.0 * h));
    }
    return minimum;
}

}  // namespace

TEST(ParameterAffine, EachIsItsFormula) {
    const Pair p{0.7, -1.3};
    const auto at = numbers({0.2, 0.5});
    const auto go = [&](const char* name, const Given& given) {
        return warped(warp(name, given), p[0], p[1]);
    };
    expect_pair(go("translate", {{"u", numbers({2.0})}, {"v", numbers({3.0})}}), {2.7, 1.7},
                tolerance);
    expect_pair(go("scale", {{"factor", numbers({2.0, -3.0})}, {"at", at}}),
                {0.2 + 2.0 * 0.5, 0.5 - 3.0 * -1.8}, tolerance);
    const double angle = 0.4;
    expect_pair(go("rotate", {{"angle", numbers({angle})}, {"at", at}}),
                {0.2 + 0.5 * std::cos(angle) + 1.8 * std::sin(angle),
                 0.5 + 0.5 * std::sin(angle) - 1.8 * std::cos(angle)},
                tolerance);
    expect_pair(go("shear", {{"u", numbers({2.0})}, {"v", numbers({3.0})}}),
                {0.7 + 2.0 * -1.3, -1.3 + 3.0 * 0.7}, tolerance);
    expect_pair(go("affine", {{"u", numbers({1.0, 2.0})}, {"v", numbers({3.0, 4.0})}, {"at", at}}),
                {0.2 + 0.7 * 1.0 - 1.3 * 3.0, 0.5 + 0.7 * 2.0 - 1.3 * 4.0}, tolerance);
}

TEST(ParameterAffine, DefaultsChangeNothing) {
    for (const char* name : {"translate", "shear", "affine"}) {
        expect_pair(warped(warp(name), 0.7, -1.3), {0.7, -1.3}, 0.0);
    }
}

TEST(LocalZoom, MagnifiesByItsStrengthInTheMiddle) {
    constexpr double h = 1e-4;
    for (const double strength : {0.5, 1.0, 2.5, 10.0}) {
        for (const double angle : {0.0, 0.8, 2.0, 4.0}) {
            const double slope =
                (pulled(strength, h, angle) - pulled(strength, -h, angle)) / (2.0 * h);
            // The slope changes with the square of the offset, by less than 30 h^2.
            EXPECT_NEAR(slope, 1.0 / strength, 30.0 * h * h);
        }
        expect_pair(warped(zoom(strength), 0.6, -0.2), {0.6, -0.2}, 0.0);
    }
}

TEST(LocalZoom, LeavesAllThatLiesOutsideItsRadius) {
    for (const double angle : {0.0, 0.8, 2.0, 4.0}) {
        for (const double offset : {1.0 + 1e-12, 1.5, 20.0}) {
            const double u = 0.6 + 0.5 * offset * std::cos(angle);
            const double v = -0.2 + 0.25 * offset * std::sin(angle);
            expect_pair(warped(zoom(3.0), u, v), {u, v}, 0.0);
        }
    }
}

// Inside, the change from the identity falls with the third power of the distance from the rim, so
// that value, slope and curvature are continuous there.
TEST(LocalZoom, MeetsTheIdentityWithSlopeAndCurvatureAtTheRim) {
    for (const double distance : {1e-2, 1e-3, 1e-4}) {
        const double change = pulled(3.0, 1.0 - distance, 0.3) - (1.0 - distance);
        // (1 - q)^3 with 1 - q < 2 distance, times k < 1; and the rounding of offsets.
        EXPECT_LE(std::fabs(change), 8.0 * std::pow(distance, 3) + 1e-15);
        EXPECT_GE(std::fabs(change), 4.0 * std::pow(distance, 3) - 1e-15);
    }
}

TEST(LocalZoom, NeverFoldsForStrengthsOfOneAndMore) {
    for (const double strength : {1.0, 1.5, 3.0, 100.0}) {
        EXPECT_GT(min_slope(strength), 0.0) << strength;
    }
}

TEST(LocalZoom, FoldsExactlyBelowTheStatedStrength) {
    constexpr double limit = 32.0 / 81.0;
    EXPECT_GT(min_slope(1.001 * limit), 0.0);
    EXPECT_LT(min_slope(0.999 * limit), 0.0);
    // Differences and a grid of 1e-3 see the least slope, which is 0 at the limit, to 1e-5.
    EXPECT_NEAR(min_slope(limit), 0.0, 1e-5);
}

}  // namespace balcony::camera::parameter_transforms_test
