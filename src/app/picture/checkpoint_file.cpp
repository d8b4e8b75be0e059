// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/checkpoint_file.hpp"

#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "app/picture/picture_facts.hpp"

namespace balcony::app {

namespace fs = std::filesystem;

CheckpointFile::CheckpointFile(const fs::path& picture, render::FilmFacts options,
                               std::vector<fs::path> inputs, FileWatch::Time since)
    : picture_(picture),
      file_(picture),
      facts_(std::move(options)),
      inputs_(std::move(inputs)),
      watch_(inputs_, since) {
    file_ += ".checkpoint";
}

bool CheckpointFile::exists() const {
    std::error_code failed;
    return fs::exists(file_, failed);
}

// The files are hashed once, when it is certain that there will be a checkpoint.
const render::FilmFacts& CheckpointFile::facts() {
    if (!std::exchange(hashed_, true)) {
        const render::RenderFacts files = facts_of(inputs_);
        facts_.sums.insert(facts_.sums.end(), files.begin(), files.end());
    }
    return facts_;
}

Diagnostics CheckpointFile::load(render::Film& film) {
    Diagnostics found = read_checkpoint(film, facts(), file_);
    used_ = !has_errors(found);
    return found;
}

Diagnostics CheckpointFile::save(const render::Film& film,
                                 const std::vector<std::uint64_t>& finished) {
    if (!hashed_ && watch_.has_changed()) {
        return std::exchange(failed_, true)
                   ? Diagnostics{}
                   : Diagnostics{warning(
                         "a file of the scene or the camera has changed since it was read, so no "
                         "checkpoint is written",
                         {}, "end with Ctrl-C and render again to see the change")};
    }
    Diagnostics found = write_checkpoint(film, facts(), finished, file_);
    if (!has_errors(found)) {
        used_ = true;
        failed_ = false;
        return {};
    }
    return std::exchange(failed_, true) ? Diagnostics{} : as_warnings(std::move(found));
}

Diagnostics as_warnings(Diagnostics failures) {
    for (Diagnostic& one : failures) {
        one.severity = Severity::warning;
        one.remedy = "make room or allow writing there; the next attempt follows";
    }
    return failures;
}

Diagnostics CheckpointFile::begins_anew(bool wanted) const {
    if (exists()) {
        return {warning(fmt::format("'{}' is left from an interrupted render and will be replaced",
                                    file_.string()),
                        {}, "add --resume to continue that render")};
    }
    std::error_code failed;
    return wanted && fs::exists(picture_, failed)
               ? Diagnostics{warning(fmt::format("there is no '{}', so the render begins anew and "
                                                 "replaces '{}'",
                                                 file_.string(), picture_.string()))}
               : Diagnostics{};
}

std::string CheckpointFile::remedy(std::string_view first) const {
    return fmt::format("{} and continue with --resume from '{}'", first, file_.string());
}

void CheckpointFile::remove() const {
    std::error_code ignored;
    fs::remove(file_, ignored);
    // What a render that was killed may have left.
    ::unlink((file_.string() + ".new").c_str());
}

}  // namespace balcony::app
