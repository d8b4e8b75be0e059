// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// What a report says of faults of known kind, place and size.

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::analyse::findings_test {
namespace {

using test::camera_of;
using test::findings;
using test::report_on;
using test::words;

/// A camera at the origin that sees (1, y, z) at (u, v); u falls to the right, v rises.
camera::Camera camera_to(const std::string& y, const std::string& z = "v",
                         const std::string& x = "1") {
    return camera_of(
        "camera c { map u = 1 .. -1, v = -1 .. 1 eye point(0, 0, 0)\n"
        "toward surface(u, v) = [" +
        x + ", " + y + ", " + z + "] look relative }");
}

TEST(NoRay, IsFoundInTheMiddleOfTheLargestRegion) {
    const CameraReport report =
        report_on(camera_to("u", "v",
                            "1 + sqrt((u - 0.5)^2 + (v - 0.5)^2 - 0.04)/99\n"
                            "+ sqrt((u + 0.4)^2 + (v + 0.4)^2 - 0.16)/99"),
                  100, 100);
    const auto none = findings(report, FindingKind::no_ray);
    ASSERT_EQ(none.size(), 1U) << words(report);
    EXPECT_EQ(none[0].count, 2U);
    EXPECT_LE((none[0].place.point - V2d(70, 70)).length(), 1.0) << none[0].place.point;
}

double area_of(const std::vector<Imath::Box2d>& boxes) {
    double area = 0.0;
    for (const Imath::Box2d& box : boxes) {
        area += box.size().x * box.size().y;
    }
    return area;
}

TEST(Finding, HasTheSamplesThatItIsAbout) {
    // Without a ray where u > 0.5, which is the left quarter; mirrored where u < -0.5; a seam
    // there.
    const CameraReport report =
        report_on(camera_to("if(u < -0.5, -3 - u, u)", "v", "1 + sqrt(0.5 - u)/1e6"), 100, 40);
    const auto none = findings(report, FindingKind::no_ray);
    ASSERT_EQ(none.size(), 1U) << words(report);
    const auto left = report.grid.cells_of(none[0].samples);
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0], Imath::Box2d({0, 0}, {25, 40}));
    const auto mirrored = findings(report, FindingKind::mirrored);
    ASSERT_EQ(mirrored.size(), 1U) << words(report);
    const auto right = report.grid.cells_of(mirrored[0].samples);
    ASSERT_EQ(right.size(), 1U);
    EXPECT_EQ(right[0], Imath::Box2d({75, 0}, {100, 40}));
    // One cell on each side of the line.
    const auto seams = findings(report, FindingKind::seam);
    ASSERT_EQ(seams.size(), 1U) << words(report);
    const auto seam = report.grid.cells_of(seams[0].samples);
    ASSERT_EQ(seam.size(), 1U);
    EXPECT_EQ(seam[0], Imath::Box2d({74, 0}, {76, 40}));
}

TEST(Finding, TheCellsOfAGridCoverThePicture) {
    const SampleGrid grid = SampleGrid::over(10, 7, 3);  // 3 by 2 cells, a remainder at each side.
    const std::vector<Imath::Box2d> all = grid.cells_of({0, 1, 2, 3, 4, 5});
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0], Imath::Box2d({0, 0}, {10, 7}));
    EXPECT_TRUE(grid.cells_of({}).empty());
    // The ends of rows do not run on into the next.
    EXPECT_EQ(grid.cells_of({2, 3}).size(), 2U);
    EXPECT_EQ(grid.cells_of({1, 4})[0], Imath::Box2d({3.5, 0}, {6.5, 7}));
    const SampleGrid fine = SampleGrid::over(9, 9, 1);
    std::vector<std::size_t> disc;
    for (std::size_t i = 0; i < fine.size(); ++i) {
        if ((fine.at(i) - V2d(4.5, 4.5)).length() < 4.0) {
            disc.push_back(i);
        }
    }
    EXPECT_EQ(area_of(fine.cells_of(disc)), static_cast<double>(disc.size()));
}

