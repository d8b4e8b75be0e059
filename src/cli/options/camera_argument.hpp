// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "balcony/lang.hpp"
#include "balcony/scene.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

/// The file of a camera given as FILE, FILE:NAME or the name of a built-in camera.
[[nodiscard]] std::filesystem::path camera_file(const std::string& camera);

/// A camera selected on the command line, with values for its parameters.
struct CameraArgument {
    std::filesystem::path file;
    std::string name;  ///< Empty for the file's last camera.
    std::vector<lang::Override> overrides;
};

/// Reads FILE[:NAME] and the values of --set, each NAME=VALUE.
[[nodiscard]] Result<CameraArgument> read_camera(const std::string& camera,
                                                 const std::vector<std::string>& set);

/// Makes the selected camera, with the values of --set, each NAME=VALUE.
[[nodiscard]] Result<camera::Camera> load_camera(const std::string& camera,
                                                 const std::vector<std::string>& set);

/// Makes the selected picture; a camera becomes a picture with one layer.
[[nodiscard]] Result<camera::Picture> load_picture(const std::string& picture,
                                                   const std::vector<std::string>& set);
[[nodiscard]] Result<camera::Picture> load_picture(const std::string& picture,
                                                   const std::vector<std::string>& set,
                                                   lang::Workspace& workspace);

/// Whether a camera is given as scene:NAME, or scene: for the first camera of the scene.
[[nodiscard]] bool is_of_scene(const std::string& camera);

/// The same with a scene, whose cameras can be selected.
[[nodiscard]] Result<camera::Picture> load_picture(const std::string& picture,
                                                   const std::vector<std::string>& set,
                                                   const scene::Scene& scene);

/// Adds the required positional argument CAMERA.
void add_camera_option(CLI::App& command, std::string& camera);

/// Adds the repeatable option --set NAME=VALUE.
void add_set_option(CLI::App& command, std::vector<std::string>& set);

/// The extension of a file name in lower case, including the dot.
[[nodiscard]] std::string ending_of(const std::filesystem::path& file);

}  // namespace balcony::cli
