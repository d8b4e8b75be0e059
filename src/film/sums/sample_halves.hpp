// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The samples of a pixel in two halves, whose difference tells their noise. Both are runs of
// samples, which a low-discrepancy sequence spreads evenly. Halves that alternate would each have
// gaps where the other one has its samples, and differ by more than the noise, above all at edges.

#include <bit>
#include <cstdint>

#include "balcony/film.hpp"

namespace balcony::render {

/// How many of the first `samples` are in the first half: a power of two, since so many are even,
/// such that neither half is more than twice the other one.
[[nodiscard]] constexpr std::uint32_t first_half_of(std::uint32_t samples) {
    if (samples < 2) {
        return samples;
    }
    const std::uint32_t even = std::bit_floor(samples - 1);
    return 2 * samples < 3 * even ? even / 2 : even;
}

static_assert(first_half_of(2) == 1 && first_half_of(3) == 2 && first_half_of(16) == 8 &&
              first_half_of(23) == 8 && first_half_of(24) == 16);

/// Before the sample with an index, from 0, is added to the sum.
inline void keep_half(HalfSum& half, std::uint32_t index, const V3d& sum) {
    if (std::has_single_bit(index)) {
        half.even = V3f(sum);
    }
    if (first_half_of(index + 1) == std::bit_floor(index)) {
        half.first = half.even;
    }
}

/// The sum of the light of a pixel that several surfaces reflect.
[[nodiscard]] inline V3d indirect_sum(const Film& film, std::size_t at) {
    const Color4d& sum = film.sum[at];
    return V3d(sum.r, sum.g, sum.b) - film.means.emission[at] - film.means.direct[at];
}

}  // namespace balcony::render
