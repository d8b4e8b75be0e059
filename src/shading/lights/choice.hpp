// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// One random number for several choices.

#include <algorithm>
#include <cstddef>
#include <span>

namespace balcony::render {

/// The rest of a number in [0, 1) that decided between two things at a border, from 0 to 1 again.
[[nodiscard]] inline float rest_below(float random, float border) { return random / border; }
[[nodiscard]] inline float rest_above(float random, float border) {
    constexpr float largest = 0x1.fffffep-1F;
    return std::min((random - border) / (1.0F - border), largest);
}

/// The cell that a number chooses, and where it divides the cell, from 0 to 1.
struct ChosenCell {
    std::size_t cell = 0;
    float within = 0.0F;
};

/// Chooses by cumulative probabilities, which end anywhere above where they begin.
[[nodiscard]] inline ChosenCell choose_cell(std::span<const float> cumulative, float random) {
    const float wanted = cumulative.front() + random * (cumulative.back() - cumulative.front());
    // The first border above the number; cells of probability 0 end at or below it.
    const auto above = std::upper_bound(cumulative.begin() + 1, cumulative.end() - 1, wanted);
    auto cell = static_cast<std::size_t>(above - cumulative.begin()) - 1;
    // The number may exceed all cells that have a probability only by rounding.
    while (cell > 0 && cumulative[cell + 1] <= cumulative[cell]) {
        --cell;
    }
    const float probability = cumulative[cell + 1] - cumulative[cell];
    return {cell, std::clamp((wanted - cumulative[cell]) / probability, 0.0F, 1.0F)};
}

}  // namespace balcony::render
