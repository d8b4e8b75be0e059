// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>

#include <Imath/ImathVec.h>

namespace balcony::render {

/// A pair of numbers in [0, 1) by its index; those of any successive indices are evenly
/// distributed: Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018).
[[nodiscard]] inline Imath::V2f even_pair(std::size_t index) {
    const auto part = [index](double step) {
        const double sum = step * static_cast<double>(index);
        return static_cast<float>(sum - std::floor(sum));
    };
    return {part(0.7548776662466927), part(0.5698402909980532)};
}

}  // namespace balcony::render
