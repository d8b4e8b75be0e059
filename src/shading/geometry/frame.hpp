// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "shading/geometry/circle.hpp"
#include "shading/lanes/scalar.hpp"

namespace balcony::render {

#include "shading/geometry/frame.inl"

/// cosine_direction() from two numbers in [0, 1).
[[nodiscard]] inline Imath::V3f sample_cosine(float u, float v) {
    return cosine_direction(u, on_circle(v));
}

}  // namespace balcony::render
