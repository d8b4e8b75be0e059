// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The word SOFT in a photographer's studio (plates 14 and 15), arranged as in POV-Ray's example
// scene `soft.pov`: x to the right, y away from the viewer, z up.

#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

[[nodiscard]] Result<scene::Scene> make_soft(const SceneOptions& options);

}  // namespace balcony::plates
