// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "balcony/request.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

struct ShutterWords {
    std::string duration = "0";
    std::string shape = std::string(render::shutter_shapes()[render::ShutterShape::box].name);
    std::string fps = "24";
};

void add_shutter_options(CLI::App& command, ShutterWords& words);

/// What cannot be read is added to `diagnostics`.
[[nodiscard]] app::ShutterRequest read_shutter(const ShutterWords& words, Diagnostics& diagnostics);

}  // namespace balcony::cli
