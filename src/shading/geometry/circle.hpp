// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <numbers>

#include <Imath/ImathVec.h>

namespace balcony::render {

/// The point of the unit circle at a part of a full turn, from 0 to 1: (cos 2πu, sin 2πu) with
/// errors below 2e-7. Quicker than the library's functions, which take any angle, and the same on
/// all machines.
[[nodiscard]] inline Imath::V2f on_circle(float part) {
    const auto quarter = static_cast<std::int32_t>(4.0F * part + 0.5F);
    const float angle =
        2.0F * std::numbers::pi_v<float> * (part - 0.25F * static_cast<float>(quarter));
    // Taylor's series: at an eighth of a turn, what is left out is below 3e-8.
    const float square = angle * angle;
    const float sine =
        angle *
        (1.0F + square * (-1.0F / 6.0F + square * (1.0F / 120.0F + square * (-1.0F / 5040.0F +
                                                                             square / 362880.0F))));
    const float cosine =
        1.0F +
        square * (-0.5F + square * (1.0F / 24.0F + square * (-1.0F / 720.0F + square / 40320.0F)));
    const bool odd = (quarter & 1) != 0;
    const float x = odd ? sine : cosine;
    const float y = odd ? cosine : sine;
    return {((quarter + 1) & 2) != 0 ? -x : x, (quarter & 2) != 0 ? -y : y};
}

}  // namespace balcony::render
