// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The sample positions of a pass in the pixels.

#include <cstddef>

#include <Imath/ImathVec.h>

namespace balcony::render {

/// From the pixel's centre: the centre itself in pass 0, then points of a low-discrepancy sequence,
/// warped to a tent of radius 1. Multiples of 2^-30, so that a picture point is the same number
/// in every tile.
[[nodiscard]] Imath::V2d pass_offset(std::size_t pass);

}  // namespace balcony::render
