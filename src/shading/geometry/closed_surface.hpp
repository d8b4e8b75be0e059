// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/scene.hpp"

namespace balcony::render {

/// Whether the triangles of an object, including all instances, enclose a volume that they
/// face away from: every edge is traversed once in each direction. Points at the same position are
/// merged.
[[nodiscard]] bool encloses_volume(const scene::Scene& scene, std::uint32_t object);

}  // namespace balcony::render
