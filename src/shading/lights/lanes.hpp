// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Four floats that are computed at once: the vectors of GCC and Clang, whose operators work by
// lane, and in which a comparison selects.

#include <cmath>

namespace balcony::render {

using Lanes [[gnu::vector_size(16)]] = float;

[[nodiscard]] inline Lanes all(float value) { return Lanes{value, value, value, value}; }

[[nodiscard]] inline Lanes max(Lanes a, Lanes b) { return a > b ? a : b; }
[[nodiscard]] inline Lanes min(Lanes a, Lanes b) { return a < b ? a : b; }

[[nodiscard]] inline Lanes sqrt(Lanes a) {
    return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}

[[nodiscard]] inline float sum(Lanes a) { return (a[0] + a[1]) + (a[2] + a[3]); }

}  // namespace balcony::render
