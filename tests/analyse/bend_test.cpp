// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The inverse along bent rays, and their drawing.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analyse/draw/camera_geometry.hpp"
#include "balcony/diagnose.hpp"
#include "balcony/drawing.hpp"
#include "balcony/inverse.hpp"
#include "support.hpp"

namespace balcony::analyse::bend_test {
namespace {

std::string pinhole(const std::string& bend) {
    return "camera a { aspect 1  map u = 0.5 .. -0.5, v = square  eye point  "
           "toward plane((1, 0, 0))  " +
           bend + " }";
}

const std::string corner = pinhole("bend pinholes([(10, 0, 0), (10, 20, 0)])");

}  // namespace

// The way behind the corner is seen where the way straight on would be: (10, 5, 1) like (15, 0, 1).
TEST(BentInverse, FindsPointsBehindACorner) {
    const auto locator = Locator::make(test::camera_of(corner), 100.0, 100.0);
    ASSERT_TRUE(locator) << to_text(locator.diagnostics);
    EXPECT_EQ(locator->layers().size(), 1U);
    const std::vector<Sighting> found = locator->locate(V3d(10.0, 5.0, 1.0));
    ASSERT_EQ(found.size(), 1U);
    const V2d place(50.0, 50.0 - 100.0 / 15.0);
    EXPECT_LT((found[0].position - place).length(), 1e-6) << found[0].position;
    EXPECT_NEAR(found[0].distance, std::hypot(15.0, 1.0), 1e-9);
    EXPECT_LT(found[0].origin.length(), 1e-12);
    EXPECT_LT(found[0].miss, 1e-9);
}

// No straight part goes on beyond its end: what is straight on is seen to the right, from the
// pinhole (10, -10, 0), by a ray that turns at (40/3, -10/3, 2/3).
TEST(BentInverse, DoesNotFindWhatIsBehindTheTurn) {
    const auto locator = Locator::make(test::camera_of(corner), 100.0, 100.0);
    const std::vector<Sighting> found = locator->locate(V3d(15.0, 0.0, 1.0));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_LT((found[0].position - V2d(75.0, 45.0)).length(), 1e-6) << found[0].position;
    EXPECT_EQ(locator->locate(V3d(5.0, 0.0, 1.0)).size(), 1U);
    // In the plane of the corner, where one part ends and the next begins, once.
    EXPECT_EQ(locator->locate(V3d(10.0, 0.0, 1.0)).size(), 1U);
}

TEST(BentInverse, FollowsAParabola) {
    const std::string text =
        pinhole("bend field(at(x, y, z) = [0, 0, -0.02], length = 20, tolerance = 0.02)");
    const auto locator = Locator::make(test::camera_of(text), 100.0, 100.0);
    ASSERT_TRUE(locator) << to_text(locator.diagnostics);
    // The ray in the middle is at (s, 0, -0.01 s^2).
    const std::vector<Sighting> found = locator->locate(V3d(12.0, 0.0, -1.44));
    ASSERT_EQ(found.size(), 1U);
    // The tolerance, seen from a distance of 12: 100 pixels are 1 at distance 1.
    EXPECT_LT((found[0].position - V2d(50.0, 50.0)).length(), 100.0 * 0.02 / 12.0);
    EXPECT_NEAR(found[0].distance, 12.0 + 0.0004 * 12.0 * 12.0 * 12.0 / 6.0, 0.03);
}

TEST(BentInverse, RefusesTooManyParts) {
    const auto locator = Locator::make(
        test::camera_of(pinhole(
            "bend curve(point(s, x, y, z, dx, dy, dz) = [x + 9*s*dx, y, z + s^2], parts = 100)")),
        100.0, 100.0);
    ASSERT_FALSE(locator);
    EXPECT_NE(to_text(locator.diagnostics).find("have 101 straight parts"), std::string::npos);
}

// The limit is that of parts in the bend; what is behind it is searched too.
TEST(BentInverse, SearchesTheMostParts) {
    const std::string text = pinhole(
        "bend curve(point(s, x, y, z, dx, dy, dz) = [x + 9*s*dx, y + 9*s*dy, z + 9*s*dz + s^2], "
        "parts = 64)");
    const auto locator = Locator::make(test::camera_of(text), 100.0, 100.0);
    ASSERT_TRUE(locator) << to_text(locator.diagnostics);
    // Behind the bend, the ray in the middle rises by 2 in 9.
    EXPECT_EQ(locator->locate(V3d(18.0, 0.0, 3.0)).size(), 1U);
}

// A path of many parts is drawn by few lines, which are near it.
TEST(BentDrawing, LeavesOutCornersThatNobodySees) {
    Depiction depiction;
    depiction.rays = 1;
    const auto arrows_of = [&](const std::string& height) {
        const auto geometry =
            measure_geometry(test::camera_of(pinhole("bend curve(point(s, x, y, z, dx, dy, dz) = "
                                                     "[x + 10*s, y, z + " +
                                                     height + "], parts = 256)")),
                             depiction);
        EXPECT_TRUE(geometry) << to_text(geometry.diagnostics);
        return geometry->cameras[0].geometry.rays;
    };
    EXPECT_EQ(arrows_of("0").size(), 1U);
    const std::vector<Arrow> parabola = arrows_of("5*s^2");
    EXPECT_LT(parabola.size(), 40U);
    EXPECT_TRUE(parabola.back().has_head);
    // The path and its tenth beyond are 12.63 long.
    constexpr double visible = 12.63 / 2000.0;
    for (const Arrow& arrow : parabola) {
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const V3d at = arrow.from + t * (arrow.to - arrow.from);
            if (at.x <= 10.0) {
                EXPECT_NEAR(at.z, 0.05 * at.x * at.x, visible * std::sqrt(2.0)) << at;
            }
        }
    }
}

// The drawn lines follow the path, with one head at its end.
TEST(BentDrawing, ShowsThePathsOfRays) {
    Depiction depiction;
    depiction.rays = 1;
    const auto geometry = measure_geometry(test::camera_of(corner), depiction);
    ASSERT_TRUE(geometry) << to_text(geometry.diagnostics);
    const std::vector<Arrow>& arrows = geometry->cameras[0].geometry.rays;
    ASSERT_EQ(arrows.size(), 2U);
    EXPECT_LT((arrows[0].from - V3d(0.0)).length(), 1e-9);
    EXPECT_LT((arrows[0].to - V3d(10.0, 0.0, 0.0)).length(), 0.1);
    EXPECT_FALSE(arrows[0].has_head);
    EXPECT_LT((arrows[1].from - arrows[0].to).length(), 1e-9);
    EXPECT_TRUE(arrows[1].has_head);
    EXPECT_GT(arrows[1].to.y, 0.5);
    depiction.length = 4.0;
    const auto shorter = measure_geometry(test::camera_of(corner), depiction);
    ASSERT_EQ(shorter->cameras[0].geometry.rays.size(), 1U);
    EXPECT_TRUE(shorter->cameras[0].geometry.rays[0].has_head);
    EXPECT_NEAR(shorter->cameras[0].geometry.rays[0].to.length(), 4.0, 1e-9);
}

// A check is about the first straight parts, which are those of the camera without a bend here.
TEST(BentCheck, IsAboutTheFirstParts) {
    const DiagnoseSettings settings{};
    const auto bent = diagnose(test::camera_of(corner), settings);
    const auto straight = diagnose(test::camera_of(pinhole("")), settings);
    ASSERT_TRUE(bent) << to_text(bent.diagnostics);
    EXPECT_NEAR(bent->magnification->median, straight->magnification->median, 1e-6);
}

}  // namespace balcony::analyse::bend_test
