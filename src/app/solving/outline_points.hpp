// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "balcony/scene.hpp"

namespace balcony::app {

/// Points of some objects of a scene, of which those that are outermost in a picture make their
/// outline: vertices, and points of long edges, which a camera may show as curves. Of very many,
/// those are left that are farthest in directions all round, as outermost points are in a picture
/// whose camera shows straight lines as straight.
[[nodiscard]] std::vector<scene::V3d> outline_points(const scene::Scene& scene,
                                                     const std::vector<std::uint32_t>& objects);

}  // namespace balcony::app
