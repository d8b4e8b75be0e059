// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A dancer in a long pleated dress, her arms above her head: two units high, standing on z = 0
// about the z axis, her face towards -y.

#include <numbers>
#include <vector>

#include "balcony/scene.hpp"

namespace balcony::plates {

using Imath::V3d;

/// How far the dancer has turned at time 0, in radians: she faces -y 0.17 seconds later.
inline constexpr double dancer_start = -0.17 * 2.0 * std::numbers::pi;

[[nodiscard]] scene::Mesh dancer_figure(double cell);

/// The veil that hangs from an arm: -1 is at -x, 1 at x.
[[nodiscard]] scene::Mesh dancer_veil(double side);
inline constexpr double dancer_edge_radius = 0.01;  ///< Of the gold.
/// Its hem, and from there its outer edge up to the hand.
[[nodiscard]] std::vector<V3d> dancer_veil_edge(double side);

}  // namespace balcony::plates
