// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Bands: the picture is that of the whole film, in a file that does not depend on the bands.

#include "balcony/bands.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "balcony/checkpoint.hpp"
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

class Bands : public testing::Test {
protected:
    Renderer renderer = *Renderer::make(std::make_shared<scene::Scene>(two_walls()));
    camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 1.0));
    Settings settings = request(150, 200, "preview", 3);
    FilmLayout layout{.width = 150, .height = 200};
    const files::TemporaryFolder folder;

    [[nodiscard]] Result<TiledFile> reopened_file(const Film& film,
                                                  std::vector<std::uint64_t> hashes) const {
        Result<WorkFile> file = TiledFile::open(folder / "p.exr");
        return file ? TiledFile::reopen(std::move(*file), folder / "p.exr", film, window(),
                                        std::move(hashes))
                    : Result<TiledFile>(std::move(file.diagnostics));
    }

    // Renders to the end, or until so many bands are in the file, which then stays unfinished.
    void render_all(BandedRender& bands, TiledFile& file, std::size_t most = 1000) {
        std::size_t count = 0;
        do {
            if (count++ == most) {
                return;
            }
            const auto summary = bands.job().run();
            ASSERT_TRUE(summary && !summary->interrupted);
            ASSERT_TRUE(file.add(bands.film()).empty());
        } while (bands.next());
        ASSERT_TRUE(file.commit().empty());
    }

    std::string rendered(std::size_t rows, const std::string& name) {
        auto bands = BandedRender::make(renderer, camera, settings, layout, rows);
        auto file = TiledFile::create(folder / name, bands->film(), window());
        render_all(*bands, *file);
        EXPECT_FALSE(fs::exists(TiledFile::unfinished(folder / name)));
        return files::bytes_of(folder / name);
    }

    [[nodiscard]] Region window() const {
        return layout.window.value_or(Region{0, 0, layout.width, layout.height});
    }
};

TEST_F(Bands, ThePixelsAreThoseOfTheWholeFilm) {
    for (const std::optional<Region>& part :
         {std::optional<Region>{}, std::optional(Region{20, 11, 100, 150})}) {
        layout.window = part;
        layout.layers = {LayerId::magnification, LayerId::crypto_object, LayerId::variance};
        Film film = *make_film(layout);
        ASSERT_TRUE(render::render(renderer, camera, settings, film));
        // OpenImageIO keeps what it has read of a file, so that each needs a name of its own.
        const std::string kind = part ? "part" : "all";
        ASSERT_FALSE(has_errors(write(film, folder / (kind + " whole.exr"))));
        const std::string first = rendered(64, kind + " bands.exr");
        EXPECT_EQ(first, rendered(128, "more.exr"));
        EXPECT_EQ(first, rendered(256, "one.exr"));
        const OIIO::ImageBuf whole((folder / (kind + " whole.exr")).string());
        const OIIO::ImageBuf tiled((folder / (kind + " bands.exr")).string());
        EXPECT_EQ(tiled.spec().tile_width, 64);
        EXPECT_EQ(tiled.spec().channelnames, whole.spec().channelnames);
        EXPECT_EQ(tiled.roi(), whole.roi());
        const auto difference = OIIO::ImageBufAlgo::compare(whole, tiled, 0.0F, 0.0F);
        EXPECT_EQ(difference.maxerror, 0.0);
        EXPECT_FALSE(difference.error);
    }
}

// As after a crash: bands were appended after the checkpoint, and the one in progress has some of
// its samples.
TEST_F(Bands, AnotherProcessContinuesToTheSameFile) {
    const std::string whole = rendered(64, "whole.exr");
    const FilmFacts facts{.sums = {{"test", "1"}}};
    {
        auto bands = BandedRender::make(renderer, camera, settings, layout, 64);
        auto file = TiledFile::create(folder / "p.exr", bands->film(), window());
        render_all(*bands, *file, 1);
        const std::vector<std::uint32_t> some(bands->film().tile_count(), 2);
        ASSERT_TRUE(bands->job().run(some));
        const auto finished = file->flush(bands->film());
        ASSERT_TRUE(finished);
        ASSERT_TRUE(
            write_checkpoint(bands->film(), facts, *finished, folder / "checkpoint").empty());
        render_all(*bands, *file, 1);
    }
    auto bands = BandedRender::make(renderer, camera, settings, layout, 128);
    const auto heading = read_checkpoint_heading(folder / "checkpoint");
    ASSERT_TRUE(heading);
    EXPECT_EQ(heading->window, (Region{0, 64, 150, 64}));
    ASSERT_TRUE(bands->go_to(heading->window.y, heading->window.height));
    ASSERT_TRUE(read_checkpoint(bands->film(), facts, folder / "checkpoint").empty());
    EXPECT_EQ(bands->film().samples(0, 64), 2U);
    auto file = reopened_file(bands->film(), heading->finished);
    ASSERT_TRUE(file) << to_text(file.diagnostics);
    EXPECT_EQ(file->rows(), 1U);
    render_all(*bands, *file);
    EXPECT_EQ(files::bytes_of(folder / "p.exr"), whole);
}

