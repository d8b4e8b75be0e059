// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/emitter.hpp"

namespace balcony::camera {

/// The direction on the great circle from a to b, at an angle proportional to the weight: 0 is a
/// and 1 is b. Both have unit length. There is no ray if they are opposite, which have no unique
/// great circle.
[[nodiscard]] ObjectVector on_great_circle(const ObjectVector& a, const ObjectVector& b,
                                           Expr weight, Emitter& emit);

}  // namespace balcony::camera
