// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How often a camera's map goes round its objects.

#include "balcony/camera.hpp"

namespace balcony::analyse {

/// How many times 2 pi the map covers; 0 of a parameter in which the rays do not come back after
/// 2 pi, and of one that they do not depend on.
struct Turns {
    double u = 0.0;
    double v = 0.0;
};

/// For a picture of a size in pixels, at a time.
[[nodiscard]] Turns count_turns(const camera::Camera& camera, double width, double height,
                                double time);

}  // namespace balcony::analyse
