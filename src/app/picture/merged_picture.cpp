// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <map>

#include "app/picture/finished_picture.hpp"
#include "app/words.hpp"
#include "balcony/inputs.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

// The shards of each frame; those of a picture have no frame.
Result<std::map<std::string, std::vector<fs::path>>> shards_of_frames(
    const std::vector<fs::path>& files) {
    std::map<std::string, std::vector<fs::path>> frames;
    for (const fs::path& file : files) {
        const auto heading = render::read_shard_heading(file);
        if (!heading) {
            return heading.diagnostics;
        }
        frames[heading->frame ? heading->finish.output.string() : ""].push_back(file);
    }
    return frames;
}

void merge(const std::vector<fs::path>& shards, const fs::path& other_output,
           const Observer& observer, MergedPicture& merged) {
    const auto fails = [&merged](const Diagnostics& found) {
        return add(merged.diagnostics, found);
    };
    const auto heading = render::read_shard_heading(shards.front());
    if (fails(heading.diagnostics)) {
        return;
    }
    Finish finish = heading->finish;
    if (!other_output.empty()) {
        finish.output = other_output;
    }
    if (fails(check_output(finish.output)) || fails(check_overwrites(finish.output, shards))) {
        return;
    }
    Result<render::Film> film = render::merge_shards(shards);
    if (fails(film.diagnostics)) {
        return;
    }
    auto denoised = denoise(finish, *film);
    if (fails(denoised.diagnostics)) {
        return;
    }
    merged.denoised = *denoised;
    merged.exposure = finish.exposure;
    if (fails(write(finish, *film, observer))) {
        return;
    }
    merged.output = finish.output;
    merged.width = film->window.width;
    merged.height = film->window.height;
    merged.shards = shards.size();
}

}  // namespace

MergedPicture merge_picture(const std::vector<fs::path>& shards, const fs::path& other_output,
                            const Observer& observer) {
    MergedPicture merged;
    within_memory(merged.diagnostics, [&] { merge(shards, other_output, observer, merged); });
    return merged;
}

std::vector<MergedPicture> merge_pictures(const std::vector<fs::path>& shards,
                                          const fs::path& other_output, const Observer& observer) {
    if (!other_output.empty()) {
        return {merge_picture(shards, other_output, observer)};
    }
    const auto frames = shards_of_frames(shards);
    if (!frames) {
        return {MergedPicture{.diagnostics = frames.diagnostics}};
    }
    std::vector<MergedPicture> merged;
    for (const auto& [picture, files] : *frames) {
        merged.push_back(merge_picture(files, {}, observer));
    }
    return merged;
}

}  // namespace balcony::app
