// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The file of a shard, beside the picture that it is a part of.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "balcony/denoise.hpp"
#include "balcony/film.hpp"
#include "balcony/shard.hpp"
#include "cli/options/render_options.hpp"
#include "cli/picture_run.hpp"
#include "cli/report/render_report.hpp"

namespace balcony::cli {

/// The fact of a shard that names the frame which it is a part of.
inline constexpr std::string_view frame_fact = "the frame";

/// "picture.png.shard-2-of-5"
[[nodiscard]] std::filesystem::path shard_file(const std::filesystem::path& picture,
                                               const render::Shard& shard);

/// What becomes of the merged film.
struct MergedOutput {
    std::filesystem::path picture;
    std::optional<double> exposure;  ///< In stops; chosen automatically if empty.
    render::ViewTransform view = render::ViewTransform::neutral;
    bool dither = true;
    std::optional<render::Denoiser> denoiser;
};

/// As the options of a render ask for it, as facts for a shard's file, and back. Facts that cannot
/// be read have their default.
[[nodiscard]] render::RenderFacts output_facts(const RenderOptions& options,
                                               const std::filesystem::path& picture);
[[nodiscard]] MergedOutput merged_output(const render::RenderFacts& facts);

/// Rejects options that a shard cannot have.
void check_shard(const RenderOptions& options, Diagnostics& diagnostics);

/// The end of a render of one shard: writes its file.
[[nodiscard]] RenderReport keep_shard(RenderReport outcome, const Request& request,
                                      const PictureOutput& output, PictureRun& run,
                                      const render::Summary& summary);

}  // namespace balcony::cli
