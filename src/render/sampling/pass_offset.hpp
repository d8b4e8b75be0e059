// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The place of a pass in the pixels and in the exposure.

#include <cstddef>
#include <string_view>

#include <Imath/ImathVec.h>

namespace balcony::render {

/// A pixel filter along x or y: the distribution function of sample offsets from the pixel's
/// centre, in pixels; 0 at -radius and 1 at radius.
struct PixelFilter {
    double radius = 0.0;
    double (*distribution)(double offset) = nullptr;
};

/// A filter by its name; null if there is none.
[[nodiscard]] const PixelFilter* find_pixel_filter(std::string_view name);

/// From the pixel's centre: the centre itself in pass 0, then points of a (0, 2)-sequence with the
/// density of the filter. Multiples of 2^-30, so that a picture point is the same number
/// in every tile.
[[nodiscard]] Imath::V2d pass_offset(const PixelFilter& filter, std::size_t pass);

/// A number from 0 to 1 for Shutter::moment: 1/2 in pass 0, then a low-discrepancy sequence.
[[nodiscard]] double pass_moment(std::size_t pass);

}  // namespace balcony::render
