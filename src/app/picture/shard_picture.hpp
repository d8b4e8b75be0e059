// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The file of a shard, beside the picture that it is a part of.

#include <filesystem>
#include <string_view>

#include "app/picture/finished_picture.hpp"
#include "balcony/shard.hpp"

namespace balcony::app {

/// The fact of a shard that names the frame which it is a part of.
inline constexpr std::string_view frame_fact = "the frame";

/// "picture.png.shard-2-of-5"
[[nodiscard]] std::filesystem::path shard_file(const std::filesystem::path& picture,
                                               const render::Shard& shard);

/// What becomes of the merged film, as facts for a shard's file, and back. Facts that cannot be
/// read have their default.
[[nodiscard]] render::RenderFacts facts_of(const Finish& finish);
[[nodiscard]] Finish finish_of(const render::RenderFacts& facts);

}  // namespace balcony::app
