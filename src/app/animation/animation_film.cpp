// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/animation/animation_film.hpp"

#include <array>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "app/animation/film_file.hpp"
#include "app/animation/frame_record.hpp"
#include "app/words.hpp"
#include "balcony/input_file.hpp"
#include "balcony/inputs.hpp"

namespace balcony::app {

namespace fs = std::filesystem;

Diagnostics check_inputs(const FramePattern& pattern, const std::vector<fs::path>& inputs) {
    Diagnostics found;
    for (const fs::path& input : inputs) {
        if (const auto frame = pattern.number_of_file(input.filename().string())) {
            add(found, check_overwrites(pattern.file(*frame), std::array{input}));
        }
    }
    return found;
}

void remove_frame_files(const FramePattern& pattern) {
    std::error_code ignored;
    for (const std::string& name : names_in(pattern.folder())) {
        const std::size_t extension = name.find(".png");
        if (extension != std::string::npos &&
            pattern.number_of_file(name.substr(0, extension + 4))) {
            fs::remove(pattern.folder() / name, ignored);
        }
    }
    fs::remove(record_file(pattern), ignored);
    fs::remove(pattern.folder(), ignored);
}

Diagnostics make_film_folder(const FilmRequest& film) {
    const fs::path folder = pattern_of_film(film.file).folder();
    std::error_code failed;
    fs::create_directory(folder, failed);
    return failed
               ? Diagnostics{error(Kind::environment,
                                   fmt::format("the folder '{}' for the frames cannot be made: {}",
                                               folder.string(), failed.message()),
                                   "make room or allow writing there")}
               : Diagnostics{};
}

Diagnostics make_film_of_frames(const FilmRequest& film, const FramePattern& pattern,
                                const FrameNumbers& frames, bool remove_frames,
                                const Observer& observer, const std::stop_token& stop) {
    std::vector<fs::path> pictures;
    for (const std::size_t frame : frames) {
        pictures.push_back(pattern.file(frame));
    }
    const auto progress = [&](std::size_t picture) {
        if (observer.film) {
            observer.film(picture, pictures.size());
        }
    };
    Diagnostics found = write_film(film, pictures, progress, stop);
    progress(pictures.size());
    if (has_errors(found)) {
        if (stop.stop_requested()) {
            return {error(Kind::interrupted, "interrupted before the film was made")};
        }
        found.front().remedy =
            fmt::format("the frames are in '{}'; correct that and give the same command again",
                        pattern.folder().string());
        return found;
    }
    if (remove_frames) {
        remove_frame_files(pattern);
    }
    return {};
}

FramePattern pattern_of_film(const fs::path& film) {
    fs::path folder = film;
    folder += ".frames";
    return *FramePattern::read((folder / "frame.#####.png").string());
}

}  // namespace balcony::app
