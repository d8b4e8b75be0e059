// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "balcony/scene.hpp"

namespace balcony::cli {

/// Loads the scene of a command. A camera in its place gives a specific error.
[[nodiscard]] Result<scene::Scene> load_scene(const std::string& name);

}  // namespace balcony::cli
