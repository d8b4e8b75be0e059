// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Lenses of glass: their rays are those that a tracer from the textbook finds the other way, from
// the scene to the sensor; and vignetting is the area of the directions that pass.

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "balcony/prescription.hpp"
#include "lens_rays.hpp"
#include "lens_tracer.hpp"
#include "support.hpp"

namespace balcony::rays::test::prescribed_lens_test {
namespace {

using camera::ParaxialLens;
using camera::Prescription;

/// A camera that looks along x, with x to the right of its picture as -y. The unit is 1 mm.
std::string camera_text(const std::string& lens, const std::string& more = "") {
    return "camera a { aspect 1  map u = 0.36 .. -0.36, v = square  eye point  toward plane((1, 0, "
           "0))  lens table(\"" +
           lens + "\", unit = 1" + more + ") }";
}

/// The light of a camera's ray, reversed, on a plane at a distance behind the last surface.
std::optional<V2d> on_sensor(const Prescription& lens, const Ray& ray, double behind,
                             double wavelength, double stop_scale = 1.0) {
    const ParaxialLens near_axis = camera::paraxial(lens);
    // From the camera's axes, x forwards, with the entrance pupil at the origin.
    const Line line{{near_axis.entrance_pupil - ray.origin.x, ray.origin.y, ray.origin.z},
                    {ray.direction.x, -ray.direction.y, -ray.direction.z}};
    const auto out = through(lens, line, wavelength, stop_scale);
    if (!out) {
        return std::nullopt;
    }
    const double plane = length_of(lens) + behind;
    const V3d at = out->point + (plane - out->point.x) / out->direction.x * out->direction;
    return V2d(at.y, at.z);
}

/// Where the point of the picture is on the sensor, in the camera's y and z.
V2d sensor_point(const ParaxialLens& near_axis, const V2d& point) {
    const double f = near_axis.focal_length;
    return {-f * 0.36 * (1.0 - 2.0 * point.x / pixels), f * 0.36 * (2.0 * point.y / pixels - 1.0)};
}

/// The point of the square that the concentric map takes to a point of the disc.
V2d on_square(const V2d& disc) {
    const double radius = disc.length();
    const double angle = std::atan2(disc.y, disc.x);
    const double quarter = std::round(angle / (0.5 * std::numbers::pi));
    const double part = (angle - quarter * 0.5 * std::numbers::pi) / (0.25 * std::numbers::pi);
    const V2d right(radius, radius * part);
    const double c = std::round(std::cos(quarter * 0.5 * std::numbers::pi));
    const double s = std::round(std::sin(quarter * 0.5 * std::numbers::pi));
    return {c * right.x - s * right.y, s * right.x + c * right.y};
}

}  // namespace

// The sensor is where the paraxial image is; 1e-9 mm is rounding over a dozen surfaces.
TEST(PrescribedLens, RaysArriveOnTheSensorTheOtherWay) {
    const Prescription lens = read_lens("dgauss.dat");
    const ParaxialLens near_axis = camera::paraxial(lens);
    const LensRaysAt rays(camera_text("dgauss.dat", ", focus = 1e12"));
    int passed = 0;
    at_points([&](const V2d& point) {
        const V2d wanted = sensor_point(near_axis, point);
        at_lens([&](const V2d& at) {
            const Ray ray = rays(point, at);
            const auto found = on_sensor(lens, ray, near_axis.back_focus, camera::line_d);
            if (ray.valid) {
                ++passed;
                ASSERT_TRUE(found) << point;
                EXPECT_LT((*found - wanted).length(), 1e-8) << point << at;
                EXPECT_NEAR(ray.direction.length(), 1.0, 1e-13);
            }
        });
    });
    EXPECT_GT(passed, 150);
}

// Without a point of the lens, a camera has the ray through the middle of the pupil.
TEST(PrescribedLens, HasACentralRayWithTheDistortionOfTheLens) {
    const Prescription lens = read_lens("dgauss.dat");
    const ParaxialLens near_axis = camera::paraxial(lens);
    const LensRaysAt rays(camera_text("dgauss.dat", ", focus = 1e12"));
    at_points([&](const V2d& point) {
        const Ray ray = rays.central(point);
        ASSERT_TRUE(ray.valid);
        EXPECT_LT((ray.direction - rays(point, {0.0, 0.0}).direction).length(), 1e-14);
        const auto found = on_sensor(lens, ray, near_axis.back_focus, camera::line_d);
        ASSERT_TRUE(found);
        EXPECT_LT((*found - sensor_point(near_axis, point)).length(), 1e-8);
    });
    // Near the axis it is that of the pinhole, whose pictures have no distortion; the chief ray
    // deviates from the pinhole's by the cube of the angle.
    const Ray near = rays.central({202.0, 200.0});
    EXPECT_NEAR(near.direction.y / near.direction.x, -0.36 / 100.0, 1e-6);
    // At the edge it does not: a fraction of a per cent.
    const Ray edge = rays.central({380.0, 200.0});
    const double distortion = -edge.direction.y / edge.direction.x / (0.36 * 0.9) - 1.0;
    EXPECT_GT(std::abs(distortion), 1e-3);
    EXPECT_LT(std::abs(distortion), 3e-2);
}

// Rays near the axis of one point meet at the distance that is in focus, measured from the entrance
// pupil. What spherical aberration adds is proportional to the square of the pupil.
TEST(PrescribedLens, IsFocusedByTheSensorOrByAGroup) {
    for (const char* how : {"", ", group = (1, 11)", ", group = (1, 5)", ", group = (7, 11)"}) {
        const LensRaysAt rays(camera_text("dgauss.dat", fmt::format(", focus = 800{}", how)));
        const auto miss = [&](double pupil) {
            const Ray up = rays({200.0, 200.0}, {0.0, pupil});
            EXPECT_TRUE(up.valid) << how;
            return up.origin.x - up.origin.z / up.direction.z * up.direction.x - 800.0;
        };
        EXPECT_LT(std::abs(miss(0.2)), 80.0) << how;
        EXPECT_NEAR(miss(0.02) / miss(0.2), 0.01, 0.002) << how;
    }
}

// The part of the square of lens samples that passes is proportional to the light on the sensor:
// the integral of cos θ over the solid angle of what passes, by the other tracer.
TEST(PrescribedLens, HasExactVignetting) {
    const Prescription lens = read_lens("dgauss.dat");
    const ParaxialLens near_axis = camera::paraxial(lens);
    const LensRaysAt rays(camera_text("dgauss.dat", ", focus = 1e12"));
    // Light from the scene, uniform in position and in the sines of its directions at the first
    // plane: as many rays arrive at a patch of the sensor as dA cos θ dω is there, which a lens
    // conserves.
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const double hole = 12.6;
    const double half = 0.45;  // Of the sines of the directions.
    const double patch = 0.8;  // mm, half the side of a square on the sensor.
    const std::array points{V2d(200.0, 200.0), V2d(60.0, 200.0), V2d(20.0, 20.0)};
    std::array<int, 3> arrived{};
    for (int i = 0; i < 4'000'000; ++i) {
        const double a = half * uniform(random);
        const double b = half * uniform(random);
        const Line line{{0.0, hole * uniform(random), hole * uniform(random)},
                        {std::sqrt(1.0 - a * a - b * b), a, b}};
        const auto out = through(lens, line, camera::line_d);
        if (!out) {
            continue;
        }
        const V3d at = out->point + (length_of(lens) + near_axis.back_focus - out->point.x) /
                                        out->direction.x * out->direction;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const V2d wanted = sensor_point(near_axis, points[k]);
            arrived[k] += std::abs(at.y - wanted.x) < patch && std::abs(at.z - wanted.y) < patch;
        }
    }
    const double middle = lit_part(rays, points[0]);
    EXPECT_GT(middle, 0.95);
    for (std::size_t k = 1; k < points.size(); ++k) {
        const double wanted = static_cast<double>(arrived[k]) / arrived[0];
        // Four standard deviations of both counts, and 1 % for the size of the patch.
        const double deviation = 4.0 * wanted * std::sqrt(1.0 / arrived[k] + 1.0 / arrived[0]);
        EXPECT_NEAR(lit_part(rays, points[k]) / middle, wanted, deviation + 0.01) << k;
        EXPECT_LT(wanted, 0.85) << k;
    }
}

