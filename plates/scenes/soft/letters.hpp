// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The letters S, O, F and T of round bars, upright in the xz plane about the origin, 19 units high.

#include "balcony/scene.hpp"

namespace balcony::plates {

/// The height of a letter's middle above the floor that it stands on.
inline constexpr double letter_middle = 9.5;

[[nodiscard]] scene::Mesh letter_s();
[[nodiscard]] scene::Mesh letter_o();
[[nodiscard]] scene::Mesh letter_f();
[[nodiscard]] scene::Mesh letter_t();

}  // namespace balcony::plates
