// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Shards: parts of a picture that several machines render, and their merging.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/checkpoint.hpp"
#include "balcony/film.hpp"
#include "balcony/finish.hpp"

namespace balcony::render {

/// One of `count` parts of a picture: the tiles whose column plus row is `index` modulo `count`. So
/// every part has tiles from all over the picture, and takes about as long as any other.
struct Shard {
    std::size_t index = 0;  ///< From 0.
    std::size_t count = 1;

    bool operator==(const Shard&) const = default;
};

/// The maximum of Shard::count.
inline constexpr std::size_t max_shards = 100'000;

/// For Job::run: the passes of the shard's tiles, and none of the others.
[[nodiscard]] std::vector<std::uint32_t> passes_of(const Film& film, const Shard& shard,
                                                   std::uint32_t passes);

/// What a shard is of.
struct ShardHeading {
    Shard shard{};
    RenderFacts facts{};                 ///< All that the picture depends on.
    std::optional<std::size_t> frame{};  ///< Of an animation.
    Finish finish{};                     ///< For the program that merges.
};

/// Writes what a film has in the tiles of a shard. The file replaces another one when it is
/// complete.
[[nodiscard]] Diagnostics write_shard(const Film& film, const ShardHeading& heading,
                                      const std::filesystem::path& file);

/// A file that is not a shard is an error.
[[nodiscard]] Result<ShardHeading> read_shard_heading(const std::filesystem::path& file);

/// Whether a file is a shard as long as its heading says. What it has of pixels is not read, so
/// that damage there shows when it is merged.
[[nodiscard]] bool is_whole_shard(const std::filesystem::path& file);

/// The whole film of a picture from the files of all its shards, in any order, bit for bit that of
/// an undivided render. A shard that is missing, damaged, twice there, or of a picture with other
/// facts is an error, which names it.
[[nodiscard]] Result<Film> merge_shards(std::span<const std::filesystem::path> files);

}  // namespace balcony::render
