// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Lenses with toroidal surfaces: another focal length to the sides than upwards.

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "balcony/prescription.hpp"
#include "lens_rays.hpp"
#include "lens_tracer.hpp"
#include "support.hpp"

namespace balcony::rays::test::anamorphic_test {
namespace {

using camera::LensSurface;
using camera::ParaxialLens;
using camera::Prescription;

const camera::Medium glass{"glass", camera::Medium::Dispersion::none, {1.6}};

/// Petzval's lens between surfaces of all kinds: a cylinder that is level, one that is upright, and
/// two toroids, one of which is convex to the side and concave upwards.
Prescription anamorphic() {
    Prescription lens = read_lens("petzval.dat");
    lens.surfaces.back().gap = 2.0;
    lens.surfaces.front().curvature_x = 1.0 / 50.0;
    lens.surfaces.push_back({.curvature = -1.0 / 400.0,
                             .curvature_x = 1.0 / 500.0,
                             .radius = 14.0,
                             .gap = 3.0,
                             .behind = glass});
    lens.surfaces.push_back({.curvature_x = 1.0 / 300.0, .radius = 14.0, .gap = 1.0});
    lens.surfaces.push_back({.curvature = -1.0 / 600.0,
                             .curvature_x = 0.0,
                             .radius = 14.0,
                             .gap = 2.0,
                             .behind = glass});
    lens.surfaces.push_back({.radius = 14.0});
    return lens;
}

struct Meridians {
    explicit Meridians(const Prescription& lens)
        : up(camera::paraxial(lens)), aside(camera::paraxial(camera::horizontal_section(lens))) {}

    /// Where a point of the picture is on the sensor, in the camera's y and z.
    [[nodiscard]] V2d sensor_point(const V2d& point) const {
        return {-aside.focal_length * 0.1 * (1.0 - 2.0 * point.x / pixels),
                up.focal_length * 0.1 * (2.0 * point.y / pixels - 1.0)};
    }

