// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "balcony/inputs.hpp"

namespace balcony::cli {

/// "scene file (.glb, ...)"
[[nodiscard]] std::string scene_files_text();

using app::is_scene_file;
using app::load_scene;

}  // namespace balcony::cli
