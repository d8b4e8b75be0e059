// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The options of `balcony animate`.

#include <string>

#include "balcony/animation.hpp"
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

void add_animation_options(CLI::App& command, AnimateOptions& options);

/// What they ask for. What cannot be read is added to `diagnostics`.
[[nodiscard]] app::AnimationRequest read_animation(const AnimateOptions& options,
                                                   Diagnostics& diagnostics);

}  // namespace balcony::cli
