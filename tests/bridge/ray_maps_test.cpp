// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/ray_maps.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "balcony/lang.hpp"

namespace balcony::bridge::ray_maps_test {
namespace {

RayGrid grid_of(const std::string& camera, std::size_t width, std::size_t height,
                bool footprints = false) {
    const auto picture = lang::make_picture(camera, "");
    EXPECT_TRUE(picture) << to_text(picture.diagnostics);
    auto grid =
        RayGrid::make(*picture, {.width = width, .height = height, .footprints = footprints});
    EXPECT_TRUE(grid) << to_text(grid.diagnostics);
    return std::move(*grid);
}

std::string streamed(const RayGrid& grid, NumberFormat format) {
    std::string all;
    const RaysWritten written = stream_rays(grid, format, [&all](std::span<const char> bytes) {
        all.append(bytes.data(), bytes.size());
        return true;
    });
    EXPECT_TRUE(written.complete);
    EXPECT_EQ(written.rays, grid.size());
    return all;
}

TEST(RayStream, HasTheRaysOfTheCameraInTheOrderOfThePixels) {
    // More than one block of rows, and a width that is no multiple of a tile's.
    constexpr std::size_t width = 2005;  // Of the aspect of the camera.
    constexpr std::size_t height = 401;
    const RayGrid grid = grid_of("superelliptic", width, height);
    const std::string bytes = streamed(grid, NumberFormat::double_precision);
    ASSERT_EQ(bytes.size(), grid.size() * 6 * sizeof(double));
    const auto program = rays::compile(*lang::make_camera("superelliptic", ""), double{width},
                                       double{height}, {.tiles = false, .points = true});
    rays::Scratch scratch;
    rays::RayBatch batch;
    for (std::size_t i = 0; i < grid.size(); i += 97) {
        const double x = static_cast<double>(i % width) + 0.5;
        const double y = static_cast<double>(i / width) + 0.5;
        program->run(rays::Points{std::span(&x, 1), std::span(&y, 1)}, scratch, batch);
        std::array<double, 6> ray{};
        std::memcpy(ray.data(), bytes.data() + i * sizeof ray, sizeof ray);
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_NEAR(ray[static_cast<std::size_t>(axis)], batch.origin(0)[axis], 1e-11);
            ASSERT_NEAR(ray[static_cast<std::size_t>(3 + axis)], batch.direction(0)[axis], 1e-11);
        }
    }
}

TEST(RayGrid, WarnsThatItKnowsNoObjects) {
    const auto text = std::make_shared<const SourceText>(
        "parts.cam", "picture parts { layer panorama layer pinhole { show objects(\"vase*\") } }");
    const auto picture = lang::make_picture(text, "");
    ASSERT_TRUE(picture) << to_text(picture.diagnostics);
    const auto said = [&](const std::string& layer) {
        const auto grid = RayGrid::make(*picture, {.width = 8, .height = 4, .layer = layer});
        EXPECT_TRUE(grid) << to_text(grid.diagnostics);
        return grid.diagnostics.empty() ? "" : grid.diagnostics.front().message;
    };
    EXPECT_EQ(said("1"), "");
    EXPECT_EQ(said("2"),
              "layer 2 of 'parts' shows some objects of the scene, but a map has all rays of its "
              "camera");
}

TEST(RayGrid, SaysWhichLayersThereAreInWordsOfAnyFrontEnd) {
    const auto text = std::make_shared<const SourceText>(
        "two.cam", "picture two { layer panorama layer pinhole }");
    const auto picture = lang::make_picture(text, "");
    ASSERT_TRUE(picture) << to_text(picture.diagnostics);
    const auto grid = RayGrid::make(*picture, {.width = 8, .height = 4});
    ASSERT_FALSE(grid);
    EXPECT_EQ(grid.diagnostics.front().remedy,
              "give one as the layer, by its name or its number; its layers are 1 panorama, "
              "2 pinhole");
}

TEST(RayStream, EndsWhereTheSinkRefuses) {
    const RayGrid grid = grid_of("panorama", 2000, 1000);
    std::size_t calls = 0;
    const RaysWritten written = stream_rays(
        grid, NumberFormat::text, [&calls](std::span<const char>) { return ++calls < 3; });
    EXPECT_EQ(calls, 3U);
    EXPECT_FALSE(written.complete);
    EXPECT_GT(written.rays, 0U);
    EXPECT_LT(written.rays, grid.size());
}

TEST(RayStream, EndsWhenItIsStopped) {
    const RayGrid grid = grid_of("panorama", 2000, 1000);
    std::stop_source stop;
    const RaysWritten written = stream_rays(
        grid, NumberFormat::single_precision,
        [&stop](std::span<const char>) { return stop.request_stop(), true; }, stop.get_token());
    EXPECT_FALSE(written.complete);
    EXPECT_LT(written.rays, grid.size());
}

TEST(RayColumns, CountWhatTheGridHas) {
    EXPECT_EQ(ray_columns(grid_of("panorama", 4, 2)).size(), 9U);
    EXPECT_EQ(ray_columns(grid_of("panorama", 4, 2, true)).size(), 21U);
}

TEST(RayMap, RefusesOtherFiles) {
    const RaysWritten written =
        write_ray_map(grid_of("panorama", 4, 2), "rays.png", NumberFormat::double_precision);
    ASSERT_TRUE(has_errors(written.problems));
    EXPECT_NE(to_text(written.problems).find(".exr or .npy"), std::string::npos);
}

}  // namespace
}  // namespace balcony::bridge::ray_maps_test
