// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/st_maps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "balcony/inverse.hpp"
#include "balcony/lang.hpp"

namespace balcony::bridge::st_map_test {
namespace {

using Overrides = std::vector<lang::Override>;

RayGrid grid_of(const std::string& camera, std::size_t width, std::size_t height,
                const Overrides& set = {}) {
    const auto picture = lang::make_picture(camera, "", set);
    EXPECT_TRUE(picture) << to_text(picture.diagnostics);
    auto grid =
        RayGrid::make(picture->with_fit(camera::Fit::stretch),
                      {.width = width, .height = height, .axes = Axes::z_up, .footprints = true});
    EXPECT_TRUE(grid) << to_text(grid.diagnostics);
    return std::move(*grid);
}

SourceCamera source_of(const std::string& camera, std::size_t width, std::size_t height,
                       const Overrides& set = {}) {
    const auto picture = lang::make_picture(camera, "", set);
    auto locator =
        analyse::Locator::make(picture->with_fit(camera::Fit::stretch), static_cast<double>(width),
                               static_cast<double>(height), 0.0, Axes::z_up);
    EXPECT_TRUE(locator) << to_text(locator.diagnostics);
    return {grid_of(camera, width, height, set),
            std::make_shared<const analyse::Locator>(std::move(*locator))};
}

std::vector<SourcePlace> places_of(const StMap& map) {
    std::vector<SourcePlace> places;
    map.run(0, map.height(), places);
    return places;
}

/// (x, y) in pixels of a map of this size, y from the bottom.
V2d centre(std::size_t i, const StMap& map) {
    return {static_cast<double>(i % map.width()) + 0.5,
            static_cast<double>(map.height()) - static_cast<double>(i / map.width()) - 0.5};
}

TEST(StMap, OfACameraToItselfIsTheIdentity) {
    for (const char* camera : {"pinhole", "panorama", "fisheye"}) {
        const auto map = StMap::make(grid_of(camera, 90, 60), source_of(camera, 90, 60));
        ASSERT_TRUE(map) << to_text(map.diagnostics);
        const std::vector<SourcePlace> places = places_of(*map);
        for (std::size_t i = 0; i < places.size(); ++i) {
            ASSERT_TRUE(places[i].valid) << camera << " " << i;
            const V2d wanted = centre(i, *map) / V2d(90.0, 60.0);
            ASSERT_NEAR(places[i].st.x, wanted.x, 1e-9) << camera << " " << i;
            ASSERT_NEAR(places[i].st.y, wanted.y, 1e-9) << camera << " " << i;
            // Taken within 1e-4 pixel of the place, where they are the same up to a part of 1e-4.
            ASSERT_NEAR(places[i].st_by_x.x, 1.0 / 90.0, 2e-6) << camera << " " << i;
            ASSERT_NEAR(places[i].st_by_y.y, -1.0 / 60.0, 2e-6) << camera << " " << i;
        }
    }
}

TEST(StMap, FromAPanoramaIsLongitudeAndLatitude) {
    const auto map = StMap::make(grid_of("pinhole", 64, 36, {{"fov", "90deg"}, {"yaw", "170deg"}}),
                                 source_of("panorama", 400, 200));
    ASSERT_TRUE(map) << to_text(map.diagnostics);
    EXPECT_TRUE(map->closes());
    const std::vector<SourcePlace> places = places_of(*map);
    double across = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        // The direction (1, y, z), turned by the yaw.
        const V2d at = centre(i, *map) / 32.0 - V2d(1.0, 18.0 / 32.0);
        const double longitude = std::numbers::pi * 170.0 / 180.0 + std::atan2(-at.x, 1.0);
        const double latitude = std::atan2(at.y, std::hypot(1.0, at.x));
        const double s = 0.5 - longitude / (2.0 * std::numbers::pi);
        ASSERT_TRUE(places[i].valid) << i;
        EXPECT_NEAR(std::remainder(places[i].st.x - s, 1.0), 0.0, 1e-9) << i;
        EXPECT_NEAR(places[i].st.y, 0.5 + latitude / std::numbers::pi, 1e-9) << i;
        across = std::max(across, places[i].st_by_x.length());
    }
    // The seam of the panorama is in the picture, and does not look like a jump.
    EXPECT_LT(across, 0.01);
}

TEST(StMap, HasThePhotoWhereTheCameraSeesIt) {
    const auto map = StMap::make(grid_of("panorama", 120, 60),
                                 source_of("pinhole", 160, 90, {{"fov", "90deg"}}));
    ASSERT_TRUE(map) << to_text(map.diagnostics);
    EXPECT_FALSE(map->closes());
    const std::vector<SourcePlace> places = places_of(*map);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const V2d angles = (centre(i, *map) / V2d(120.0, 60.0) - V2d(0.5)) *
                           V2d(2.0 * std::numbers::pi, std::numbers::pi);
        const V2d at(std::tan(angles.x), std::tan(angles.y) / std::cos(angles.x));
        const bool seen =
            std::abs(angles.x) < std::numbers::pi / 4.0 && std::abs(at.y) < 90.0 / 160.0;
        EXPECT_EQ(places[i].valid, seen) << i;
        if (seen && places[i].valid) {
            EXPECT_NEAR(places[i].st.x, 0.5 + at.x / 2.0, 1e-9);
            EXPECT_NEAR(places[i].st.y, 0.5 + at.y / (2.0 * 90.0 / 160.0), 1e-9);
        }
    }
}

