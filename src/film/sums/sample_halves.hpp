// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The samples of a pixel in two halves, whose difference tells their noise.

#include <cstdint>

namespace balcony::render {

/// Whether the sample with a number, from 0, is in the first half. The bits of the number that
/// decide are not the last one: by that one, a low-discrepancy sequence divides the pixel, too.
[[nodiscard]] constexpr bool in_first_half(std::uint32_t sample) {
    // Of two samples, one is in each half.
    return sample == 1 ? false : sample == 2 ? true : ((sample >> 1 ^ sample >> 2) & 1U) == 0;
}

/// How many of the first `samples` are in the first half.
[[nodiscard]] constexpr std::uint32_t first_half_of(std::uint32_t samples) {
    std::uint32_t count = samples / 8 * 4;
    for (std::uint32_t sample = samples / 8 * 8; sample < samples; ++sample) {
        count += in_first_half(sample) ? 1 : 0;
    }
    return count;
}

static_assert(first_half_of(2) == 1 && first_half_of(8) == 4 && first_half_of(16) == 8);

}  // namespace balcony::render