TEST(Mirrored, PartsAreCountedByTheSeamsBetweenThem) {
    const CameraReport report =
        report_on(camera_to("if(u > -0.3, u, if(v > 0, 4 - u, 8 - u))"), 100, 40);
    const auto mirrored = findings(report, FindingKind::mirrored);
    ASSERT_EQ(mirrored.size(), 1U) << words(report);
    EXPECT_EQ(mirrored[0].message, "35 % of the picture, in 2 regions, is mirrored");
    EXPECT_FALSE(mirrored[0].defect);
    // What lies beyond a seam is not what the picture folds against.
    EXPECT_TRUE(findings(report, FindingKind::fold).empty()) << words(report);
    // Defects come first.
    EXPECT_EQ(report.findings.front().kind, FindingKind::seam);
    EXPECT_EQ(report.findings.back().kind, FindingKind::mirrored);
}

TEST(Mirrored, MostOfThePictureIsReportedOnce) {
    const CameraReport report = report_on(camera_to("if(u > 0.3, u, 4 - u)"), 100, 40);
    const auto mirrored = findings(report, FindingKind::mirrored);
    ASSERT_EQ(mirrored.size(), 1U) << words(report);
    EXPECT_EQ(mirrored[0].message, "most of the picture, 65 %, is mirrored");
}

TEST(Mirrored, BehindWhereRaysCross) {
    // All rays meet the line from (1, 0, -1) to (1, 0, 1), and the outermost are sqrt(2) long
    // there.
    const camera::Camera crossing = camera_of(
        "camera c { map u = 1 .. -1, v = -1 .. 1 eye surface(u, v) = [0, u, v]\n"
        "toward surface(u, v) = [1, 0, v] look relative }");
    EXPECT_EQ(words(report_on(crossing, 40, 40, 0.9)), "");
    EXPECT_EQ(
        words(report_on(crossing, 40, 40, 3.0)),
        "the picture is mirrored at a distance of 3, beyond the point where its rays cross\n");
    const camera::Camera mirrored =
        camera_of("camera m { map u = -1 .. 1, v = -1 .. 1 eye plane((0, 0, 0)) look normal }");
    EXPECT_EQ(words(report_on(mirrored, 40, 40, 3.0)), "the picture is mirrored\n");
}

TEST(Fold, IsFoundAcrossALineOfSingularSamples) {
    // In pictures of an odd width a column of samples lies just where u is 0.
    const CameraReport report = report_on(camera_to("u^2"), 101, 40);
    const auto folds = findings(report, FindingKind::fold);
    ASSERT_EQ(folds.size(), 1U) << words(report);
    EXPECT_NEAR(folds[0].share, 50.0 / 101, 1e-12);
    EXPECT_EQ(folds[0].other->point.x, 49.5);
}

TEST(Fold, OfAFewSamplesIsNone) {
    // Two samples lie in the square that is turned round.
    const CameraReport report =
        report_on(camera_to("if(abs(u - 0.01) < 0.015 && abs(v) < 0.015, -u, u)"), 100, 100);
    EXPECT_TRUE(findings(report, FindingKind::fold).empty()) << words(report);
    EXPECT_TRUE(findings(report, FindingKind::mirrored).empty()) << words(report);
}

// The advice is about the stages that make the picture fold, and about no others.
TEST(Fold, AdviceFitsTheCause) {
    const auto advice = [](const std::string& warp, const std::string& y) {
        const CameraReport report =
            report_on(camera_of("camera c { map u = 1 .. -1, v = -1 .. 1 " + warp +
                                " eye point(0, 0, 0) toward surface(u, v) = [1, " + y +
                                ", v] look relative }"),
                      100, 40);
        const auto folds = findings(report, FindingKind::fold);
        return folds.empty() ? words(report) : folds[0].remedy;
    };
    const std::string zoom = "warp zoom(at = (0, 0), radius = 0.5, strength = 0.2)";
    const std::string harmless = "warp zoom(at = (0, 0), radius = 0.5, strength = 2)";
    const std::string of_warp =
        "if this is unintended, make the warp of the parameters there weaker or wider";
    const std::string of_object =
        "if this is unintended, look for an object or a formula that turns back along u or v there";
    EXPECT_EQ(advice(zoom, "u"), of_warp);
    EXPECT_EQ(advice("", "u^3 - u/2"), of_object);
    EXPECT_EQ(advice(harmless, "u^3 - u/2"), of_object);
}

