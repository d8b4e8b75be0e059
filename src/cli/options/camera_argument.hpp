// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "balcony/lang.hpp"
#include "cli/commands/command.hpp"

namespace balcony::cli {

/// The file of a camera that a user named: FILE, FILE:NAME or a built-in camera's name.
[[nodiscard]] std::filesystem::path camera_file(const std::string& camera);

/// What a user says of a camera, as the language takes it.
struct CameraArgument {
    std::filesystem::path file;
    std::string name;  ///< Empty for the file's last camera.
    std::vector<lang::Override> overrides;
};

/// Reads FILE[:NAME] and the values of --set, each NAME=VALUE.
[[nodiscard]] Result<CameraArgument> read_camera(const std::string& camera,
                                                 const std::vector<std::string>& set);

/// Makes the camera that a user named, with the values of --set, each NAME=VALUE.
[[nodiscard]] Result<camera::Camera> load_camera(const std::string& camera,
                                                 const std::vector<std::string>& set);

/// The same of a picture, or of a camera as a picture.
[[nodiscard]] Result<camera::Picture> load_picture(const std::string& picture,
                                                   const std::vector<std::string>& set);

/// The positional CAMERA, which a command cannot do without.
void add_camera_option(CLI::App& command, std::string& camera);

/// --set NAME=VALUE, which may be repeated.
void add_set_option(CLI::App& command, std::vector<std::string>& set);

/// The ending of a file's name in small letters, with its point.
[[nodiscard]] std::string ending_of(const std::filesystem::path& file);

}  // namespace balcony::cli
