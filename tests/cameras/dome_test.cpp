// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The cameras of the family `dome`: dome masters by their definition, OMNIMAX by following rays
// from the seat to the film.

#include <random>

#include "support.hpp"

namespace balcony::cameras::test::dome_test {

namespace {

// POV-Ray's camera of this name has the same lens and frame.
constexpr double shape = 1.283458;

double lens_angle(double r) {
    return 1.411269 * r - 0.09439 * r * r * r + 0.25674 * r * r * r * r * r;
}

/// By bisection: the distance from the axis for an angle; above 1 if the lens does not reach it.
double lens_distance(double angle) {
    double low = 0.0, high = 1.5;
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (low + high);
        (lens_angle(middle) < angle ? low : high) = middle;
    }
    return low;
}

/// The place in the frame, as fractions, of a point at (right, up) from the axis, where 1 is half
/// the width.
V2d in_frame(double right, double up) { return {0.5 + 0.5 * right, (1.0 - up) * 0.5 * shape}; }

}  // namespace

TEST(Fulldome, SpreadsTheDomeByTheAngleFromItsZenith) {
    const double tilt = 20.0 * degree, yaw = 30.0 * degree;
    const Rays dome("fulldome", {{"tilt", "20deg"}, {"yaw", "30deg"}, {"fov", "200deg"}});
    // Axes of the audience, tilted about its left.
    const V3d front_of_audience(std::cos(yaw), std::sin(yaw), 0.0);
    const V3d left(-std::sin(yaw), std::cos(yaw), 0.0);
    const V3d vertical(0.0, 0.0, 1.0);
    const V3d zenith = vertical * std::cos(tilt) + front_of_audience * std::sin(tilt);
    const V3d front = front_of_audience * std::cos(tilt) - vertical * std::sin(tilt);
    for (double r = 0.0; r < 1.0; r += 0.1) {
        for (double around = 0.0; around < 6.2; around += 0.4) {
            const Ray ray =
                dome.at(0.5 + 0.5 * r * std::cos(around), 0.5 - 0.5 * r * std::sin(around));
            ASSERT_TRUE(ray.valid);
            const double angle = r * 100.0 * degree;
            // Left at the left, front at the bottom.
            const V3d toward_rim = left * -std::cos(around) + front * -std::sin(around);
            expect_near(ray.direction, zenith * std::cos(angle) + toward_rim * std::sin(angle),
                        1e-9);
        }
    }
    EXPECT_FALSE(dome.at(0.01, 0.01).valid);
    EXPECT_FALSE(dome.at(0.5 + 0.5 * 0.71, 0.5 + 0.5 * 0.71).valid);
    EXPECT_TRUE(dome.at(0.5 + 0.5 * 0.70, 0.5 + 0.5 * 0.70).valid);
}

TEST(Omnimax, IsTheLensAloneFromTheCentreOfTheDome) {
    const Rays camera("omnimax", {{"projector", "(0, 0, 0)"}, {"aim", "10deg"}, {"tilt", "90deg"}});
    int compared = 0;
    for (double x = -0.95; x < 1.0; x += 0.1) {
        for (double y = -0.5; y < 1.0; y += 0.1) {
            const double r = std::hypot(x, y), angle = lens_angle(r);
            const V2d at = in_frame(x, y);
            const Ray ray = camera.at(at.x, at.y);
            if (r < 1.0 && angle < 70.0 * degree) {
                const V3d d(std::cos(angle), -std::sin(angle) * x / r, std::sin(angle) * y / r);
                const double up = 10.0 * degree;
                expect_near(ray.direction,
                            {d.x * std::cos(up) - d.z * std::sin(up), d.y,
                             d.x * std::sin(up) + d.z * std::cos(up)},
                            1e-9);
                ++compared;
            }
            EXPECT_TRUE(r < 1.0 || !ray.valid);
        }
    }
    EXPECT_GT(compared, 100);
}

// Backwards: from the seat to a point of the dome, from there to the projector, through the lens to
// the film. The ray of this point of the frame is the one from the seat.
TEST(Omnimax, ShowsFromTheSeatWhatTheProjectorThrows) {
    const V3d projector(2.0, -0.5, -3.0), seat(-4.0, 1.0, -2.0);
    const double radius = 11.0, tilt = 25.0 * degree, aim = 30.0 * degree;
    const Rays camera("omnimax", {{"projector", "(2, -0.5, -3)"},
                                  {"seat", "(-4, 1, -2)"},
                                  {"radius", "11"},
                                  {"tilt", "25deg"},
                                  {"aim", "30deg"}});
    const V3d zenith(std::sin(tilt), 0.0, std::cos(tilt));
    const V3d axis(std::cos(aim), 0.0, std::sin(aim));
    const V3d lens_up(-std::sin(aim), 0.0, std::cos(aim));
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    int seen = 0;
    int below_rim = 0;
    while (seen < 300) {
        const V3d on_dome = V3d(part(random), part(random), part(random)).normalized() * radius;
        const V3d from_lens = (on_dome - projector).normalized();
        const double angle = std::acos(from_lens.dot(axis));
        const double r = lens_distance(angle);
        const double up = from_lens.dot(lens_up), left = from_lens.y;
        const double aside = std::hypot(up, left);
        const V2d at = in_frame(-r * left / aside, r * up / aside);
        if (r > 0.999 || at.y > 0.999) {
            continue;
        }
        const Ray ray = camera.at(at.x, at.y);
        const double height = on_dome.dot(zenith) / radius;
        if (height > 0.001) {
            ASSERT_TRUE(ray.valid);
            expect_near(ray.origin, seat, 1e-12);
            expect_near(ray.direction, (on_dome - seat).normalized(), 1e-7);
            ++seen;
        } else if (height < -0.001) {
            EXPECT_FALSE(ray.valid);
            ++below_rim;
        }
    }
    EXPECT_GT(below_rim, 5);
}

}  // namespace balcony::cameras::test::dome_test
