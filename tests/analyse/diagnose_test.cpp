// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Diagnostics against what is known of a camera: closed forms from the textbook, and faults of
// known place and size.

#include "balcony/diagnose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "../laws/built_in_cameras.hpp"
#include "support.hpp"

namespace balcony::analyse::diagnose_test {
namespace {

using test::camera_of;
using test::findings;
using test::report_on;
using test::standard;
using test::words;

using std::numbers::pi;

TEST(Measures, PinholeHasTheSolidAngleOfPerspective) {
    const double width = 400;
    const CameraReport report = report_on(standard("pinhole", {{"fov", "90deg"}}), width, 300);
    EXPECT_TRUE(report.single_viewpoint);
    EXPECT_FALSE(report.distance);
    EXPECT_EQ(words(report), "");
    // The picture plane is `focal` pixels away; a pixel there has cos^3 / focal^2 of the sphere.
    const double focal = width / 2;
    for (std::size_t i = 0; i < report.samples.size(); i += 997) {
        const V2d off = report.grid.at(i) - V2d(200, 150);
        const double cosine = focal / std::sqrt(focal * focal + off.length2());
        const double expected = pi / 180 * focal / std::pow(cosine, 1.5);
        EXPECT_NEAR(report.samples[i].magnification, expected, 1e-10 * expected);
        EXPECT_NEAR(report.samples[i].anisotropy, 1 / cosine, 1e-10);
        EXPECT_EQ(report.samples[i].orientation, 1);
        EXPECT_EQ(report.samples[i].views, 1);
    }
    // The least is in the middle, the most in a corner.
    EXPECT_LT((report.magnification->min_at.point - V2d(200, 150)).length(), 3.0);
    EXPECT_GT((report.magnification->max_at.point - V2d(200, 150)).length(), 240.0);
}

TEST(Measures, OrthographicShowsAllAlikeAtAnyDistance) {
    const camera::Camera camera = standard("orthographic", {{"width", "8"}});
    for (const auto& distance : {std::optional<double>(), std::optional<double>(100.0)}) {
        const CameraReport report = report_on(camera, 320, 200, distance);
        EXPECT_FALSE(report.single_viewpoint);
        for (const Statistics& row : {*report.magnification, *report.anisotropy}) {
            EXPECT_NEAR(row.maximum, row.minimum, 1e-10);
        }
        EXPECT_NEAR(report.magnification->median, 40.0, 1e-10);
        EXPECT_NEAR(report.anisotropy->median, 1.0, 1e-7);
        EXPECT_EQ(words(report), "");
    }
}

TEST(Measures, EquirectangularIsAsAnisotropicAsTheSecantOfLatitude) {
    const CameraReport report = report_on(standard("panorama"), 400, 200);
    for (std::size_t i = 0; i < report.samples.size(); i += 331) {
        const double latitude = (0.5 - report.grid.at(i).y / 200) * pi;
        const double expected = 1 / std::cos(latitude);
        EXPECT_NEAR(report.samples[i].anisotropy, expected, 1e-9 * expected);
    }
    // Half of the rows lie within 45 degrees of the equator; a row of samples is 1.8 degrees high,
    // in which the secant grows by 0.045.
    EXPECT_NEAR(report.anisotropy->median, std::sqrt(2.0), 0.045);
    // A sphere all round has no seam within the picture, and shows nothing twice.
    EXPECT_EQ(words(report), "");
}

TEST(Measures, TheGridHasAtMostTheRequestedSamples) {
    DiagnoseSettings settings;
    settings.width = 60;
    settings.height = 40;
    const camera::Camera camera = standard("pinhole");
    // A step of 1.5 would do for the first, one of 2 just does for the second.
    for (const std::size_t maximum : {1067, 600}) {
        settings.max_samples = maximum;
        const CameraReport report = *diagnose(camera, settings);
        EXPECT_EQ(report.grid.step, 2.0);
        EXPECT_EQ(report.samples.size(), 600U);
    }
    settings.max_samples = 10'000;
    EXPECT_EQ(diagnose(camera, settings)->grid.step, 1.0);
}

TEST(Measures, OriginsHaveTheirMiddleAndExtent) {
    const CameraReport report =
        report_on(camera_of("camera o { map u = 1 .. -1, v = -1 .. 1\n"
                            "eye surface(u, v) = [5, 3 + u, v - 2] look normal }"),
                  100, 50);
    EXPECT_FALSE(report.single_viewpoint);
    // The outermost samples lie half a pixel within the picture.
    const double width = 2 - 2.0 / 100;
    const double height = 2 - 2.0 / 50;
    EXPECT_NEAR(report.origin_extent, std::hypot(width, height), 1e-12);
    EXPECT_NEAR(*report.distance, report.origin_extent / 4, 1e-12);
    for (std::size_t i = 0; i < report.samples.size(); i += 37) {
        const V2d off = report.grid.at(i) - V2d(50, 25);
        EXPECT_NEAR(report.samples[i].origin_distance, std::hypot(off.x / 50, off.y / 25), 1e-12);
    }
}

// Near to the glass, the rays through the middle of what passes cross each other.
TEST(Measures, ALensIsMeasuredWhereItIsFocused) {
    const auto report_through = [](const std::string& lens, const std::string& eye = "sphere(1)") {
        return report_on(
            camera_of("camera a { aspect 4/3  map u = 0.3 .. -0.3, v = square  eye " + eye +
                      "  toward plane((1, 0, 0))  look absolute  lens " + lens + " }"),
            320, 240);
    };
    EXPECT_NEAR(*report_through("(radius = 0.1, focus = 7)").distance, 7.0, 1e-9);
    const CameraReport far = report_through("(radius = 0.1, focus = 1e300)");
    EXPECT_EQ(*far.distance, far.origin_extent / 4);
    // The front of the glass is 19.95 mm nearer than the entrance pupil, whose width is 24.81 mm
    // and that of the exit pupil 26.54 mm: so m = f/(s - f/p) for the distance s = 2 from it. The
    // zone of the aperture that is traced is sharp 6 mm nearer than the axis.
    const CameraReport glass =
        report_through("table(\"dgauss.dat\", focus = 2, f_number = 8)", "point");
    const double from_glass = 2.0 - 0.01995;
    EXPECT_NEAR(*glass.distance, from_glass, 0.01);
    const double reduced = 1.0 / (2.0 - 0.05036 * 24.81 / 26.54);
    const double there = 320 / 0.6 * reduced * from_glass / *glass.distance;
    const std::size_t middle = glass.samples.size() / 2 + glass.grid.columns / 2;
    EXPECT_NEAR(glass.samples[middle].magnification / there, 1.0, 1e-3);
    EXPECT_EQ(words(glass), "");
}

TEST(Measures, ASmallEyeIsNoPoint) {
    const auto eye = [](const std::string& formula) {
        return report_on(camera_of("camera e { map u = 1 .. -1, v = -1 .. 1\n"
                                   "eye surface(u, v) = " +
                                   formula + " toward plane((1e5, 0, 0)) }"),
                         40, 30);
    };
    EXPECT_FALSE(eye("[0, u/1000, 0]").single_viewpoint);
    EXPECT_TRUE(eye("[0, u/10^12, 0]").single_viewpoint);
    // So far away 1e-6 is no more than rounding.
    EXPECT_TRUE(eye("[10^4, u/10^6, 0]").single_viewpoint);
}

TEST(Measures, ACubeShapedCameraLooksSquarelyAtItsDistance) {
    // Normals of a cylinder of radius 2: at distance 1 a unit of the picture's width is 3/2 as
    // long as on the cylinder.
    const camera::Camera camera =
        camera_of("camera c { map u = 90deg .. -90deg, v = -1 .. 1 eye cylinder(2) look normal }");
    const CameraReport report = report_on(camera, 300, 100, 1.0);
    const double by_x = 3 * pi / 300;
    const double by_y = 2.0 / 100;
    EXPECT_NEAR(report.magnification->median, 1 / std::sqrt(by_x * by_y), 1e-9);
    EXPECT_NEAR(report.anisotropy->median, by_x / by_y, 1e-9);
}

// Where on its line a ray begins makes no picture.
TEST(Measures, OriginsThatSlideAlongTheirRaysChangeNothing) {
    const CameraReport report =
        report_on(camera_of("camera s { map u = 1 .. -1, v = -1 .. 1\n"
                            "eye surface(u, v) = [2*u + u*v, u, v] look along(x) }"),
                  100, 100);
    EXPECT_NEAR(report.magnification->minimum, 50.0, 1e-9);
    EXPECT_NEAR(report.magnification->maximum, 50.0, 1e-9);
    // By roots of differences near 0.
    EXPECT_NEAR(report.anisotropy->maximum, 1.0, 1e-6);
}

TEST(Findings, SuperellipticCameraHasNone) {
    const CameraReport report =
        report_on(camera_of("camera superelliptic {\n"
                            "    aspect 5\n"
                            "    map u = 210.85deg .. -149.15deg, v = -36deg .. 36deg\n"
                            "    eye product(superellipse(1, 25/45, 1/4, by = arc_length),\n"
                            "                superellipse(45, 25, 1/4, by = arc_length))\n"
                            "    look normal\n"
                            "}"),
                  1600, 320);
    EXPECT_EQ(words(report), "");
}

TEST(Findings, BuiltInCamerasHaveNoneButOnPurpose) {
    // These fold, jump or repeat what they show: that is what they are for. The unrolled vase is
    // seen by rays that cross behind its surface.
    std::set<std::string> on_purpose{"droste", "kaleidoscope", "print_gallery", "rollout_profile",
                                     "swing"};
    // The faces of these cube maps do not adjoin.
    on_purpose.insert({"cubemap_3x2", "cubemap_strip", "equiangular_cubemap"});
    // These leave a part of the picture empty.
    on_purpose.insert({"angular_map", "catadioptric_spherical", "cubemap_cross",
                       "cubemap_vertical_cross", "cylindrical_anamorphosis", "mirror_ball",
                       "fisheye_orthographic", "fisheye_polynomial", "fisheye_thoby", "fulldome",
                       "omnimax"});
    for (const std::string& name : laws::single_built_in_cameras()) {
        const camera::Camera camera = standard(name);
        const double width = 500 * std::sqrt(camera.parts().aspect);
        const CameraReport report =
            report_on(camera, std::round(width), std::round(width / camera.parts().aspect));
        EXPECT_EQ(report.has_defects(), on_purpose.contains(name)) << name << ": " << words(report);
    }
}

std::string zoomed(const std::string& strength) {
    return "camera zoomed { map u = 2 .. -2, v = -1 .. 1\n"
           "warp zoom(at = (-1, 0.25), radius = 0.5, strength = " +
           strength + ")\n eye point(0, 0, 0)\n toward plane((1, 0, 0)) }";
}

TEST(Findings, AZoomFoldsBelow32Of81) {
    EXPECT_EQ(words(report_on(camera_of(zoomed("0.4")), 400, 200)), "");
    const CameraReport report = report_on(camera_of(zoomed("0.25")), 400, 200);
    const auto folds = findings(report, FindingKind::fold);
    ASSERT_EQ(folds.size(), 1U) << words(report);
    EXPECT_TRUE(folds[0].defect);
    EXPECT_EQ(folds[0].count, 1U);
    // It folds on a ring where 3 (1 - q)^2 (7 q - 1) > 1; k is -3. Both ends of q by bisection.
    const auto end = [](double inside, double outside) {
        for (int i = 0; i < 60; ++i) {
            const double q = (inside + outside) / 2;
            (3 * (1 - q) * (1 - q) * (7 * q - 1) > 1 ? inside : outside) = q;
        }
        return inside;
    };
    const double ring = pi * 0.25 * (end(3.0 / 7, 1) - end(3.0 / 7, 0));
    // A ring as wide as fifteen samples is known to a few per cent.
    EXPECT_NEAR(folds[0].share, ring / 8, 0.03 * ring / 8);
    const double q = ((folds[0].place.point - V2d(300, 75)) / 50.0).length2();
    EXPECT_TRUE(end(3.0 / 7, 0) < q && q < end(3.0 / 7, 1)) << q;
    EXPECT_FALSE(findings(report, FindingKind::repeated).empty());
}

TEST(Findings, OneSeamOfKnownLength) {
    const camera::Camera straight = camera_of(
        "camera s { map u = 1 .. -1, v = -1 .. 1 eye surface(u, v) = [0, u, v]\n"
        "toward surface(u, v) = [1, u + floor((u - 0.3)/4)/2, v] look relative }");
    const CameraReport report = report_on(straight, 200, 100);
    const auto seams = findings(report, FindingKind::seam);
    ASSERT_EQ(seams.size(), 1U) << words(report);
    EXPECT_NEAR(seams[0].length, 100.0, 1e-9);
    EXPECT_NEAR(seams[0].place.point.x, 70.0, 1e-4);
    EXPECT_NEAR(seams[0].place.parameters.x, 0.3, 1e-5);

    const camera::Camera slanting = camera_of(
        "camera s { map u = 1 .. -1, v = -1 .. 1 eye surface(u, v) = [0, u, v]\n"
        "toward surface(u, v) = [1, u + floor((u - v/2)/4)/2, v] look relative }");
    const CameraReport across = report_on(slanting, 200, 200);
    const auto slant = findings(across, FindingKind::seam);
    ASSERT_EQ(slant.size(), 1U) << words(across);
    EXPECT_NEAR(slant[0].length, 200 * std::sqrt(1.25), 1.0);
}

TEST(Findings, ASeamMarksTheSamplesOnBothSides) {
    const CameraReport report = report_on(
        camera_of("camera s { map u = 1 .. -1, v = -1 .. 1 eye surface(u, v) = [0, u, v]\n"
                  "toward surface(u, v) = [1, u + if(u > 0 && v < -0.5, 1, 0), v]\n"
                  "look relative }"),
        40, 20);
    // To the left of x = 20 and below y = 15.
    for (std::size_t i = 0; i < report.samples.size(); ++i) {
        const V2d at = report.grid.at(i);
        const bool beside = std::abs(at.x - 20) < 1 && at.y > 15;
        const bool above = std::abs(at.y - 15) < 1 && at.x < 20;
        EXPECT_EQ(report.samples[i].seam, beside || above) << at;
    }
}

// The same camera in nanometres and in gigametres.
TEST(Findings, SeamsAreFoundInAnyUnitOfLength) {
    for (const char* unit : {"10^-9", "1", "10^9"}) {
        const std::string scaled = "camera s { let k = " + std::string(unit) +
                                   " map u = 1 .. -1, v = -1 .. 1\n"
                                   "eye surface(u, v) = [0, ";
        const std::string directions =
            "u*k, v*k]\ntoward surface(u, v) = [k, k*(u + if(u > 0.3, 0.1, 0)), v*k]\n"
            "look relative }";
        const std::string origins = "k*(u + if(u > 0.3, 0.1, 0)), v*k]\nlook along(x) }";
        for (const std::string& rest : {directions, origins}) {
            const CameraReport report = report_on(camera_of(scaled + rest), 100, 50);
            EXPECT_EQ(findings(report, FindingKind::seam).size(), 1U) << unit << '\n'
                                                                      << words(report);
        }
    }
}

TEST(Findings, SteepChangesAreNotSeams) {
    const camera::Camera steep = camera_of(
        "camera s { map u = 1 .. -1, v = -1 .. 1 eye surface(u, v) = [0, u, v]\n"
        "toward surface(u, v) = [1, u + tanh(300*(u - 0.3)) + sqrt(abs(v)), v]\n"
        "look relative }");
    EXPECT_TRUE(findings(report_on(steep, 200, 100), FindingKind::seam).empty());
    // Over a ten thousandth of a pixel, too.
    const camera::Camera steepest = camera_of(
        "camera s { map u = 1 .. -1, v = -1 .. 1 eye surface(u, v) = [0, u, v]\n"
        "toward surface(u, v) = [1, u + tanh(10^6*(u - 0.3)), v] look relative }");
    EXPECT_TRUE(findings(report_on(steepest, 200, 100), FindingKind::seam).empty());
}

// Nobody sees a jump by less than what a tenth of a pixel changes beside it.
TEST(Findings, AVisibleJumpInASteepChangeIsASeam) {
    const auto seams = [](const std::string& jump) {
        const CameraReport report = report_on(
            camera_of("camera s { map u = 1 .. -1, v = -1 .. 1 eye surface(u, v) = [0, u, v]\n"
                      "toward surface(u, v) = [1, u + tanh(300*(u - 0.3))/2 + if(u > 0.3, " +
                      jump + ", 0), v] look relative }"),
            200, 100);
        return findings(report, FindingKind::seam).size();
    };
    EXPECT_EQ(seams("0.01"), 0U);
    EXPECT_EQ(seams("0.3"), 1U);
}

TEST(Findings, TwoTurnsShowAllTwice) {
    const camera::Camera camera =
        camera_of("camera c { map u = 360deg .. -360deg, v = -1 .. 1 eye cylinder(1) }");
    // A width for which no two samples have the same ray exactly, too.
    for (const double width : {400.0, 397.0}) {
        const CameraReport report = report_on(camera, width, 100);
        const auto repeated = findings(report, FindingKind::repeated);
        ASSERT_EQ(repeated.size(), 1U) << words(report);
        EXPECT_EQ(repeated[0].share, 1.0);
        EXPECT_NEAR(std::abs(repeated[0].place.point.x - repeated[0].other->point.x), width / 2,
                    0.1);
        for (std::size_t i = 0; i < report.samples.size(); ++i) {
            // What is just in the middle is at both borders, too.
            const bool in_middle = report.grid.at(i).x == width / 2;
            ASSERT_EQ(report.samples[i].views, in_middle ? 3 : 2);
        }
        EXPECT_EQ(report.findings.size(), 1U) << words(report);
        EXPECT_NE(words(report).find(width == 400.0 ? "up to 2 times" : "up to 3 times"),
                  std::string::npos)
            << words(report);
    }
}

// Its normals turn wildly from pixel to pixel, so that any two rays are near in pixels.
TEST(Findings, FractalRockHasNoRepeatedViews) {
    const camera::Camera rock = camera_of(
        "camera rock { map u = 3 .. -3, v = -3 .. 3 eye fractal_plane(octaves = 12) look normal }");
    const CameraReport report = report_on(rock, 320, 320);
    EXPECT_TRUE(findings(report, FindingKind::repeated).empty()) << words(report);
    EXPECT_TRUE(findings(report, FindingKind::seam).empty()) << words(report);
    EXPECT_FALSE(findings(report, FindingKind::fold).empty()) << words(report);
}

TEST(Findings, ARoundPictureFillsAQuarterOfPi) {
    const camera::Camera camera = camera_of(
        "camera round { aspect 1 map u = 1 .. -1, v = -1 .. 1 eye point(0, 0, 0)\n"
        "toward surface(u, v) = [sqrt(1 - u^2 - v^2), u, v] look relative }");
    const CameraReport report = report_on(camera, 250, 250);
    EXPECT_NEAR(report.valid_share, pi / 4, 1e-3);
    const auto none = findings(report, FindingKind::no_ray);
    ASSERT_EQ(none.size(), 1U);
    EXPECT_EQ(none[0].count, 4U);
    EXPECT_NEAR(none[0].share, 1 - pi / 4, 1e-3);
}

TEST(Findings, NoRayAtAll) {
    const CameraReport report =
        report_on(camera_of("camera none { map u = 1 .. -1, v = -1 .. 1 eye point(0, 0, 0)\n"
                            "toward surface(u, v) = [sqrt(-1 - u^2), u, v] look relative }"),
                  50, 50);
    EXPECT_FALSE(report.magnification);
    EXPECT_EQ(words(report), "no point of the picture has a ray\n");
}

TEST(Findings, AMirroredPictureIsReported) {
    const CameraReport report = report_on(
        camera_of(
            "camera m { map u = -1 .. 1, v = -1 .. 1 eye point(0,0,0) toward plane((1, 0, 0)) }"),
        100, 100);
    ASSERT_EQ(report.findings.size(), 1U) << words(report);
    EXPECT_EQ(report.findings[0].kind, FindingKind::mirrored);
    EXPECT_FALSE(report.has_defects());
}

TEST(Findings, ACameraThatMakesNoUseOfVIsSingular) {
    const CameraReport report = report_on(
        camera_of("camera s { map u = 1 .. -1, v = -1 .. 1 eye point(0, 0, 0) toward circle(1) }"),
        100, 100);
    const auto singular = findings(report, FindingKind::singular);
    ASSERT_EQ(singular.size(), 1U) << words(report);
    EXPECT_EQ(singular[0].share, 1.0);
    EXPECT_FALSE(report.magnification);
}

}  // namespace
}  // namespace balcony::analyse::diagnose_test
