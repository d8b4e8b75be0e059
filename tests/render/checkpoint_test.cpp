// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Checkpoints: everything that a render adds up returns, and nothing from a damaged file.

#include "balcony/checkpoint.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "balcony/shard.hpp"
#include "film/sums/film_arrays.hpp"
#include "support.hpp"

namespace balcony::render::test::checkpoint_test {
namespace {

namespace fs = std::filesystem;

LayerSet all_layers() {
    LayerSet all;
    for (const LayerInfo& info : render::layers()) {
        all.insert(info.id);
    }
    return all;
}

const FilmLayout layout{.width = 70,
                        .height = 40,
                        .window = Region{3, 2, 64, 36},
                        .layers = all_layers(),
                        .second_moment = true};

const FilmFacts facts{.sums = {{"--seed", "3"}, {"the file 'a.obj'", "#12ab"}},
                      .layers = {{"--layers", "all"}, {"--denoise", ""}}};

// Every array is filled with bytes that say which it is.
Film filled_film() {
    Film film = *make_film(layout);
    film.display.assign(film.window.size(), Color4d(0.0));
    film.mirrored.assign(film.window.size(), Color4d(0.0));
    film.pixel_passes.assign(film.window.size(), 0);
    film.first_half.assign(film.window.size(), Color4d(0.0));
    int value = 0;
    for_each_array(film, [&](auto& array) {
        EXPECT_FALSE(array.empty());
        ++value;
        for (auto& element : std::as_writable_bytes(std::span(array))) {
            element = static_cast<std::byte>(value);
        }
    });
    return film;
}

Film empty_film() {
    Film film = *make_film(layout);
    film.display.assign(film.window.size(), Color4d(0.0));
    film.mirrored.assign(film.window.size(), Color4d(0.0));
    film.pixel_passes.assign(film.window.size(), 0);
    film.first_half.assign(film.window.size(), Color4d(0.0));
    return film;
}

std::vector<std::byte> bytes_of(const Film& film) {
    std::vector<std::byte> all;
    for_each_array(film, [&](const auto& array) {
        const auto bytes = std::as_bytes(std::span(array));
        all.insert(all.end(), bytes.begin(), bytes.end());
    });
    return all;
}

class Checkpoint : public testing::Test {
protected:
    const files::TemporaryFolder folder;
    const fs::path file = folder / "p.checkpoint";

