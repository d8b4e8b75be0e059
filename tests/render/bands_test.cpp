// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Bands: the file is that of the whole film, within the memory that was asked for.

#include "balcony/bands.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::render::test::bands_test {
namespace {

namespace fs = std::filesystem;

scene::Scene two_walls() {
    scene::Scene scene;
    add(scene, wall(-5.0F, 10.0F), white());
    add(scene, parallelogram({-2.0F, -2.0F, -4.0F}, {2.0F, 0.0F, 1.0F}, {0.0F, 3.0F, 0.5F}),
        white());
    return scene;
}

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class Bands : public testing::Test {
protected:
    Renderer renderer = *Renderer::make(std::make_shared<scene::Scene>(two_walls()));
    camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 1.0));
    Settings settings = request(150, 200, "preview", 3);
    FilmLayout layout{.width = 150, .height = 200};
    fs::path folder = fs::path(testing::TempDir()) /
                      (std::string("balcony-bands-") +
                       testing::UnitTest::GetInstance()->current_test_info()->name());

    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }
};

TEST_F(Bands, TheFileIsThatOfTheWholeFilm) {
    for (const std::optional<Region>& window :
         {std::optional<Region>{}, std::optional(Region{20, 11, 100, 150})}) {
        layout.window = window;
        Film film = *make_film(layout);
        ASSERT_TRUE(render::render(renderer, camera, settings, film));
        ASSERT_FALSE(has_errors(write(film, folder / "whole.exr")));
        for (const std::size_t rows : {32U, 96U, 320U}) {
            const auto summary =
                render_in_bands(renderer, camera, settings, layout, rows, folder / "bands.exr");
            ASSERT_TRUE(summary);
            EXPECT_EQ(summary->camera_rays, 3 * film.window.size());
            EXPECT_FALSE(summary->interrupted);
            EXPECT_EQ(bytes_of(folder / "bands.exr"), bytes_of(folder / "whole.exr")) << rows;
        }
    }
}

TEST_F(Bands, HeightsFollowTheMemory) {
    FilmLayout one_row = layout;
    one_row.window = Region{0, 0, 150, tile_height};
    const double row = film_bytes(one_row);
    EXPECT_EQ(band_height(layout, 0.0), tile_height);
    EXPECT_EQ(band_height(layout, 1.5 * row), tile_height);
    EXPECT_EQ(band_height(layout, 3.0 * row), 3 * tile_height);
    EXPECT_GE(band_height(layout, 1e12), layout.height);
}

TEST_F(Bands, AStopLeavesTheRestTransparent) {
    std::stop_source stop;
    const auto summary = render_in_bands(
        renderer, camera, settings, layout, 32, folder / "bands.exr",
        [&](const Progress& progress) {
            if (progress.tiles_done > progress.tiles / 2) {
                stop.request_stop();
            }
        },
        stop.get_token());
    ASSERT_TRUE(summary);
    EXPECT_TRUE(summary->interrupted);
    EXPECT_TRUE(fs::exists(folder / "bands.exr"));
}

TEST_F(Bands, WhatCannotBeIsRefused) {
    const auto refused = [&] {
        const auto summary =
            render_in_bands(renderer, camera, settings, layout, 32, folder / "bands.exr");
        EXPECT_FALSE(summary);
        EXPECT_FALSE(fs::exists(folder / "bands.exr"));
    };
    settings.sampling.noise = 0.01;
    refused();
    settings.sampling.noise = 0.0;
    layout.width = layout.height = 1'000'000;
    refused();
    layout = {.width = 150, .height = 200};
    folder /= "missing";
    refused();
}

}  // namespace
}  // namespace balcony::render::test::bands_test
