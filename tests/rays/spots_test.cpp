// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Spots of lenses: against those that a tracer from the textbook finds, which is held against
// published ones.

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "balcony/prescription.hpp"
#include "lens_tracer.hpp"
#include "support.hpp"

namespace balcony::rays::test::spots_test {
namespace {

using camera::ParaxialLens;
using camera::Prescription;
using camera::Spot;
using std::numbers::pi;

/// Light from above, at an angle with this tangent, from a point of the plane at the distance
/// `plane` behind the first vertex; where it arrives on another plane.
std::optional<V2d> arrival(const Prescription& lens, double tangent, double plane, const V2d& from,
                           double wavelength, double sensor, double stop_scale = 1.0) {
    const double length = std::hypot(tangent, 1.0);
    const auto out =
        through(lens, {{plane, from.x, from.y}, {1.0 / length, 0.0, -tangent / length}}, wavelength,
                stop_scale);
    if (!out) {
        return std::nullopt;
    }
    const V3d at = out->point + (sensor - out->point.x) / out->direction.x * out->direction;
    return V2d(at.y, at.z);
}

struct Traced {
    V2d middle{0.0};
    double rms_radius = 0.0;
    double count = 0.0;
};

/// Of what arrives, the centroid and the root of the mean square distance from `around`, or from
/// it.
Traced spot_of_points(const std::vector<V2d>& points, std::optional<V2d> around = {}) {
    Traced made;
    for (const V2d& p : points) {
        made.middle += p / static_cast<double>(points.size());
    }
    double sum = 0.0;
    for (const V2d& p : points) {
        sum += (p - around.value_or(made.middle)).length2();
    }
    made.count = static_cast<double>(points.size());
    made.rms_radius = std::sqrt(sum / made.count);
    return made;
}

double tangent_of(double degrees) { return std::tan(degrees * pi / 180.0); }

}  // namespace

// The triplet is an example of Optiland 0.2, whose tests state the spots of 6 rings in the entrance
// pupil of 10 mm, around the centroid of 550 nm, 42.20778 mm behind the lens: for the fields 0, 14
// and 20 degrees at 480, 550 and 650 nm, in mm. Its glasses are Hikari's SK16 and Schott's F2.
TEST(Spots, OfATripletAreThosePublished) {
    constexpr std::array<std::array<double, 3>, 3> published{
        {{0.003791335, 0.004293690, 0.006195619},
         {0.015694600, 0.016786721, 0.019109151},
         {0.013229165, 0.012081349, 0.013596802}}};
    const camera::Medium sk16{
        "SK16",
        camera::Medium::Dispersion::schott,
        {2.592001, -0.01540969, 0.0102268, 0.001581559, -0.0001877149, 1.012515e-05}};
    const camera::Medium f2{
        "F2",
        camera::Medium::Dispersion::sellmeier,
        {1.34533359, 0.209073176, 0.937357162, 0.00997743871, 0.0470450767, 111.886764}};
    Prescription lens = read_lens("triplet.dat");
    for (camera::LensSurface& s : lens.surfaces) {
        if (const double n = s.behind.index(camera::line_d); n > 1.0) {
            s.behind = n > 1.6203 ? sk16 : f2;
        }
        s.radius = 15.0;
    }
    const double pupil = camera::paraxial(lens, 0.55).entrance_pupil;
    constexpr int rings = 6;
    for (std::size_t field = 0; field < 3; ++field) {
        const auto points = [&](double wavelength) {
            std::vector<V2d> found;
            for (int ring = 0; ring <= rings; ++ring) {
                const int count = std::max(1, 6 * ring);
                for (int i = 0; i < count; ++i) {
                    const double angle = 2.0 * pi * i / count;
                    const V2d from = 5.0 * ring / rings * V2d(std::cos(angle), std::sin(angle));
                    const auto at = arrival(lens, tangent_of(std::array{0.0, 14.0, 20.0}[field]),
                                            pupil, from, wavelength, length_of(lens) + 42.20778);
                    EXPECT_TRUE(at);
                    found.push_back(*at);
                }
            }
            return found;
        };
        const V2d around = spot_of_points(points(0.55)).middle;
        for (std::size_t color = 0; color < 3; ++color) {
            const double wavelength = std::array{0.48, 0.55, 0.65}[color];
            EXPECT_NEAR(spot_of_points(points(wavelength), around).rms_radius,
                        published[field][color], 1e-6)
                << field << " " << wavelength;
        }
    }
}

// The same light by the other tracer, on a grid of its own. Both have 1 % of the points at the
// border of the light, where the spots of these lenses reach three times their root mean square.
TEST(Spots, AreThoseOfAnotherTracer) {
    constexpr int side = 180;
    struct Case {
        const char* file;
        double degrees, wavelength, f_number, defocus;
    };
    for (const Case& c : {Case{"dgauss.dat", 0.0, camera::line_d, 2.0, 0.0},
                          {"dgauss.dat", 14.0, camera::line_F, 4.0, 0.1},
                          {"triplet.dat", 20.0, camera::line_C, 5.6, 0.0},
                          {"petzval.dat", 8.0, camera::line_d, 2.8, -0.2}}) {
        const Prescription lens = read_lens(c.file);
        const ParaxialLens near_axis = camera::paraxial(lens);
        const double scale = std::min(1.0, near_axis.f_number() / c.f_number);
        const double tangent = tangent_of(c.degrees);
        const double hole = 22.0;
        std::vector<V2d> points;
        for (int i = 0; i < side * side; ++i) {
            const V2d from(hole * ((i % side + 0.5) / side * 2.0 - 1.0),
                           hole * ((i / side + 0.5) / side * 2.0 - 1.0));
            if (const auto at =
                    arrival(lens, tangent, 0.0, from, c.wavelength,
                            length_of(lens) + near_axis.back_focus + c.defocus, scale)) {
                points.push_back(*at);
            }
        }
        const Traced wanted = spot_of_points(points);
        const std::optional<Spot> found = camera::spot_of(lens, {.field = {0.0, tangent},
                                                                 .wavelength = c.wavelength,
                                                                 .f_number = c.f_number,
                                                                 .defocus = c.defocus});
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->rms_radius, wanted.rms_radius, 0.02 * wanted.rms_radius) << c.file;
        EXPECT_NEAR(found->middle[0], 0.0, 1e-9);
        EXPECT_NEAR(found->middle[1], wanted.middle.y, 0.02 * wanted.rms_radius) << c.file;
        const double area =
            wanted.count * std::pow(2.0 * hole / side, 2) / std::hypot(1.0, tangent);
        EXPECT_NEAR(found->area / area, 1.0, 0.02) << c.file;
    }
}

