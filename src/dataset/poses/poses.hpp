// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "balcony/dataset.hpp"
#include "balcony/render.hpp"
#include "balcony/scene.hpp"

namespace balcony::dataset {

/// A camera whose x is ahead, in axes with z up. The roll is clockwise about the line of sight, all
/// angles are in radians.
[[nodiscard]] camera::Pose pose_at(const V3d& place, double yaw, double pitch, double roll);

/// By the rules of RandomPoses. `stream` tells the groups of a recipe and its scenes apart: with
/// the same seed and stream, the poses are the same. An error if the open has too little room.
[[nodiscard]] Result<std::vector<camera::Pose>> random_poses(
    const RandomPoses& wanted, const scene::Scene& scene, const render::Renderer& renderer,
    std::uint32_t seed, std::uint32_t stream, const std::stop_token& stop);

/// An error where a line of sight is vertical, or has no direction.
[[nodiscard]] Result<std::vector<camera::Pose>> path_poses(const PathPoses& wanted, Axes axes);

}  // namespace balcony::dataset
