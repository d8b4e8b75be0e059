// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A town of coloured blocks for the pictures that hang in the galleries.

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

/// The scene, z up and without lights; the ground is z = 0, and the highest blocks are around the
/// origin.
[[nodiscard]] Result<scene::Scene> make_towers(const SceneOptions& options);

}  // namespace balcony::plates
