// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The checkpoint of a picture, beside it.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/inputs/file_watch.hpp"
#include "balcony/checkpoint.hpp"

namespace balcony::app {

class CheckpointFile {
public:
    /// The options of the render, the files that were read, and a time before that.
    CheckpointFile(const std::filesystem::path& picture, render::RenderFacts options,
                   std::vector<std::filesystem::path> inputs, FileWatch::Time since);

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] bool exists() const;

    /// The rows of the picture that are in the film of the checkpoint: the first one, and how many.
    [[nodiscard]] Result<std::pair<std::size_t, std::size_t>> rows() const;
    /// Continues the film of the checkpoint.
    [[nodiscard]] Diagnostics load(render::Film& film);
    /// Replaces the checkpoint. The second failure in succession is silent.
    [[nodiscard]] Diagnostics save(const render::Film& film);
    void remove() const;
    /// The warning that a checkpoint is there and not continued; empty if there is none.
    [[nodiscard]] Diagnostics replaced() const;
    /// "restore it and continue with --resume from 'picture.png.checkpoint'"
    [[nodiscard]] std::string remedy(std::string_view first) const;

    /// Whether the film was loaded from a checkpoint, or saved to one.
    [[nodiscard]] bool is_used() const { return used_; }

    /// All that the film depends on.
    [[nodiscard]] render::RenderFacts facts(const render::Film& film);

private:
    std::filesystem::path file_;
    render::RenderFacts options_;
    std::vector<std::filesystem::path> inputs_;
    FileWatch watch_;
    std::optional<render::RenderFacts> facts_;
    bool used_ = false;
    bool failed_ = false;
};

}  // namespace balcony::app
