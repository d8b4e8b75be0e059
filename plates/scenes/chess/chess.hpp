// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A still life for the pictures that hang in the galleries: the end of a game of chess.

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_builder.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

/// Adds the board and the pieces on it. In their own space, the board's top is z = 0, its squares
/// are 4 wide, and its middle is the origin.
void add_game_of_chess(SceneBuilder& builder, const M44d& placed);

/// The scene, z up: the game where its own space has it, on a table.
[[nodiscard]] Result<scene::Scene> make_chess(const SceneOptions& options);

}  // namespace balcony::plates
