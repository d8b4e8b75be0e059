// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Imath/ImathColor.h>

namespace balcony::render {

/// Y of linear Rec. 709.
[[nodiscard]] inline float luminance(const Imath::Color3f& c) {
    return 0.2126F * c.x + 0.7152F * c.y + 0.0722F * c.z;
}
[[nodiscard]] inline float luminance(const Imath::Color4f& c) {
    return luminance(Imath::Color3f(c.r, c.g, c.b));
}

}  // namespace balcony::render
