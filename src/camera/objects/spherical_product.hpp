// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/stages.hpp"

namespace balcony::camera {

/// g(u) ⊗ h(v) = (g1 h1, g2 h1, h2) of two curves in the plane z = 0.
[[nodiscard]] ObjectGeneratorPointer spherical_product_of(ObjectGeneratorPointer g,
                                                          ObjectGeneratorPointer h);

}  // namespace balcony::camera
