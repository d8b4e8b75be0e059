// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Cameras with mirrors against a simulation: a pinhole or parallel ray is reflected in the
// published surface, by the law of reflection.

#include <cmath>
#include <functional>
#include <random>

#include "support.hpp"

namespace balcony::cameras::test::mirrors_test {

namespace {

constexpr double tolerance = 1e-9;
const std::vector<double> places{0.03, 0.2, 0.41, 0.55, 0.87, 0.98};

/// A function of points that is 0 on a surface.
using Surface = std::function<double(const V3d&)>;

// By central differences, whose relative error is some 1e-10 for steps of 1e-5 of the size.
V3d normal_of(const Surface& surface, const V3d& p, double size) {
    const double step = 1e-5 * size;
    V3d gradient;
    for (int axis = 0; axis < 3; ++axis) {
        V3d offset(0.0);
        offset[axis] = step;
        gradient[axis] = surface(p + offset) - surface(p - offset);
    }
    return gradient.normalized();
}

V3d reflected(const V3d& direction, const V3d& normal) {
    return direction - 2.0 * (direction ^ normal) * normal;
}

/// A camera at the height -below under the origin that looks up at a mirror.
struct Sensor {
    double below;
    bool parallel = false;
};

// The raw image is that of the upright sensor: a place in it belongs to the point of the mirror
// that the sensor sees there, and the ray is reflected from there.
void expect_sensor_image(const Rays& rays, const Sensor& sensor, const Surface& mirror,
                         double size) {
    const V3d pinhole(0.0, 0.0, -sensor.below);
    // In the sensor's image: ahead is at the bottom, as it looks up.
    const auto image_of = [&](const V3d& p) {
        const V3d way = p - pinhole;
        const double depth = sensor.parallel ? 1.0 : way.z;
        return V2d(-way.y, way.x) / depth;
    };
    const double half_width = image_of(rays.at(1.0, 0.5).origin).x;
    ASSERT_GT(half_width, 0.0);
    for (const double x : places) {
        for (const double y : places) {
            const Ray ray = rays.at(x, y);
            if (!ray.valid) {
                continue;
            }
            EXPECT_NEAR(mirror(ray.origin), 0.0, 1e-9 * size);
            const V2d image = image_of(ray.origin) / half_width;
            EXPECT_NEAR(image.x, 2.0 * x - 1.0, tolerance);
            EXPECT_NEAR(image.y, 2.0 * y - 1.0, tolerance);
            const V3d incident =
                sensor.parallel ? V3d(0.0, 0.0, 1.0) : (ray.origin - pinhole).normalized();
            expect_near(ray.direction, reflected(incident, normal_of(mirror, ray.origin, size)),
                        1e-7);
        }
    }
}

// Without `mirrored`, up and down are exchanged, so that what lies ahead is on top.
void expect_readable(const std::string& name) {
    const Rays readable(name);
    const Rays raw(make(name, {{"mirrored", "1"}}));
    for (const double x : places) {
        const Ray a = readable.at(x, 0.3);
        const Ray b = raw.at(x, 0.7);
        EXPECT_EQ(a.valid, b.valid);
        expect_near(a.direction, b.direction, tolerance);
    }
    EXPECT_GT(readable.at(0.5, 0.2).direction.x, 0.5) << name;
    EXPECT_GT(readable.at(0.2, 0.5).direction.y, 0.5) << name;
}

double angle_from_below(const Ray& ray) { return std::acos(-ray.direction.z); }

}  // namespace

// Baker and Nayar, equation 16: (z - c/2)² - r² (k/2 - 1) = c²/4 (k - 2)/k around the viewpoint,
// with the pinhole at z = c below it.
TEST(HyperbolicMirror, IsBakerAndNayarsSensor) {
    const double a = 0.06;
    const double b = 0.08;
    const double c = 2.0 * std::hypot(a, b);
    const double k = c * c / (2.0 * b * b);
    const Rays rays(make("catadioptric_hyperbolic", {{"mirrored", "1"}}));
    expect_sensor_image(
        rays, {c},
        [&](const V3d& p) {
            const double r2 = p.x * p.x + p.y * p.y;
            return std::pow(-p.z - c / 2.0, 2) - r2 * (k / 2.0 - 1.0) - c * c / 4.0 * (k - 2.0) / k;
        },
        a);
    // A single viewpoint.
    const Ray ray = rays.at(0.3, 0.8);
    expect_near(ray.origin.normalized(), ray.direction, tolerance);
    EXPECT_NEAR(angle_from_below(rays.at(1.0, 0.5)), 110.0 * degree, tolerance);
    expect_readable("catadioptric_hyperbolic");
}

// Nayar 1997: z = (h² - r²)/(2h) around the viewpoint, seen by parallel rays from below.
TEST(ParabolicMirror, IsNayarsSensor) {
    const double h = 0.05;
    const Rays rays(make("catadioptric_parabolic", {{"mirrored", "1"}}));
    expect_sensor_image(
        rays, {.below = 0.0, .parallel = true},
        [&](const V3d& p) { return (h * h - p.x * p.x - p.y * p.y) / (2.0 * h) + p.z; }, h);
    const Ray ray = rays.at(0.3, 0.8);
    expect_near(ray.origin.normalized(), ray.direction, tolerance);
    EXPECT_NEAR(angle_from_below(rays.at(1.0, 0.5)), 110.0 * degree, tolerance);
    expect_readable("catadioptric_parabolic");
}

TEST(ConicalMirror, ReflectsInACone) {
    const double slope = std::tan(55.0 * degree);
    const Rays rays(make("catadioptric_conical", {{"mirrored", "1"}}));
    expect_sensor_image(
        rays, {0.1}, [&](const V3d& p) { return p.x * p.x + p.y * p.y - std::pow(slope * p.z, 2); },
        0.1);
    // The elevation: 90° - 2 half_angle in the middle, fov/2 more at the rim.
    EXPECT_NEAR(angle_from_below(rays.at(0.5 + 1e-6, 0.5)), 70.0 * degree, 1e-4);
    EXPECT_NEAR(angle_from_below(rays.at(1.0, 0.5)), 110.0 * degree, tolerance);
    expect_readable("catadioptric_conical");
}

TEST(SphericalMirror, ReflectsInABall) {
    // Turned up, as the others are.
    const Rays rays(make("catadioptric_spherical", {{"mirrored", "1"}, {"pitch", "90deg"}}));
    expect_sensor_image(
        rays, {0.5}, [](const V3d& p) { return p.length2() - 0.01; }, 0.1);
    // The rim grazes what is behind the ball.
    const Rays ball("catadioptric_spherical");
    EXPECT_GT(ball.at(0.999999, 0.5).direction.x, 0.97);
    expect_near(ball.at(0.5, 0.5).direction, {-1.0, 0.0, 0.0}, tolerance);
    // One who looks back from the ball has the camera's left on the right.
    EXPECT_GT(ball.at(0.7, 0.5).direction.y, 0.1);
    EXPECT_LT(Rays(make("catadioptric_spherical", {{"mirrored", "1"}})).at(0.7, 0.5).direction.y,
              -0.1);
}

// --------------------------------------------------------------------------------- anamorphoses

namespace {

/// The axes of a line of sight from a viewer's eye to a point; x is ahead, y left and z up.
struct LineOfSight {
    LineOfSight(const V3d& eye, const V3d& aim)
        : ahead((aim - eye).normalized()), left(V3d(0.0, 0.0, 1.0) % ahead), up(ahead % left) {
        left.normalize();
        up.normalize();
    }
    V3d ahead, left, up;
};

}  // namespace

// The viewer's rays, reflected in the mirror, meet the sheet where the picture shows what a pinhole
// sees in the same direction.
TEST(CylindricalAnamorphosis, IsUndoneByTheMirror) {
    const Rays sheet("cylindrical_anamorphosis");  // 10 wide, of which 8 are before the axis
    const V3d eye(-12.0, 0.0, 9.0);
    const V3d aim(0.0, 0.0, 1.5);
    const LineOfSight axes(eye, aim);
    // A ray that touches the mirror at the height of the aim is at the edge of a fov of 60 degrees.
    const double distance = (aim - eye).length();
    const double zoom = std::tan(30.0 * degree) * std::sqrt(distance * distance - 1.0);
    std::size_t seen = 0;
    for (double right = -0.9; right < 1.0; right += 0.3) {
        for (double up = -0.8; up < 1.0; up += 0.2) {
            const V3d seen_direction(1.0, -right * std::tan(30.0 * degree), up * 0.4);
            const V3d ray = (seen_direction.x * axes.ahead + seen_direction.y / zoom * axes.left +
                             seen_direction.z / zoom * axes.up)
                                .normalized();
            // The first point of the cylinder of the radius 1.
            const double a = ray.x * ray.x + ray.y * ray.y;
            const double b = eye.x * ray.x + eye.y * ray.y;
            const double root = b * b - a * (eye.x * eye.x + eye.y * eye.y - 1.0);
            if (root <= 0.0) {
                continue;
            }
            const V3d met = eye + (-b - std::sqrt(root)) / a * ray;
            const V3d after = reflected(ray, {met.x, met.y, 0.0});
            const V3d floor = met - met.z / after.z * after;
            const V2d at(0.5 - floor.y / 10.0, 0.2 - floor.x / 10.0);
            if (met.z <= 0.0 || at.x < 0.0 || at.x > 1.0 || at.y < 0.0 || at.y > 1.0) {
                continue;
            }
            const Ray painted = sheet.at(at.x, at.y);
            ASSERT_TRUE(painted.valid);
            expect_near(painted.direction, seen_direction.normalized(), tolerance);
            ++seen;
        }
    }
    EXPECT_GE(seen, 20U);
    EXPECT_FALSE(sheet.at(0.5, 0.2).valid) << "under the mirror";
    EXPECT_FALSE(sheet.at(0.5, 0.01).valid) << "behind the mirror";
}

TEST(PavementAnamorphosis, LooksUprightFromTheEye) {
    const Rays ground("pavement_anamorphosis");  // 5 wide, from 2 to 8, eye height 1.6
    const V3d eye(0.0, 0.0, 1.6);
    const LineOfSight axes(eye, {5.0, 0.0, 0.0});
    for (const double x : places) {
        for (const double y : places) {
            const V3d way = V3d(8.0 - 6.0 * y, 5.0 * (0.5 - x), 0.0) - eye;
            const V3d looked = V3d(way ^ axes.ahead, way ^ axes.left, way ^ axes.up).normalized();
            expect_near(ground.at(x, y).direction, looked, tolerance);
        }
    }
}

}  // namespace balcony::cameras::test::mirrors_test
