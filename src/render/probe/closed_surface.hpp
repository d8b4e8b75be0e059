// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/scene.hpp"

namespace balcony::render {

/// Whether the triangles of an object, all its instances taken together, enclose a volume that they
/// face away from: every edge is passed once in either direction. Points at the same place are one.
[[nodiscard]] bool encloses_volume(const scene::Scene& scene, std::uint32_t object);

}  // namespace balcony::render
