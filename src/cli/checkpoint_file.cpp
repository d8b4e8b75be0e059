// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/checkpoint_file.hpp"

#include <utility>

#include <fmt/format.h>

#include "balcony/content_hash.hpp"

namespace balcony::cli {

namespace fs = std::filesystem;

CheckpointFile::CheckpointFile(const fs::path& picture, render::RenderFacts options,
                               std::vector<fs::path> inputs, FileWatch::Time since)
    : file_(picture),
      options_(std::move(options)),
      inputs_(std::move(inputs)),
      watch_(inputs_, since) {
    file_ += ".checkpoint";
}

bool CheckpointFile::exists() const {
    std::error_code failed;
    return fs::exists(file_, failed);
}

// The files are hashed once, when it is certain that there will be a checkpoint.
const render::RenderFacts& CheckpointFile::facts(const render::Film& film) {
    if (!facts_) {
        facts_ = {{"Balcony", BALCONY_VERSION},
                  {"the size", fmt::format("{}x{}", film.width, film.height)}};
        facts_->insert(facts_->end(), options_.begin(), options_.end());
        for (const fs::path& input : inputs_) {
            const auto hash = content_hash(input);
            facts_->push_back({fmt::format("the file '{}'", input.string()),
                               hash ? fmt::format("#{:016x}", *hash) : "#unreadable"});
        }
    }
    return *facts_;
}

Diagnostics CheckpointFile::load(render::Film& film) {
    Diagnostics found = read_checkpoint(film, facts(film), file_);
    used_ = !has_errors(found);
    return found;
}

Diagnostics CheckpointFile::save(const render::Film& film) {
    if (!facts_ && watch_.has_changed()) {
        return std::exchange(failed_, true)
                   ? Diagnostics{}
                   : Diagnostics{warning(
                         "a file of the scene or the camera has changed since it was read, so no "
                         "checkpoint is written",
                         {}, "end with Ctrl-C and render again to see the change")};
    }
    Diagnostics found = write_checkpoint(film, facts(film), file_);
    if (!has_errors(found)) {
        used_ = true;
        failed_ = false;
        return {};
    }
    // The render itself goes on.
    for (Diagnostic& diagnostic : found) {
        diagnostic.severity = Severity::warning;
        diagnostic.remedy = "make room or allow writing there; the next attempt follows";
    }
    return std::exchange(failed_, true) ? Diagnostics{} : found;
}

void CheckpointFile::remove() const {
    std::error_code ignored;
    fs::remove(file_, ignored);
}

}  // namespace balcony::cli
