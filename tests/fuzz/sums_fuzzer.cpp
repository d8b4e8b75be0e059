// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Any bytes, as changes of files with the sums of a film → the films of checkpoints and of merged
// shards, or errors. A film that is read can be written. The hashes in the files are not checked in
// this build, as those that someone forges would be right, too.

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "../files/temporary_folder.hpp"
#include "balcony/shard.hpp"
#include "demand.hpp"

namespace {

using namespace balcony;
using namespace balcony::render;
namespace fs = std::filesystem;

// The corner of four tiles, with all layers.
Film small_film() {
    FilmLayout layout{.width = 70, .height = 40, .window = Region{62, 30, 4, 4}};
    layout.layers = *find_layers("all");
    layout.second_moment = true;
    Film film = *make_film(layout);
    std::fill(film.passes.begin(), film.passes.end(), 4U);
    std::fill(film.sum.begin(), film.sum.end(), Color4d(1.0, 2.0, 3.0, 4.0));
    film.objects = {"vase"};
    film.materials = {"clay"};
    film.picture_layers = {"picture"};
    return film;
}

const RenderFacts facts{{"samples", "4"}, {"scene", "#1234"}};

// Files in a folder that is there while the fuzzer runs.
class Files {
public:
    Files() : film_(small_film()) {
        keep(write_checkpoint(film_, {facts, {}}, {}, file(0)));
        for (const Shard shard : {Shard{0, 2}, Shard{1, 2}, Shard{0, 1}}) {
            keep(write_shard(film_, {shard, facts, {}, {.output = "a.png"}}, file(0)));
        }
    }

    [[nodiscard]] fs::path file(std::size_t number) const {
        return folder_ / std::to_string(number);
    }
    [[nodiscard]] const Film& film() const { return film_; }
    // The bytes of a checkpoint, of two shards of one picture, and of one that has all of it.
    [[nodiscard]] std::size_t count() const { return originals_.size(); }
    [[nodiscard]] const std::string& original(std::size_t number) const {
        return originals_[number];
    }
    void write(std::size_t number, const std::string& bytes) const {
        std::ofstream(file(number), std::ios::binary) << bytes;
    }

private:
    void keep(const Diagnostics& written) {
        demand(written.empty(), "a film is not written");
        std::ifstream stream(file(0), std::ios::binary);
        originals_.emplace_back(std::istreambuf_iterator<char>(stream),
                                std::istreambuf_iterator<char>());
    }

    files::TemporaryFolder folder_;
    Film film_;
    std::vector<std::string> originals_;
};

// Each change takes six bytes: what is done, where, with what, how often.
std::string changed(std::string text, std::span<const std::uint8_t> changes) {
    constexpr std::size_t size = 6;
    for (; changes.size() >= size; changes = changes.subspan(size)) {
        const std::size_t at =
            std::min<std::size_t>((std::size_t{changes[1]} << 8U) + changes[2], text.size());
        const std::size_t times = changes[5];
        const auto byte = static_cast<char>(changes[3]);
        switch (changes[0] % 4) {
            case 0: text.replace(at, std::min<std::size_t>(1, text.size() - at), 1, byte); break;
            case 1: text.insert(at, times, byte); break;
            case 2: text.erase(at, times); break;
            default: text.resize(at);
        }
    }
    return text;
}

void use(const Film& film, const fs::path& file) {
    (void)automatic_exposure(film);
    (void)encode(film, *Finish{.output = "a.png"}.display_format());
    (void)write_exr(film, file);
}

void read_as_checkpoint(const Files& files) {
    const Result<CheckpointHeading> heading = read_checkpoint_heading(files.file(0));
    demand(heading.value.has_value() != has_errors(heading.diagnostics),
           "neither a heading nor an error");
    Film film = files.film();
    const Diagnostics read = read_checkpoint(film, {facts, {}}, files.file(0));
    demand(heading || has_errors(read), "a checkpoint without a heading is read");
    use(film, files.file(files.count()));
}

void read_as_shards(const Files& files, std::span<const fs::path> shards) {
    (void)is_whole_shard(shards[0]);
    const Result<Film> merged = merge_shards(shards);
    demand(merged.value.has_value() != has_errors(merged.diagnostics), "neither film nor error");
    if (merged) {
        use(*merged, files.file(files.count()));
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const Files files;
    if (count == 0) {
        return 0;
    }
    const std::size_t number = bytes[0] % files.count();
    for (std::size_t i = 0; i < files.count(); ++i) {
        const auto changes = std::span(bytes + 1, i == number ? count - 1 : 0);
        files.write(i, changed(files.original(i), changes));
    }
    if (number == 0) {
        read_as_checkpoint(files);
    } else if (number == 3) {
        read_as_shards(files, std::array{files.file(3)});
    } else {
        read_as_shards(files, std::array{files.file(1), files.file(2)});
    }
    return 0;
}
