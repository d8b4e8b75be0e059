// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The options of `balcony animate`.

#include <cstddef>
#include <optional>
#include <string>

#include "cli/animation/film_file.hpp"
#include "cli/animation/frame_numbers.hpp"
#include "cli/animation/frame_pattern.hpp"
#include "cli/options/render_options.hpp"

namespace balcony::cli {

/// The words of the options that only animations have.
struct AnimationWords {
    std::string scene;
    std::string frames;
    std::string start_time = "0";
    bool turntable = false;
    std::string around;
    std::string crf;
    bool keep_frames = false;
    bool overwrite = false;
    bool same_noise = false;
    std::string shard;
    std::string parts_per_frame = "1";
};

/// The arguments of `balcony animate`.
struct AnimateOptions {
    RenderOptions render;
    AnimationWords words;
};

/// What they ask for.
struct AnimationRequest {
    std::optional<FrameNumbers> frames;  ///< As many as the scene's animations need if empty.
    double start_time = 0.0;             ///< Of frame 1.
    double frame_time = 1.0 / 24.0;      ///< Seconds from frame to frame.
    bool turntable = false;
    std::string around;  ///< The object that the turntable is for; empty for the scene.
    bool keep_frames = false;
    bool overwrite = false;
    bool same_noise = false;
    std::optional<render::Shard> shard;
    std::size_t parts_per_frame = 1;
    std::optional<FramePattern> pattern;  ///< Of the frames; missing only if that is an error.
    std::optional<FilmRequest> film;      ///< That the frames become.

    [[nodiscard]] double time_of(std::size_t frame) const {
        return start_time + (static_cast<double>(frame) - 1.0) * frame_time;
    }
};

void add_animation_options(CLI::App& command, AnimateOptions& options);

/// What cannot be read is added to `diagnostics`.
[[nodiscard]] AnimationRequest read_animation(const AnimateOptions& options,
                                              Diagnostics& diagnostics);

/// The frames of a film are in a folder beside it until it is complete.
[[nodiscard]] FramePattern pattern_of_film(const std::filesystem::path& film);

/// All that the frames depend on, apart from files.
[[nodiscard]] render::RenderFacts frame_facts(const AnimateOptions& options);

}  // namespace balcony::cli
