// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A still life for the pictures that hang in the galleries: a burning candle and fruit.

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_builder.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

/// Adds a burning candle in its holder, which stands on z = 0 at the origin of its own space, 11
/// high. The radiance of its flame is `light` where it is brightest.
void add_burning_candle(SceneBuilder& builder, const M44d& placed, float light);

/// The scene, z up; the top of the table is z = 0, the candle stands at the origin.
[[nodiscard]] Result<scene::Scene> make_candle(const SceneOptions& options);

}  // namespace balcony::plates
