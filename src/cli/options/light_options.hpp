// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light that is not part of the scene.

#include <optional>
#include <string>

#include "balcony/request.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

/// The words of --environment and its companions.
struct LightWords {
    std::optional<std::string> environment;
    std::string rotation = "0";
    std::string strength = "1";
    std::optional<std::string> sun_angle;
};

void add_light_options(CLI::App& command, LightWords& words);

[[nodiscard]] app::LightRequest read_light(const LightWords& words, Diagnostics& diagnostics);

}  // namespace balcony::cli
