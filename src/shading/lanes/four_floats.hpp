// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Four floats that are computed at once: the vectors of GCC and Clang, whose operators work by
// lane, and in which a comparison selects.

#include <cmath>

namespace balcony::render {

using Float4 [[gnu::vector_size(16)]] = float;

[[nodiscard]] inline Float4 all(float value) { return Float4{value, value, value, value}; }

[[nodiscard]] inline Float4 max(Float4 a, Float4 b) { return a > b ? a : b; }
[[nodiscard]] inline Float4 min(Float4 a, Float4 b) { return a < b ? a : b; }

[[nodiscard]] inline Float4 sqrt(Float4 a) {
    return Float4{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}

[[nodiscard]] inline float sum(Float4 a) { return (a[0] + a[1]) + (a[2] + a[3]); }

}  // namespace balcony::render
