// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where the parts of a scene may stand.

#include <optional>
#include <span>
#include <string>

#include "balcony/scene.hpp"

namespace balcony::scene {

[[nodiscard]] bool is_finite(const M44d& matrix);

/// The reason why something cannot be placed, to complete a sentence about it: "its transform is
/// singular". Nothing if it can.
using PlacementFault = std::optional<std::string>;

/// A mesh with these bounds.
[[nodiscard]] PlacementFault fault_of_placement(const Box3f& box, const M44d& world_from_mesh);

/// Places a light, which is at its node's origin and shines along the node's -z: its position and
/// direction. Unchanged if there is a fault.
PlacementFault place(Light& light, const M44d& world_from_node);

/// Places a camera, which looks along its node's -z, with +y up, and ignores the node's scale.
/// Unchanged if there is a fault.
PlacementFault place(Camera& camera, const M44d& world_from_node);

/// The bounds of points, transformed.
[[nodiscard]] Box3f box_of(std::span<const V3f> points, const M44d& world_from_points = {});

}  // namespace balcony::scene
