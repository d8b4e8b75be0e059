// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Clearance: how far points in space are from the surfaces of a scene.

#include <span>
#include <stop_token>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/scene.hpp"

namespace balcony::render {

/// The distance of each point to the nearest triangle of a scene, in scene units: exact but for
/// rounding, in time that grows with the triangles. Infinite without any. Objects count whatever
/// their material. A stop is an error of Kind::interrupted.
[[nodiscard]] Result<std::vector<double>> clearances(const scene::Scene& scene,
                                                     std::span<const Imath::V3d> points, Axes axes,
                                                     const std::stop_token& stop = {});

}  // namespace balcony::render
