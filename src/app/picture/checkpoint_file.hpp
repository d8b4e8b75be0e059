// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The checkpoint of a picture, beside it.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/inputs/file_watch.hpp"
#include "balcony/checkpoint.hpp"

namespace balcony::app {

class CheckpointFile {
public:
    /// The options of the render, the files that were read, and a time before that.
    CheckpointFile(const std::filesystem::path& picture, render::FilmFacts options,
                   std::vector<std::filesystem::path> inputs, FileWatch::Time since);

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] bool exists() const;

    /// Continues the film of the checkpoint.
    [[nodiscard]] Diagnostics load(render::Film& film);
    /// Replaces the checkpoint; for bands with the hashes of what is finished. The second failure
    /// in succession is silent.
    [[nodiscard]] Diagnostics save(const render::Film& film,
                                   const std::vector<std::uint64_t>& finished = {});
    void remove() const;
    /// The warning of a render that begins anew, although there is a checkpoint, or although one is
    /// wanted and a picture is there.
    [[nodiscard]] Diagnostics begins_anew(bool wanted) const;
    /// "restore it and continue with --resume from 'picture.png.checkpoint'"
    [[nodiscard]] std::string remedy(std::string_view first) const;

    /// Whether the film was loaded from a checkpoint, or saved to one.
    [[nodiscard]] bool is_used() const { return used_; }

    /// All that the film depends on.
    [[nodiscard]] const render::FilmFacts& facts();

private:
    std::filesystem::path picture_;
    std::filesystem::path file_;
    render::FilmFacts facts_;
    std::vector<std::filesystem::path> inputs_;
    FileWatch watch_;
    bool hashed_ = false;  ///< Whether the facts have the hashes of the inputs.
    bool used_ = false;
    bool failed_ = false;
};

/// A failure to save something, which does not end the render.
[[nodiscard]] Diagnostics as_warnings(Diagnostics failures);

}  // namespace balcony::app