// Two rows of tiles are in the file; the third is in progress.
TEST_F(Bands, WhatIsDamagedIsRenderedAgain) {
    const std::string whole = rendered(64, "whole.exr");
    const fs::path part = TiledFile::unfinished(folder / "p.exr");
    std::vector<std::uint64_t> finished;
    std::uintmax_t one_row = 0;
    {
        auto bands = BandedRender::make(renderer, camera, settings, layout, 64);
        auto file = TiledFile::create(folder / "p.exr", bands->film(), window());
        render_all(*bands, *file, 1);
        ASSERT_TRUE(file->flush(bands->film()));
        one_row = fs::file_size(part);
        render_all(*bands, *file, 1);
        finished = *file->flush(bands->film());
    }
    ASSERT_EQ(finished.size(), 2U);
    const std::string sound = files::bytes_of(part);
    const auto rows_of = [&](const std::string& bytes) {
        std::ofstream(part, std::ios::binary) << bytes;
        auto bands = BandedRender::make(renderer, camera, settings, layout, 64);
        auto file = reopened_file(bands->film(), finished);
        const std::size_t rows = file->rows();
        EXPECT_TRUE(rows == 0 || bands->begin_at(rows * file_tile_side));
        render_all(*bands, *file);
        EXPECT_EQ(files::bytes_of(folder / "p.exr"), whole);
        return rows;
    };
    EXPECT_EQ(rows_of(sound), 2U);
    EXPECT_EQ(rows_of(sound + "more"), 2U);
    EXPECT_EQ(rows_of(sound.substr(0, sound.size() - 1)), 1U);
    EXPECT_EQ(rows_of(sound.substr(0, one_row - 1)), 0U);
    const auto chunks = static_cast<std::size_t>(one_row);
    // Single bits of the heads of chunks and of their pixels.
    for (std::size_t at = chunks; at < sound.size(); at += at < chunks + 24 ? 1 : 997) {
        std::string flipped = sound;
        flipped[at] ^= static_cast<char>(1U << at % 8);
        EXPECT_EQ(rows_of(flipped), 1U) << at;
    }
}

TEST_F(Bands, OnlyFilesOfThePictureAreContinued) {
    auto bands = BandedRender::make(renderer, camera, settings, layout, 64);
    const fs::path part = TiledFile::unfinished(folder / "p.exr");
    const auto reopened = [&](const Film& film) {
        return static_cast<bool>(reopened_file(film, {}));
    };
    EXPECT_FALSE(reopened(bands->film()));
    {
        auto file = TiledFile::create(folder / "p.exr", bands->film(), window());
        EXPECT_FALSE(reopened(bands->film())) << "another process has it";
    }
    EXPECT_TRUE(reopened(bands->film()));
    layout.layers = {LayerId::magnification};
    auto others = BandedRender::make(renderer, camera, settings, layout, 64);
    EXPECT_FALSE(reopened(others->film()));
}

TEST_F(Bands, BandsBeginAtTiles) {
    auto bands = BandedRender::make(renderer, camera, settings, layout, 64);
    EXPECT_FALSE(bands->go_to(32, 64));
    EXPECT_FALSE(bands->go_to(32, 32));
    EXPECT_FALSE(bands->go_to(64, 32));
    EXPECT_FALSE(bands->go_to(192, 64));
    EXPECT_FALSE(bands->go_to(0, 0));
    EXPECT_TRUE(bands->go_to(192, 8));
    EXPECT_EQ(bands->done(0.0), 0.96);
    EXPECT_EQ(bands->done(0.5), 0.98);
    EXPECT_FALSE(bands->next());
}

TEST_F(Bands, HeightsFollowTheMemory) {
    FilmLayout one_row = layout;
    one_row.window = Region{0, 0, 150, file_tile_side};
    const double row = film_bytes(one_row);
    EXPECT_EQ(band_height(layout, 0.0), file_tile_side);
    EXPECT_EQ(band_height(layout, 1.5 * row), file_tile_side);
    EXPECT_EQ(band_height(layout, 3.0 * row), 3 * file_tile_side);
    EXPECT_GE(band_height(layout, 1e12), layout.height);
}

TEST_F(Bands, WhatCannotBeIsRefused) {
    const auto refused = [&] {
        EXPECT_FALSE(BandedRender::make(renderer, camera, settings, layout, 64));
    };
    settings.sampling.noise = 0.01;
    refused();
    settings.sampling.noise = 0.0;
    layout.width = layout.height = 1'000'000;
    refused();
    layout = {.width = 150, .height = 200};
    const Film film = *make_film(layout);
    EXPECT_FALSE(TiledFile::create(folder / "missing" / "p.exr", film, window()));
}

}  // namespace
}  // namespace balcony::render::test::bands_test
