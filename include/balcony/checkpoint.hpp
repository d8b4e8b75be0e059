// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Checkpoints: the sums of an unfinished film in a file, so that a render continues after a crash.

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

/// Replaces the file by a checkpoint of the film. The file is first written as FILE.new, so that it
/// is always complete. A failure is an error, and the file is unchanged.
[[nodiscard]] Diagnostics write_checkpoint(const Film& film, const RenderFacts& facts,
                                           const std::filesystem::path& file);

/// What the film of a checkpoint depends on, without checking the rest of the file.
[[nodiscard]] Result<RenderFacts> read_facts(const std::filesystem::path& file);

/// Reads a checkpoint into a film that a job was made for. A file that is damaged, of another
/// version of Balcony, of a film of another kind, or of other facts is an error, which names what
/// differs; the film is unchanged then.
[[nodiscard]] Diagnostics read_checkpoint(Film& film, const RenderFacts& facts,
                                          const std::filesystem::path& file);

}  // namespace balcony::render
