// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "film/denoise/surface_filter.hpp"

namespace balcony::render {

/// The light of the first half of the samples (red, green, blue), then that of the second one.
using Halves = Stack;

struct FilteredLight {
    std::array<Plane, 3> light;
    double left_out =
        0.0;  ///< The luminance of outliers that is not in the light, over all pixels.
};

/// The mean of both halves, without noise. `part` is the part of the samples that is in the first
/// one, by pixel. The light is compared pixel by pixel after a mean over so many pixels in each
/// direction: the smaller, the sharper shadows may be, and the more noise is taken for them.
[[nodiscard]] FilteredLight filtered(Halves halves, const Plane& part, const SurfaceFilter& filter,
                                     std::size_t blur_radius);

}  // namespace balcony::render
