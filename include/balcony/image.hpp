// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Image: a finished picture, as a screen shows it.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace balcony {

/// Pixels of sRGB, a byte for each of red, green and blue, row by row from the top left.
struct Image {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::uint8_t> samples;
};

}  // namespace balcony
