// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Fractal height fields by their statistics and their smoothness.

#include <numbers>
#include <random>

#include "support.hpp"

namespace balcony::camera::fractals_test {

namespace {

using std::numbers::pi;

Given field(double height, double hurst, double octaves, double seed = 1.0) {
    return {{"height", numbers({height})},
            {"hurst", numbers({hurst})},
            {"octaves", numbers({octaves})},
            {"seed", numbers({seed})}};
}

// Points so far apart that their heights have next to nothing to do with each other.
template <class Check>
void at_scattered_points(int count, const Check& check) {
    std::mt19937_64 random(75);
    std::uniform_real_distribution<double> any(-500.0, 500.0);
    for (int i = 0; i < count; ++i) {
        const double u = any(random);
        check(u, any(random));
    }
}

}  // namespace

TEST(FractalPlane, OfOneSeedIsOneLandscapeAndOfAnotherAnother) {
    const GeneratorProbe first(object("fractal_plane", field(1.0, 0.8, 6.0, 1.0)));
    const GeneratorProbe same(object("fractal_plane", field(1.0, 0.8, 6.0, 1.0)));
    const GeneratorProbe other(object("fractal_plane", field(1.0, 0.8, 6.0, 2.0)));
    double covariance = 0.0;
    constexpr int count = 4000;
    at_scattered_points(count, [&](double u, double v) {
        const Vector p = first(u, v).point;
        expect_near(same(u, v).point, p, 0.0);
        EXPECT_EQ(p[0], u);
        EXPECT_EQ(p[1], v);
        covariance += p[2] * other(u, v).point[2] / count;
    });
    EXPECT_NEAR(covariance, 0.0, 4.0 / std::sqrt(count));  // four standard errors
}

// The seed's landscape is a promise: pictures made from it must not change.
TEST(FractalPlane, IsTheSameEverywhereAndLater) {
    const GeneratorProbe plane(object("fractal_plane", field(1.0, 0.8, 8.0, 1.0)));
    EXPECT_NEAR(plane(0.0, 0.0).point[2], -0.73678142565493, 1e-10);
    EXPECT_NEAR(plane(1.25, -3.5).point[2], -1.83088209233905, 1e-10);
    EXPECT_NEAR(plane(-40.0, 17.0).point[2], 0.12284169889597, 1e-10);
}

TEST(FractalPlane, HasTheStandardDeviationOfItsHeightsAboutZero) {
    constexpr int count = 20000;
    for (const auto& [octaves, hurst, seed] :
         {std::tuple(1.0, 0.8, 1.0), std::tuple(1.0, 0.8, 2.0), std::tuple(6.0, 0.8, 3.0),
          std::tuple(6.0, 0.2, 4.0)}) {
        const GeneratorProbe plane(object("fractal_plane", field(0.5, hurst, octaves, seed)));
        double sum = 0.0;
        double squares = 0.0;
        at_scattered_points(count, [&](double u, double v) {
            const double z = plane(u, v).point[2];
            sum += z / count;
            squares += z * z / count;
        });
        // Four standard errors of independent values; neighbours in one period are not quite so.
        EXPECT_NEAR(sum, 0.0, 0.5 * 4.0 / std::sqrt(count)) << octaves << ' ' << seed;
        EXPECT_NEAR(squares, 0.25, 0.25 * 4.0 * std::sqrt(2.0 / count)) << octaves << ' ' << seed;
    }
}

// For a function whose second derivative is continuous and third is bounded, the trapezoid rule
// over a step is right to the third power of the step; a jump in value, slope or curvature between
// cells or at the end of the period would be seen.
TEST(FractalPlane, IsSmoothAndHasItsDerivatives) {
    const GeneratorProbe plane(object("fractal_plane", field(1.0, 0.8, 3.0)));
    constexpr double step = 1e-3;
    for (const auto& [du, dv] : {std::pair(step, 0.0), std::pair(0.0, step)}) {
        Sample before = plane(-15.0 * du / step, -15.0 * dv / step);
        for (int i = 1; i < 30000; ++i) {
            const double at = -15.0 + i * step;
            const Sample here = plane(at * du / step, at * dv / step);
            const double slope = du * (before.along_u[2] + here.along_u[2]) / 2.0 +
                                 dv * (before.along_v[2] + here.along_v[2]) / 2.0;
            // The curvature's slope is about 5 (2^2)^3 / 12, with octaves' weights below 1.
            ASSERT_NEAR(here.point[2] - before.point[2], slope, 50.0 * step * step * step) << at;
            before = here;
        }
    }
}

// Heights at a distance d differ by d^hurst, between the finest and the largest features: the mean
// square of the difference, of the power 2 hurst. Near 1 the sum over octaves takes many of them to
// come there, so the power lies a little above it.
TEST(FractalPlane, IsAsRoughAsItsHurstExponentSays) {
    for (const double hurst : {0.25, 0.5, 0.75}) {
        const GeneratorProbe plane(object("fractal_plane", field(1.0, hurst, 12.0)));
        const auto mean_square_difference = [&](double distance) {
            double sum = 0.0;
            at_scattered_points(4000, [&](double u, double v) {
                const double difference = plane(u + distance, v).point[2] - plane(u, v).point[2];
                sum += difference * difference;
            });
            return sum;
        };
        const double power =
            std::log2(mean_square_difference(0x1p-3) / mean_square_difference(0x1p-8)) / 5.0;
        EXPECT_NEAR(power, 2.0 * hurst, 0.1) << hurst;
    }
}

TEST(FractalPlane, ScaleAndHeightStretchIt) {
    Given given = field(1.0, 0.8, 5.0);
    const GeneratorProbe plain(object("fractal_plane", given));
    given["scale"] = numbers({4.0});
    given["height"] = numbers({3.0});
    const GeneratorProbe stretched(object("fractal_plane", given));
    at_scattered_points(200, [&](double u, double v) {
        // Places of size 4000 are rounded to 1e-12, where the slope of five octaves is about 30.
        EXPECT_NEAR(stretched(4.0 * u, 4.0 * v).point[2], 3.0 * plain(u, v).point[2], 1e-10);
    });
}

TEST(FractalSphere, StandsOverItsSphereWithoutASeamOrPoles) {
    Given given = field(0.1, 0.8, 8.0);
    given["radius"] = numbers({5.0});
    const GeneratorProbe sphere(object("fractal_sphere", given));
    given["height"] = numbers({0.0});
    const GeneratorProbe smooth(object("fractal_sphere", given));
    const GeneratorProbe plain(object("sphere", {{"radius", numbers({5.0})}}));
    for (double v = -1.5; v < 1.6; v += 0.1) {
        expect_near(sphere(pi, v).point, sphere(-pi, v).point, 1e-12);
        for (double u = -3.0; u < 3.1; u += 0.3) {
            const Vector p = sphere(u, v).point;
            const Vector q = plain(u, v).point;
            expect_near((5.0 / length(p)) * p, q, 1e-14);
            EXPECT_NEAR(length(p), 5.0, 0.6);  // six standard deviations
            expect_near(smooth(u, v).point, q, 1e-14);
            expect_near(sphere(u, pi / 2.0).point, sphere(0.0, pi / 2.0).point, 1e-12);
        }
    }
}

TEST(FractalSphere, HasTheStandardDeviationOfItsHeights) {
    Given given = field(0.1, 0.8, 6.0);
    given["radius"] = numbers({40.0});  // Some 5000 features of size 2.
    const GeneratorProbe sphere(object("fractal_sphere", given));
    std::mt19937_64 random(76);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    constexpr int count = 10000;
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < count; ++i) {
        const double u = pi * any(random);
        const double z = length(sphere(u, std::asin(any(random))).point) - 40.0;
        sum += z / count;
        squares += z * z / count;
    }
    // Four standard errors for 5000 independent values.
    EXPECT_NEAR(sum, 0.0, 0.1 * 4.0 / std::sqrt(5000.0));
    EXPECT_NEAR(squares, 0.01, 0.01 * 4.0 * std::sqrt(2.0 / 5000.0));
}

// Where heights reach below the centre there is no point.
TEST(FractalSphere, EndsAtItsCentre) {
    Given given = field(3.0, 0.8, 1.0);
    const GeneratorProbe sphere(object("fractal_sphere", given));
    given["height"] = numbers({-3.0});
    const GeneratorProbe turned(object("fractal_sphere", given));
    int valid = 0;
    int invalid = 0;
    for (double u = -3.0; u < 3.0; u += 0.1) {
        const Sample s = sphere(u, 0.3);
        (s.valid ? valid : invalid) += 1;
        EXPECT_TRUE(s.valid || turned(u, 0.3).valid);
    }
    EXPECT_GT(valid, 0);
    EXPECT_GT(invalid, 0);
}

}  // namespace balcony::camera::fractals_test