TEST(StMap, KnowsWhichPartOfABorderPixelThePhotoShows) {
    // The photo is the middle half of the picture, and its sides pass through pixels.
    const auto map = StMap::make(grid_of("pinhole", 101, 101, {{"fov", "90deg"}}),
                                 source_of("pinhole", 50, 50, {{"fov", "53.13010235415598deg"}}));
    ASSERT_TRUE(map) << to_text(map.diagnostics);
    const std::vector<SourcePlace> places = places_of(*map);
    double area = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        area += places[i].coverage;
        EXPECT_TRUE(!places[i].valid || places[i].coverage > 0.0) << i;
        EXPECT_GE(places[i].st.x, 0.0) << i;
        EXPECT_LE(places[i].st.x, 1.0) << i;
    }
    // The corners of the photo are at 25.25 and 75.75 pixels; a side has a row of four places.
    EXPECT_NEAR(area, 50.5 * 50.5, 1e-9);
    EXPECT_NEAR(places[50 * 101 + 25].coverage, 0.75, 1e-12);
    EXPECT_NEAR(places[25 * 101 + 25].coverage, 0.75 * 0.75, 1e-12);
    // In parts of the picture as in the whole.
    for (const std::size_t row : {0U, 25U, 26U, 100U}) {
        std::vector<SourcePlace> alone;
        map->run(row, 1, alone);
        for (std::size_t x = 0; x < 101; ++x) {
            EXPECT_EQ(alone[x].coverage, places[row * 101 + x].coverage);
            EXPECT_EQ(alone[x].valid, places[row * 101 + x].valid);
        }
    }
}

TEST(Viewpoint, IsThePointThatTheRaysMeet) {
    const Viewpoint one = find_viewpoint(grid_of("pinhole", 40, 30, {{"px", "1e5"}, {"pz", "-3"}}));
    EXPECT_TRUE(one.is_single());
    EXPECT_NEAR((one.point - V3d(1e5, 0.0, -3.0)).length(), 0.0, 1e-6);
    // Rays that start on a sphere and meet in its centre.
    const auto text = std::make_shared<const SourceText>(
        "sphere.cam", "camera ball { map u = 1 .. -1, v = -1 .. 1 eye sphere(3) look normal }");
    const auto picture = lang::make_picture(lang::CameraSource(text), "");
    ASSERT_TRUE(picture) << to_text(picture.diagnostics);
    const auto grid = RayGrid::make(*picture, {.width = 20, .height = 20});
    const Viewpoint ball = find_viewpoint(*grid);
    EXPECT_TRUE(ball.is_single());
    EXPECT_NEAR(ball.spread, 3.0, 1e-9);
}

TEST(Viewpoint, IsMissedByTheDistanceOfTheRays) {
    // Rays that leave a circle of radius 2 along its tangents.
    const auto text = std::make_shared<const SourceText>(
        "ring.cam",
        "camera ring_of_rays { map u = 180deg .. -180deg, v = -1 .. 1 eye cylinder(2) "
        "look tangent(along = u) }");
    const auto picture = lang::make_picture(lang::CameraSource(text), "");
    ASSERT_TRUE(picture) << to_text(picture.diagnostics);
    const RayGrid grid =
        *RayGrid::make(picture->with_fit(camera::Fit::stretch),
                       {.width = 60, .height = 1, .axes = Axes::z_up, .footprints = true});
    const Viewpoint found = find_viewpoint(grid);
    EXPECT_FALSE(found.is_single());
    EXPECT_NEAR(found.largest, 2.0, 1e-6);
    EXPECT_NEAR(found.median, 2.0, 1e-6);
    const auto refused = StMap::make(grid, source_of("panorama", 40, 20));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.diagnostics.front().message.find("at up to 2 scene units"), std::string::npos)
        << to_text(refused.diagnostics);
    const auto allowed = StMap::make(grid, source_of("panorama", 40, 20), Parallax::ignore);
    EXPECT_TRUE(allowed);
    EXPECT_EQ(allowed.diagnostics.size(), 1U);
    EXPECT_FALSE(StMap::make(grid_of("pinhole", 8, 8), source_of("cylinder", 40, 20)));
}

}  // namespace
}  // namespace balcony::bridge::st_map_test