// In the middle of the picture, no samples are lost but those of the disc's margin of 1 %, also
// where beside the axis a mount takes a part of the stop's image. In the triplet, that image
// is 1.18 times as wide near the edge of the light as in the middle.
TEST(PrescribedLens, LosesFewSamples) {
    const V2d middle(200.0, 200.0);
    for (const double f_number : {2.2, 5.6, 16.0, 32.0}) {
        const LensRaysAt rays(
            camera_text("petzval.dat", fmt::format(", focus = 1e12, f_number = {}", f_number)));
        EXPECT_GT(lit_part(rays, middle), 0.96) << f_number;
    }
    const LensRaysAt narrow(camera_text("triplet.dat", ", focus = 1e12, f_number = 32"));
    EXPECT_GT(lit_part(narrow, middle), 0.99 / (1.18 * 1.18));
}

// Where the lens takes the light of a point there is no ray, but the picture is there, and dark.
TEST(PrescribedLens, TellsBlockedLightFromPointsWithoutARay) {
    const LensRaysAt rays(camera_text("petzval.dat", ", focus = 1e12"));
    int blocked = 0;
    at_points([&](const V2d& point) {
        at_lens([&](const V2d& at) {
            EXPECT_NE(rays(point, at).valid, rays.blocked(point, at)) << point << at;
            blocked += rays.blocked(point, at) ? 1 : 0;
        });
    });
    EXPECT_GT(blocked, 50);
    EXPECT_TRUE(rays.blocked({-3000.0, 200.0}, {0.0, 0.0}));  // Far outside of the image circle.

    // A picture whose lower part has no points.
    const LensRaysAt half(
        "camera a { aspect 1  map u = 0.2 .. -0.2, v = square  eye point  toward surface(u, v) = "
        "[1, u, v + 1e-9*sqrt(v + 0.1)]  look absolute  lens table(\"petzval.dat\", focus = "
        "1e12, unit = 1) }");
    EXPECT_TRUE(half({200.0, 150.0}, {0.0, 0.0}).valid);
    EXPECT_FALSE(half({200.0, 399.0}, {0.0, 0.0}).valid);
    EXPECT_FALSE(half.blocked({200.0, 399.0}, {0.0, 0.0}));
}

