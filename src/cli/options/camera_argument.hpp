// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "balcony/inputs.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

using app::camera_file;
using app::CameraArgument;
using app::is_of_scene;
using app::load_camera;
using app::load_picture;
using app::read_camera;

/// Adds the required positional argument CAMERA.
void add_camera_option(CLI::App& command, std::string& camera);

/// Adds the repeatable option --set NAME=VALUE.
void add_set_option(CLI::App& command, std::vector<std::string>& set);

/// The extension of a file name in lower case, including the dot.
[[nodiscard]] std::string ending_of(const std::filesystem::path& file);

}  // namespace balcony::cli
