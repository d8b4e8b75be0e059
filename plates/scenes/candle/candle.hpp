// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A still life for the pictures that hang in the galleries: a burning candle and fruit.

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

/// The scene, z up; the top of the table is z = 0, the candle stands at the origin.
[[nodiscard]] Result<scene::Scene> make_candle(const SceneOptions& options);

}  // namespace balcony::plates