    [[nodiscard]] std::string contents() const { return files::bytes_of(file); }
    void replace(const std::string& bytes) const { folder.write(file.filename(), bytes); }
};

TEST_F(Checkpoint, EverythingReturns) {
    const Film film = filled_film();
    // An array that is not visited would neither be filled nor compared.
    for (const auto* sums :
         {&film.sum, &film.sum_of_squares, &film.display, &film.mirrored, &film.first_half}) {
        EXPECT_NE(sums->front(), Color4d(0.0));
    }
    EXPECT_NE(film.passes.front(), 0U);
    EXPECT_NE(film.pixel_passes.front(), 0U);
    EXPECT_NE(film.white, 0.0);
    ASSERT_FALSE(has_errors(write_checkpoint(film, facts, {}, file)));
    Film read = empty_film();
    ASSERT_FALSE(has_errors(read_checkpoint(read, facts, file)));
    EXPECT_EQ(bytes_of(read), bytes_of(film));
    EXPECT_FALSE(fs::exists(file.string() + ".new"));
}

TEST_F(Checkpoint, OtherFactsAreRefusedByName) {
    ASSERT_FALSE(has_errors(write_checkpoint(filled_film(), facts, {}, file)));
    const auto message = [&](const RenderFacts& now) {
        Film read = empty_film();
        const Diagnostics found = read_checkpoint(read, {.sums = now}, file);
        EXPECT_TRUE(has_errors(found));
        EXPECT_EQ(bytes_of(read), bytes_of(empty_film()));
        return found.empty() ? "" : found.front().message;
    };
    EXPECT_NE(message({{"--seed", "4"}, facts.sums[1]}).find("--seed was '3' and is '4'"),
              std::string::npos);
    EXPECT_NE(message({facts.sums[0], {"the file 'a.obj'", "#12ac"}}).find("'a.obj' has changed"),
              std::string::npos);
    EXPECT_NE(message({facts.sums[0]}).find("the file 'a.obj' is missing"), std::string::npos);
    EXPECT_NE(message({facts.sums[0], facts.sums[1], {"--lens", "2"}}).find("--lens is new"),
              std::string::npos);
}

TEST_F(Checkpoint, TheHeadingReturns) {
    const std::vector<std::uint64_t> finished{3, 1, 4};
    ASSERT_FALSE(has_errors(write_checkpoint(filled_film(), facts, finished, file)));
    const auto heading = read_checkpoint_heading(file);
    ASSERT_TRUE(heading);
    EXPECT_TRUE(difference(heading->facts.sums, facts.sums).empty());
    EXPECT_TRUE(difference(heading->facts.layers, facts.layers).empty());
    EXPECT_EQ(heading->width, layout.width);
    EXPECT_EQ(heading->height, layout.height);
    EXPECT_EQ(heading->window, layout.window);
    EXPECT_EQ(heading->finished, finished);
}

TEST_F(Checkpoint, AnotherWindowIsRefused) {
    ASSERT_FALSE(has_errors(write_checkpoint(filled_film(), facts, {}, file)));
    FilmLayout other = layout;
    other.window->y = 1;
    Film read = *make_film(other);
    const Diagnostics found = read_checkpoint(read, facts, file);
    ASSERT_TRUE(has_errors(found));
    EXPECT_NE(found.front().message.find("64x36+3+2 of 70x40 and is 64x36+3+1 of 70x40"),
              std::string::npos)
        << found.front().message;
}

TEST_F(Checkpoint, LayersMayBeLeftOutButNotAdded) {
    FilmLayout fewer = layout;
    fewer.second_moment = false;
    fewer.layers = {};
    fewer.data_layers = false;
    ASSERT_FALSE(has_errors(write_checkpoint(filled_film(), facts, {}, file)));
    Film read = *make_film(fewer);
    ASSERT_TRUE(read_checkpoint(read, facts, file).empty());
    EXPECT_EQ(read.sum, filled_film().sum);
    EXPECT_TRUE(read.sum_of_squares.empty());
    EXPECT_FALSE(read.layers);

    ASSERT_FALSE(
        has_errors(write_checkpoint(read, {facts.sums, {{"--layers", "none"}}}, {}, file)));
    Film all = empty_film();
    const Diagnostics found = read_checkpoint(all, facts, file);
    ASSERT_TRUE(has_errors(found));
    EXPECT_EQ(found.front().kind, Kind::input);
    EXPECT_NE(found.front().message.find("--layers was 'none' and is 'all'"), std::string::npos)
        << found.front().message;
    EXPECT_EQ(bytes_of(all), bytes_of(empty_film()));
}

// Of what this render does not need; the last array of a film is among them.
TEST_F(Checkpoint, ArraysMayBeEmpty) {
    const auto without = [](Film film) {
        film.display.clear();
        film.pixel_passes.clear();
        film.means.emission.clear();
        film.layers->motion.clear();
        return film;
    };
    const Film film = without(filled_film());
    ASSERT_FALSE(has_errors(write_checkpoint(film, facts, {}, file)));
    Film read = without(empty_film());
    ASSERT_FALSE(has_errors(read_checkpoint(read, facts, file)));
    EXPECT_EQ(bytes_of(read), bytes_of(film));
    // A film that needs them does not take those of a checkpoint as they are.
    Film all = empty_film();
    const Diagnostics found = read_checkpoint(all, facts, file);
    ASSERT_TRUE(has_errors(found));
    EXPECT_NE(found.front().message.find("it is damaged"), std::string::npos);
    EXPECT_EQ(bytes_of(all), bytes_of(empty_film()));
}

TEST_F(Checkpoint, ArraysOfAnotherSizeAreRefused) {
    Film larger = filled_film();
    larger.display.push_back(larger.display.back());
    ASSERT_FALSE(has_errors(write_checkpoint(larger, facts, {}, file)));
    Film read = empty_film();
    const Diagnostics found = read_checkpoint(read, facts, file);
    ASSERT_TRUE(has_errors(found));
    EXPECT_NE(found.front().message.find("it is damaged"), std::string::npos);
    EXPECT_EQ(bytes_of(read), bytes_of(empty_film()));
}

// The file of a shard is as long as its parts say, at any place where it may end.
TEST_F(Checkpoint, ATruncatedShardIsNotWhole) {
    ASSERT_FALSE(has_errors(
        write_shard(filled_film(), {.shard = {0, 3}, .facts = facts.sums, .finish = {}}, file)));
    EXPECT_TRUE(is_whole_shard(file));
    const std::string whole = contents();
    for (std::size_t missing = 1; missing < whole.size(); missing += missing < 99 ? 1 : 997) {
        fs::resize_file(file, whole.size() - missing);
        EXPECT_FALSE(is_whole_shard(file)) << missing;
    }
    replace(whole + "x");
    EXPECT_FALSE(is_whole_shard(file));
    fs::remove(file);
    EXPECT_FALSE(is_whole_shard(file));
}

TEST_F(Checkpoint, DamagedFilesAreRefusedAndChangeNothing) {
    ASSERT_FALSE(has_errors(write_checkpoint(filled_film(), facts, {}, file)));
    const std::string whole = contents();
    std::mt19937 random(1);
    const auto refused = [&](const std::string& bytes) {
        replace(bytes);
        Film read = empty_film();
        EXPECT_TRUE(has_errors(read_checkpoint(read, facts, file)));
        EXPECT_EQ(bytes_of(read), bytes_of(empty_film()));
    };
    for (int i = 0; i < 40; ++i) {
        refused(whole.substr(0, random() % whole.size()));
        std::string flipped = whole;
        // The first bytes, which say how long the parts are, more often than the others.
        const std::size_t range = i % 2 == 0 ? 200 : whole.size();
        flipped[random() % range] ^= static_cast<char>(1U << random() % 8);
        refused(flipped);
    }
    refused(whole + "x");
    fs::remove(file);
    Film read = empty_film();
    EXPECT_TRUE(has_errors(read_checkpoint(read, facts, file)));
}

TEST_F(Checkpoint, ALinkInPlaceOfItsTemporaryFileIsNotFollowed) {
    const fs::path precious = file.string() + ".precious";
    std::ofstream(precious) << "precious";
    fs::create_symlink(precious, file.string() + ".new");
    EXPECT_TRUE(has_errors(write_checkpoint(filled_film(), facts, {}, file)));
    EXPECT_EQ(fs::file_size(precious), 8U);
    EXPECT_TRUE(fs::is_symlink(file.string() + ".new"));
    fs::remove(file.string() + ".new");
    fs::remove(precious);
}

TEST_F(Checkpoint, APlaceThatCannotBeWrittenIsAnError) {
    const fs::path nowhere = folder / "no such folder" / "p.checkpoint";
    const Diagnostics found = write_checkpoint(filled_film(), facts, {}, nowhere);
    ASSERT_TRUE(has_errors(found));
    EXPECT_NE(found.front().message.find("No such file or directory"), std::string::npos);
}

}  // namespace
}  // namespace balcony::render::test::checkpoint_test
