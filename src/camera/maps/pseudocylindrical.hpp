// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pseudocylindrical maps that need more than samples of PROJ's forward function: because it is a
// search that gives up near the poles, because it changes its formula at a latitude, or because the
// map is interrupted.

#include "camera/maps/inverse_map.hpp"

namespace balcony::camera::maps {

/// Null if the projection is none of these.
[[nodiscard]] InverseMapPointer special_pseudocylindrical(const Definition& definition,
                                                          const ForwardMap& map);

}  // namespace balcony::camera::maps