// The light of the axis fills the entrance pupil; from the side it is the same, in other axes.
TEST(Spots, FollowTheField) {
    const Prescription lens = read_lens("dgauss.dat");
    const ParaxialLens near_axis = camera::paraxial(lens);
    const auto middle = camera::spot_of(lens, {.f_number = 8.0});
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->area / (pi * std::pow(near_axis.focal_length / 16.0, 2)), 1.0, 0.01);
    EXPECT_NEAR(middle->middle[0], 0.0, 1e-9);
    EXPECT_NEAR(middle->middle[1], 0.0, 1e-9);
    const auto up = camera::spot_of(lens, {.field = {0.0, 0.2}});
    const auto aside = camera::spot_of(lens, {.field = {0.2, 0.0}});
    ASSERT_TRUE(up && aside);
    EXPECT_NEAR(aside->middle[0], up->middle[1], 1e-9);
    EXPECT_NEAR(aside->rms_radius, up->rms_radius, 1e-9);
    // Upside down, with a distortion of 1 %.
    EXPECT_NEAR(up->middle[1] / (-0.2 * near_axis.focal_length), 1.0, 0.01);
    EXPECT_FALSE(camera::spot_of(lens, {.field = {0.0, 3.0}}));
}

// What a cylinder does not focus arrives as it left: of a disc of radius r, the root mean square of
// one coordinate is r/2. What it does focus is 1/50 of it, at the paraxial focus of f/11.
TEST(Spots, OfACylinderAreLines) {
    const camera::Medium glass{"glass", camera::Medium::Dispersion::none, {1.5}};
    const Prescription lens{"cylinder",
                            {{.curvature = 0.03,
                              .curvature_x = 0.0,
                              .radius = 2.0,
                              .stop = true,
                              .gap = 2.0,
                              .behind = glass},
                             {.radius = 4.0}}};
    const auto spot = camera::spot_of(lens, {});
    ASSERT_TRUE(spot);
    EXPECT_NEAR(spot->rms_radius, 1.0, 0.01);
    Prescription both = lens;
    both.surfaces.front().curvature_x.reset();
    EXPECT_LT(camera::spot_of(both, {})->rms_radius, 0.02);
}

// Of a convex lens, a stop in front of it leaves out what would be farther from the axis: a barrel;
// one behind it, what would be nearer: a pincushion.
TEST(Spots, OfALensBesideItsStopAreDistorted) {
    const camera::Medium glass{"glass", camera::Medium::Dispersion::none, {1.6}};
    const camera::LensSurface front{
        .curvature = 1.0 / 100.0, .radius = 25.0, .gap = 4.0, .behind = glass};
    camera::LensSurface back{.curvature = -1.0 / 100.0, .radius = 25.0};
    camera::LensSurface stop{.radius = 2.0, .stop = true, .gap = 20.0};
    const auto fields_in_front =
        camera::field_spots({.name = "barrel", .surfaces = {stop, front, back}});
    back.gap = 20.0;
    stop.gap = 0.0;
    const auto fields_behind =
        camera::field_spots({.name = "pincushion", .surfaces = {front, back, stop}});
    ASSERT_GE(fields_in_front.size(), 5U);
    ASSERT_GE(fields_behind.size(), 5U);
    EXPECT_EQ(fields_behind.front().distortion, 0.0);
    EXPECT_EQ(fields_behind.front().light, 1.0);
    for (std::size_t i = 1; i < 5; ++i) {
        EXPECT_LT(fields_in_front[i].distortion, 1.5 * fields_in_front[i - 1].distortion) << i;
        EXPECT_GT(fields_behind[i].distortion, 1.5 * fields_behind[i - 1].distortion) << i;
    }
    EXPECT_LT(fields_in_front[4].distortion, -0.005);
    EXPECT_GT(fields_behind[4].distortion, 0.005);
}

}  // namespace balcony::rays::test::spots_test
