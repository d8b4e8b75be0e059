// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/lanes/four_floats.hpp"
#include "shading/lanes/scalar.hpp"
#include "shading/textures/image_levels.hpp"

namespace balcony::render {

// The four channels of a texel.
[[nodiscard]] inline Float4 mix(const Float4& a, const Float4& b, float fraction) {
    return a + fraction * (b - a);
}
[[nodiscard]] inline Float4 select(bool where, const Float4& a, const Float4& b) {
    return where ? a : b;
}
[[nodiscard]] inline Float4 or_zero(bool where, const Float4& a) { return where ? a : Float4{}; }

#include "shading/textures/texture_look_up.inl"

}  // namespace balcony::render
