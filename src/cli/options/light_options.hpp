// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light that is not part of the scene.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "balcony/render.hpp"
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

/// Sets the light settings, but reads no file.
void read_light(const LightWords& words, render::Settings& settings, Diagnostics& diagnostics);

/// Whether the environment is a picture file.
[[nodiscard]] bool is_file(const LightWords& words);

/// The file of the environment, if there is one.
[[nodiscard]] std::vector<std::filesystem::path> environment_files(const LightWords& words);

/// Reads the picture file of the environment, if it is one.
[[nodiscard]] Diagnostics load_environment(const LightWords& words, render::Settings& settings);

}  // namespace balcony::cli
