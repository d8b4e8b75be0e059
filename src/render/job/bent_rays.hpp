// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Bent rays, which are traced one straight part after another until they hit something.

#include <cstddef>

#include "balcony/rays.hpp"
#include "render/embree/accelerator.hpp"

namespace balcony::render {

/// A straight part of a ray as the tracer takes it. It ends behind its end by more than the
/// rounding error, so that no surface fits between two parts.
[[nodiscard]] embree::Ray ray_of(const rays::RayBatch::Part& part, float time);

/// Where a ray first meets the scene.
struct FirstHit {
    std::size_t part = 0;  ///< The straight part that meets it; the last one if none does.
    embree::Hit hit{};
};

/// For a ray that can be traced, straight or bent.
[[nodiscard]] FirstHit first_hit(const embree::Accelerator& accelerator, const rays::RayBatch& rays,
                                 std::size_t i, float time);

/// The length of a ray's path up to the beginning of a part.
[[nodiscard]] double length_before(const rays::RayBatch& rays, std::size_t i, std::size_t part);

}  // namespace balcony::render