    ParaxialLens up, aside;
};

/// Light on its way to the plane at the paraxial focus of the vertical plane.
std::optional<V2d> on_sensor(const Prescription& lens, const Line& line, double back_focus) {
    const auto out = through(lens, line, camera::line_d);
    if (!out) {
        return std::nullopt;
    }
    const V3d at = out->point + (length_of(lens) + back_focus - out->point.x) / out->direction.x *
                                    out->direction;
    return V2d(at.y, at.z);
}

}  // namespace

// The picture has no squeeze: each point is on the sensor where the focal length of its meridian
// puts it. 1e-8 mm is rounding over a dozen surfaces, and 1e-9 mm of Newton's iteration at some.
TEST(Anamorphic, RaysArriveOnTheSensorTheOtherWay) {
    const Prescription lens = anamorphic();
    const Meridians meridians(lens);
    ASSERT_LT(meridians.aside.focal_length, 0.97 * meridians.up.focal_length);
    const LensRaysAt rays(camera_with(lens, {{"focus", 1e15}}));
    int passed = 0;
    at_points([&](const V2d& point) {
        at_lens([&](const V2d& at) {
            const Ray ray = rays(point, at);
            if (!ray.valid) {
                return;
            }
            ++passed;
            const Line line{
                {meridians.up.entrance_pupil - ray.origin.x, ray.origin.y, ray.origin.z},
                {ray.direction.x, -ray.direction.y, -ray.direction.z}};
            const auto found = on_sensor(lens, line, meridians.up.back_focus);
            ASSERT_TRUE(found) << point << at;
            EXPECT_LT((*found - meridians.sensor_point(point)).length(), 1e-8) << point << at;
            EXPECT_NEAR(ray.direction.length(), 1.0, 1e-13);
        });
    });
    EXPECT_GT(passed, 200);
}

// In the vertical plane the lens is focused far away: light of the middle of the sensor leaves
// parallel to the axis. In the horizontal plane the sensor is behind its focus by the difference of
// both, so that the light meets at f²/difference in front of the front focus. 2 % are the
// aberrations of rays near the axis.
TEST(Anamorphic, HasAFocusForEachMeridian) {
    const Prescription lens = anamorphic();
    const Meridians meridians(lens);
    const LensRaysAt rays(camera_with(lens, {{"focus", 1e15}}));
    const Ray up = rays({200.0, 200.0}, {0.0, 0.01});
    ASSERT_TRUE(up.valid);
    EXPECT_LT(std::abs(up.direction.z), 1e-5 * std::abs(up.origin.z));
    const Ray aside = rays({200.0, 200.0}, {0.01, 0.0});
    ASSERT_TRUE(aside.valid);
    EXPECT_NEAR(aside.direction.z, 0.0, 1e-15);
    const double meeting = aside.origin.x - aside.origin.y / aside.direction.y * aside.direction.x;
    const double behind = meridians.up.back_focus - meridians.aside.back_focus;
    ASSERT_GT(behind, 0.5);
    const double front = meridians.up.entrance_pupil - meridians.aside.front_focus;
    const double wanted = front + std::pow(meridians.aside.focal_length, 2) / behind;
    EXPECT_NEAR(meeting / wanted, 1.0, 0.02);
}

TEST(Anamorphic, HasTheExactFootprint) {
    const LensRaysAt rays(camera_with(anamorphic(), {{"focus", 900.0}}));
    constexpr double step = 1e-3;
    int compared = 0;
    at_points([&](const V2d& point) {
        for (const V2d& at : {V2d(0.0, 0.0), V2d(0.3, -0.4)}) {
            const Ray ray = rays(point, at);
            const Ray right = rays(point + V2d(step, 0.0), at);
            const Ray left = rays(point - V2d(step, 0.0), at);
            if (!ray.valid || !right.valid || !left.valid) {
                continue;
            }
            ++compared;
            // Rounding of 1e-14 over a step, for directions; ten times that for origins.
            EXPECT_LT(
                (ray.direction_by_x - (right.direction - left.direction) / (2.0 * step)).length(),
                1e-10);
            EXPECT_LT((ray.origin_by_x - (right.origin - left.origin) / (2.0 * step)).length(),
                      1e-9);
        }
    });
    EXPECT_GT(compared, 15);
}

// As many rays from the scene, uniform in position and in the sines of their directions, arrive at
// a patch of the sensor as the lens samples of its middle pass.
TEST(Anamorphic, HasExactVignetting) {
    const Prescription lens = anamorphic();
    const Meridians meridians(lens);
    const LensRaysAt rays(camera_with(lens, {{"focus", 1e15}}));
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const double hole = 20.0;
    const double half = 0.14;  // Of the sines of the directions.
    const double patch = 0.8;  // mm, half the side of a square on the sensor.
    const std::array points{V2d(200.0, 200.0), V2d(20.0, 200.0), V2d(200.0, 20.0), V2d(40.0, 40.0)};
    std::array<int, 4> arrived{};
    for (int i = 0; i < 600'000; ++i) {
        const double a = half * uniform(random);
        const double b = half * uniform(random);
        const auto at = on_sensor(lens,
                                  {{0.0, hole * uniform(random), hole * uniform(random)},
                                   {std::sqrt(1.0 - a * a - b * b), a, b}},
                                  meridians.up.back_focus);
        for (std::size_t k = 0; at && k < points.size(); ++k) {
            const V2d off = *at - meridians.sensor_point(points[k]);
            arrived[k] += std::abs(off.x) < patch && std::abs(off.y) < patch;
        }
    }
    const double middle = lit_part(rays, points[0]);
    // The rest is what the pupils of points off both axes need.
    EXPECT_GT(middle, 0.85);
    for (std::size_t k = 1; k < points.size(); ++k) {
        const double wanted = static_cast<double>(arrived[k]) / arrived[0];
        // Four standard deviations of both counts, and 1 % for the size of the patch.
        const double deviation = 4.0 * wanted * std::sqrt(1.0 / arrived[k] + 1.0 / arrived[0]);
        EXPECT_NEAR(lit_part(rays, points[k]) / middle, wanted, deviation + 0.01) << k;
        EXPECT_LT(wanted, 0.95) << k;
    }
}

}  // namespace balcony::rays::test::anamorphic_test
