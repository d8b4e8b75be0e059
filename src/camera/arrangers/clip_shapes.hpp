// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/stages.hpp"

namespace balcony::camera {

/// The whole image of a layer, the default clip.
[[nodiscard]] ClipShapePointer whole_rectangle();

}  // namespace balcony::camera
