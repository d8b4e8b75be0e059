// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "balcony/scene.hpp"

namespace balcony::cli {

/// Loads the scene that a command is given; a camera in its place is said to be one.
[[nodiscard]] Result<scene::Scene> load_scene(const std::string& name);

}  // namespace balcony::cli
