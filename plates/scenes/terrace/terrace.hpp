// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A game of chess by candlelight on the terrace of a café, before a lane with lampions.

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

namespace terrace {

/// The top of the chessboard, whose middle is above the origin, in metres.
inline constexpr double board_height = 0.772;
inline constexpr double lampion_radius = 0.085;

}  // namespace terrace

/// The scene, z up, in metres; the lane goes along x. The lampions are the objects "lampion 1" and
/// so on.
[[nodiscard]] Result<scene::Scene> make_terrace(const SceneOptions& options);

}  // namespace balcony::plates
