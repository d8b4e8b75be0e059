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

/// How many of the first `samples` are in the first half: the largest power of two that leaves some
/// for the second one.
[[nodiscard]] constexpr std::uint32_t first_half_of(std::uint32_t samples) {
    return samples < 2 ? samples : std::bit_floor(samples - 1);
}

static_assert(first_half_of(2) == 1 && first_half_of(16) == 8 && first_half_of(17) == 16);

/// The sum of the light of a pixel that several surfaces reflect.
[[nodiscard]] inline V3d indirect_sum(const Film& film, std::size_t at) {
    const Color4d& sum = film.sum[at];
    return V3d(sum.r, sum.g, sum.b) - film.means.emission[at] - film.means.direct[at];
}

}  // namespace balcony::render
