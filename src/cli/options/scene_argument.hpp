// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "balcony/scene.hpp"

namespace balcony::cli {

/// "scene file (.glb, ...)"
[[nodiscard]] std::string scene_files_text();

/// Whether a file name has the extension of a scene.
[[nodiscard]] bool is_scene_file(std::string_view name);

/// Loads the scene of a command as it stands at a time in seconds, with what other files add to it.
/// A camera in its place gives a specific error.
[[nodiscard]] Result<scene::Scene> load_scene(const std::string& name, double time = 0.0,
                                              const std::vector<std::string>& added = {});

}  // namespace balcony::cli