TEST(Seams, BeyondTheEighthAreOneFinding) {
    const CameraReport report = report_on(camera_to("u + floor((u + 1)*5.5)/2"), 110, 40);
    const auto seams = findings(report, FindingKind::seam);
    ASSERT_EQ(seams.size(), 9U) << words(report);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(seams[i].count, 1U);
        EXPECT_NEAR(seams[i].length, 40.0, 1e-9);
    }
    EXPECT_EQ(seams[8].count, 2U);
    EXPECT_EQ(seams[8].message, "rays jump along 2 more lines, 80 pixels in total");
}

TEST(Seams, SayTheLargestAngle) {
    const CameraReport report = report_on(camera_to("u + if(u > 0.3, 0.3 + 0.2*v, 0)"), 100, 100);
    double largest = 0.0;
    for (int row = 0; row < 100; ++row) {
        const double v = 0.99 - 0.02 * row;
        const V3d a(1.0, 0.3, v);
        const V3d b(1.0, 0.6 + 0.2 * v, v);
        largest = std::max(largest, std::atan2(a.cross(b).length(), a.dot(b)));
    }
    const auto seams = findings(report, FindingKind::seam);
    ASSERT_EQ(seams.size(), 1U) << words(report);
    EXPECT_EQ(seams[0].message,
              fmt::format("rays jump along a line of 100 pixels, directions by up to {:.3g} deg",
                          largest * 180.0 / std::numbers::pi));
}

TEST(Singular, AtASinglePointIsNoDefect) {
    const CameraReport report = report_on(camera_to("u*(u^2 + v^2)", "v*(u^2 + v^2)"), 101, 101);
    const auto singular = findings(report, FindingKind::singular);
    ASSERT_EQ(singular.size(), 1U) << words(report);
    EXPECT_FALSE(singular[0].defect);
    EXPECT_EQ(singular[0].place.point, V2d(50.5, 50.5));
    EXPECT_TRUE(singular[0].message.starts_with("in less than 0.1 % of the picture, in one region"))
        << singular[0].message;
}

camera::Camera twice_round(const std::string& eye, const std::string& move = "") {
    return camera_of("camera c { map u = 360deg .. -360deg, v = -1 .. 1\n eye " + eye +
                     " look normal " + move + " }");
}

double repeated_share(const camera::Camera& camera) {
    // A width for which no two samples have the same ray exactly.
    const auto repeated = findings(report_on(camera, 197, 50), FindingKind::repeated);
    return repeated.empty() ? 0.0 : repeated[0].share;
}

TEST(Repeated, IsFoundFarFromTheOrigin) {
    EXPECT_EQ(repeated_share(twice_round("cylinder(1)", "move translate(1000, 500, 0)")), 1.0);
}

TEST(Repeated, RaysMayBeginElsewhereOnTheirLine) {
    EXPECT_EQ(repeated_share(twice_round(
                  "surface(u, v) = [if(u > 0, 1, 2)*cos(u), if(u > 0, 1, 2)*sin(u), v]")),
              1.0);
}

TEST(Repeated, IsFoundWhereTheGridIsSheared) {
    // A turn rises by 2 pi of the height, 8: what is less than that from an end is seen once.
    const double share = repeated_share(twice_round("surface(u, v) = [cos(u), sin(u), 4*v + u]"));
    EXPECT_NEAR(share, 1.0 - std::numbers::pi / 4, 1.0 / 50);  // A row.
}

}  // namespace
}  // namespace balcony::analyse::findings_test
