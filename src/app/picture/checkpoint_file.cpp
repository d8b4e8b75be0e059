// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/checkpoint_file.hpp"

#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/words.hpp"
#include "balcony/content_hash.hpp"

namespace balcony::app {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view rows_fact = "the rows";

}  // namespace

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
render::RenderFacts CheckpointFile::facts(const render::Film& film) {
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
    render::RenderFacts all = *facts_;
    all.push_back(
        {std::string(rows_fact), fmt::format("{}+{}", film.window.y, film.window.height)});
    return all;
}

Result<std::pair<std::size_t, std::size_t>> CheckpointFile::rows() const {
    const Result<render::RenderFacts> facts = render::read_facts(file_);
    if (!facts) {
        return facts.diagnostics;
    }
    for (const render::RenderFact& fact : *facts) {
        const std::size_t plus = fact.name == rows_fact ? fact.value.find('+') : std::string::npos;
        if (plus != std::string::npos) {
            const std::string_view text = fact.value;
            const auto first = whole_number_of(text.substr(0, plus));
            const auto count = whole_number_of(text.substr(plus + 1));
            return std::pair(first.value_or(0), count.value_or(0));
        }
    }
    return error(fmt::format("'{}' cannot be resumed: it does not name its rows", file_.string()),
                 {}, "render without --resume to begin anew");
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

Diagnostics CheckpointFile::replaced() const {
    return exists()
               ? Diagnostics{warning(
                     fmt::format("'{}' is left from an interrupted render and will be replaced",
                                 file_.string()),
                     {}, "add --resume to continue that render")}
               : Diagnostics{};
}

std::string CheckpointFile::remedy(std::string_view first) const {
    return fmt::format("{} and continue with --resume from '{}'", first, file_.string());
}

void CheckpointFile::remove() const {
    std::error_code ignored;
    fs::remove(file_, ignored);
}

}  // namespace balcony::app
