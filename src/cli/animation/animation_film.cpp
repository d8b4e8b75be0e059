// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/animation/animation_film.hpp"

#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/animation/animation_options.hpp"
#include "cli/animation/frame_record.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

// Nothing but what this program has written there.
void remove_all(const FramePattern& pattern) {
    std::error_code ignored;
    std::vector<fs::path> files;
    for (fs::directory_iterator entry(pattern.folder(), ignored), end; !ignored && entry != end;
         entry.increment(ignored)) {
        const std::string name = entry->path().filename().string();
        const std::size_t extension = name.find(".png");
        if (extension != std::string::npos &&
            pattern.number_of_file(name.substr(0, extension + 4))) {
            files.push_back(entry->path());
        }
    }
    for (const fs::path& file : files) {
        fs::remove(file, ignored);
    }
    fs::remove(record_file(pattern), ignored);
    fs::remove(pattern.folder(), ignored);
}

}  // namespace

void add_film_folder(const FilmRequest& film, Diagnostics& diagnostics) {
    const fs::path folder = pattern_of_film(film.file).folder();
    std::error_code failed;
    fs::create_directory(folder, failed);
    if (failed) {
        diagnostics.push_back(error(fmt::format("the folder '{}' for the frames cannot be made: {}",
                                                folder.string(), failed.message()),
                                    {}, "make room or allow writing there"));
    }
}

void make_film_of_frames(const FilmRequest& film, const FramePattern& pattern,
                         const FrameNumbers& frames, bool remove_frames, ProgressDisplay& display,
                         RenderReport& outcome, const std::stop_token& stop) {
    std::vector<fs::path> pictures;
    for (const std::size_t frame : frames) {
        pictures.push_back(pattern.file(frame));
    }
    const auto progress = [&](std::size_t picture) {
        display.show_text(fmt::format("film: picture {} of {}", picture + 1, pictures.size()));
    };
    Diagnostics found = write_film(film, pictures, progress, stop);
    display.clear();
    if (has_errors(found)) {
        if (stop.stop_requested()) {
            outcome.code = ExitCode::interrupted;
            outcome.sentence += "  interrupted before the film was made\n";
            return;
        }
        found.front().remedy =
            fmt::format("the frames are in '{}'; correct that and give the same command again",
                        pattern.folder().string());
        add(outcome, found);
        outcome.code = ExitCode::environment;
        return;
    }
    if (remove_frames) {
        remove_all(pattern);
    }
}

}  // namespace balcony::cli
