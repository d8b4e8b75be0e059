// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Checkpoints: the sums of an unfinished film in a file, so that a render continues after a crash.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/film.hpp"

namespace balcony::render {

/// Something that a picture depends on, such as a setting or the hash of a file.
struct RenderFact {
    std::string name;
    std::string value;  ///< If it begins with #, it is a hash, which messages do not show.
};
using RenderFacts = std::vector<RenderFact>;

/// What differs between the facts of two renders, in words; empty if nothing does.
[[nodiscard]] std::string difference(const RenderFacts& before, const RenderFacts& now);

/// What a film depends on.
struct FilmFacts {
    RenderFacts sums{};    ///< With other ones, the sums would be others.
    RenderFacts layers{};  ///< What asks for layers: named where a film lacks them.
};

/// What a checkpoint is of.
struct CheckpointHeading {
    FilmFacts facts{};
    std::size_t width = 0;  ///< Of the picture, in pixels.
    std::size_t height = 0;
    Region window{};  ///< Of the film: the band in progress, if there are bands.
    /// Of the bands before it: the hashes of the rows of tiles that TiledFile::flush() gave.
    std::vector<std::uint64_t> finished{};
};

/// Replaces the file by a checkpoint of the film. The file is first written as FILE.new, so that it
/// is always complete. A failure is an error, and the file is unchanged.
[[nodiscard]] Diagnostics write_checkpoint(const Film& film, const FilmFacts& facts,
                                           const std::vector<std::uint64_t>& finished,
                                           const std::filesystem::path& file);

/// What a checkpoint is of, without checking the sums. A damaged heading, and one by another
/// version of Balcony, are errors.
[[nodiscard]] Result<CheckpointHeading> read_checkpoint_heading(const std::filesystem::path& file);

/// Reads a checkpoint into a film that a job was made for. A file that is damaged, of another
/// version of Balcony, of other facts, of another window, or without a layer of the film, is an
/// error, which names what differs; the film is unchanged then. Layers that the film does not have
/// are left out.
[[nodiscard]] Diagnostics read_checkpoint(Film& film, const FilmFacts& facts,
                                          const std::filesystem::path& file);

}  // namespace balcony::render
