// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The rays of a camera as input of the tracer, in floats.

#include <cstddef>

#include <Imath/ImathVec.h>

#include "balcony/rays.hpp"
#include "render/shading/surface.hpp"

namespace balcony::render {

using Imath::V2f;
using Imath::V3d;

/// Whether there is a ray whose origin is within Embree's limits.
[[nodiscard]] bool traceable(const rays::RayBatch& rays, std::size_t i);
/// 0 where a parameter is not finite.
[[nodiscard]] V2f parameters(const rays::RayBatch& rays, std::size_t i);
/// The number of pixels per unit of length at a point of the ray, on a plane across it; the
/// geometric mean over its directions. 0 without footprints, or where it is not finite.
[[nodiscard]] float magnification(const rays::RayBatch& rays, std::size_t i, const V3d& point);
/// The ray's change over a fraction of a pixel; 0 along x or y where it is not finite.
[[nodiscard]] RayDifferentials differentials(const rays::RayBatch& rays, std::size_t i,
                                             double part);

}  // namespace balcony::render
