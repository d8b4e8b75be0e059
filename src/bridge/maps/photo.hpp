// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "balcony/st_maps.hpp"

namespace balcony::bridge {

/// Linear light, premultiplied by alpha, row by row from the top left: red, green, blue, alpha.
struct Photo::Pixels {
    std::size_t width = 0;
    std::size_t height = 0;
    bool deep = false;  ///< Whole numbers of more than 8 bits.
    std::vector<float> values;
};

/// The curve of sRGB (IEC 61966-2-1).
inline float linear_from_display(float v) {
    return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
}
inline float display_from_linear(float v) {
    return v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1.0F / 2.4F) - 0.055F;
}

}  // namespace balcony::bridge
