// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "balcony/shutter.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

struct ShutterWords {
    std::string duration = "0";
    std::string shape = std::string(render::shutter_shapes()[render::ShutterShape::box].name);
    std::string fps = "24";
};

void add_shutter_options(CLI::App& command, ShutterWords& words);

/// What cannot be read is added to `diagnostics`.
[[nodiscard]] render::Shutter read_shutter(const ShutterWords& words, Diagnostics& diagnostics);
/// The seconds from frame to frame; likewise.
[[nodiscard]] double read_frame_time(const ShutterWords& words, Diagnostics& diagnostics);

}  // namespace balcony::cli
