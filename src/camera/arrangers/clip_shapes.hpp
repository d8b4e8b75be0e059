// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/camera.hpp"

namespace balcony::camera {

/// All of a layer's picture, as a layer without a clip has it.
[[nodiscard]] ClipShapePointer whole_rectangle();

}  // namespace balcony::camera