TEST(PrescribedLens, NarrowsItsStop) {
    const Prescription lens = read_lens("dgauss.dat");
    const ParaxialLens near_axis = camera::paraxial(lens);
    const double scale = near_axis.f_number() / 8.0;
    const LensRaysAt rays(camera_text("dgauss.dat", ", focus = 1e12, f_number = 8"));
    int passed = 0;
    at_points([&](const V2d& point) {
        at_lens([&](const V2d& at) {
            const Ray ray = rays(point, at);
            if (ray.valid) {
                ++passed;
                EXPECT_TRUE(on_sensor(lens, ray, near_axis.back_focus, camera::line_d, scale));
            }
        });
    });
    EXPECT_GT(passed, 200);
    // The rim of the entrance pupil, which is at the origin of the camera.
    const Ray rim = rays({200.0, 200.0}, {0.0, 0.97});
    ASSERT_TRUE(rim.valid);
    EXPECT_NEAR(rim.origin.z, 0.97 * near_axis.focal_length / 16.0, 0.05);
}

TEST(PrescribedLens, HasBlades) {
    const LensRaysAt round(camera_text("dgauss.dat", ", focus = 1e12"));
    const LensRaysAt square(camera_text("dgauss.dat", ", focus = 1e12, blades = 4"));
    const V2d middle(200.0, 200.0);
    // On the diagonal of the picture, a square with a corner at the top ends at 1/√2.
    const V2d corner(0.0, 0.97);
    EXPECT_TRUE(round(middle, corner).valid);
    EXPECT_TRUE(square(middle, corner).valid);
    // The concentric map takes the diagonal of the square to that of the disc.
    for (const double r : {0.6, 0.68, 0.74, 0.9}) {
        EXPECT_TRUE(round(middle, {r, r}).valid) << r;
        EXPECT_EQ(square(middle, {r, r}).valid, r < 0.7) << r;
    }
}

