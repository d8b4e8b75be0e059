// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A still life for the pictures that hang in the galleries: marbles of glass, lacquer and metal.

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

/// The scene, z up; the marbles lie on z = 0 around the origin, and their colour changes with the
/// direction.
[[nodiscard]] Result<scene::Scene> make_marbles(const SceneOptions& options);

}  // namespace balcony::plates
