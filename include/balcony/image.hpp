// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Image: a finished picture for display.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace balcony {

/// sRGB pixels, one byte for each of red, green and blue, row by row from the top left.
struct Image {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::uint8_t> samples;
};

}  // namespace balcony