// Of a stop with three blades, which is not symmetric about the picture's axes, wherever it is
// turned to: of the circle, an equilateral triangle has the part 3 √3/(4 π). 3 % are the rings and
// sectors of the samples and the aberrations of the pupil.
TEST(PrescribedLens, HasBladesThatAreNotSymmetric) {
    const std::string stop = ", focus = 1e12, f_number = 4";
    const double round = lit_part(LensRaysAt(camera_text("dgauss.dat", stop)), {200.0, 200.0});
    const double triangle = 3.0 * std::sqrt(3.0) / (4.0 * std::numbers::pi);
    for (const int degrees : {0, 40, 90, 180}) {
        const LensRaysAt rays(camera_text(
            "dgauss.dat", fmt::format("{}, blades = 3, rotation = {}deg", stop, degrees)));
        EXPECT_NEAR(lit_part(rays, {200.0, 200.0}) / round, triangle, 0.03 * triangle) << degrees;
        // A corner of the triangle, and the middle of the side on its other side.
        const double angle = (90.0 + degrees) * std::numbers::pi / 180.0;
        const V2d corner(std::cos(angle), std::sin(angle));
        EXPECT_TRUE(rays({200.0, 200.0}, on_square(0.9 * corner)).valid) << degrees;
        EXPECT_TRUE(rays({200.0, 200.0}, on_square(-0.45 * corner)).valid) << degrees;
        EXPECT_FALSE(rays({200.0, 200.0}, on_square(-0.6 * corner)).valid) << degrees;
    }
}

// The footprint is the exact derivative, by differences of neighbours.
TEST(PrescribedLens, HasTheExactFootprint) {
    const LensRaysAt rays(camera_text("dgauss.dat", ", focus = 900"));
    constexpr double step = 1e-3;
    at_points([&](const V2d& point) {
        for (const V2d& at : {V2d(0.0, 0.0), V2d(0.3, -0.4)}) {
            const Ray ray = rays(point, at);
            const Ray right = rays(point + V2d(step, 0.0), at);
            const Ray left = rays(point - V2d(step, 0.0), at);
            if (!ray.valid || !right.valid || !left.valid) {
                continue;
            }
            // Rounding of 1e-14 over a step, for directions; ten times that for origins.
            EXPECT_LT(
                (ray.direction_by_x - (right.direction - left.direction) / (2.0 * step)).length(),
                1e-10);
            EXPECT_LT((ray.origin_by_x - (right.origin - left.origin) / (2.0 * step)).length(),
                      1e-9);
        }
    });
}

// The sensor is where the image of the d line is; light of another wavelength meets elsewhere, as
// the lens equation says of the focal length for it.
TEST(PrescribedLens, DispersesLight) {
    const Prescription lens = read_lens("petzval.dat");
    const ParaxialLens at_d = camera::paraxial(lens);
    for (const double wavelength : {0.45, 0.7}) {
        const LensRaysAt rays(camera_text(
            "petzval.dat", fmt::format(", focus = 1e12, wavelength = {}", 1000.0 * wavelength)));
        const ParaxialLens there = camera::paraxial(lens, wavelength);
        const double defocus = at_d.back_focus - there.back_focus;
        ASSERT_GT(std::abs(defocus), 1e-3);
        const Ray ray = rays({200.0, 200.0}, {0.0, 0.005});
        ASSERT_TRUE(ray.valid);
        // Towards a point at the distance -f²/defocus from the front focus.
        const double found = ray.origin.x - ray.origin.z / ray.direction.z * ray.direction.x;
        const double wanted = there.focal_length * there.focal_length / defocus;
        EXPECT_NEAR(found / wanted, 1.0, 0.02) << wavelength;
    }
}

}  // namespace balcony::rays::test::prescribed_lens_test
