// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How the instances of a scene are built.

#include <cstdint>
#include <optional>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "shading/geometry/motion_steps.hpp"

namespace balcony::render::embree {

/// An instance is skipped, copied into world space, or placed by a matrix.
enum class Use : std::uint8_t { none, copied, placed };

/// By instance. A mesh with one instance that stands still is copied into world space, which is
/// faster to trace.
[[nodiscard]] std::vector<Use> choose_uses(const scene::Scene& scene, const MotionSteps& motion);

/// The largest coordinate of a ray's origin for which Embree, which inverts the matrix in floats,
/// can transform it to the coordinates of a shared mesh. Nothing if this may fail even at 1e12: the
/// matrix is then nearly singular, or scales by more than a million.
[[nodiscard]] std::optional<double> reach_into(const scene::M44d& world_from_mesh);

/// One warning for each object with a skipped part.
[[nodiscard]] Diagnostics name_left_out(const scene::Scene& scene, const std::vector<Use>& uses);

}  // namespace balcony::render::embree
