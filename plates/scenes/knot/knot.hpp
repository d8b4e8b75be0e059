// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A sculpture for the pictures that hang in the galleries: a knotted, coloured tube.

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

/// The scene, z up and without lights; the ground is z = 0, and the middle of the knot is at z = 9.
[[nodiscard]] Result<scene::Scene> make_knot(const SceneOptions& options);

}  // namespace balcony::plates
