// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The number of turns that a camera's map covers.

#include "balcony/camera.hpp"

namespace balcony::analyse {

/// The number of turns (2 pi) that the map covers; 0 for a parameter in which the rays are not
/// periodic with 2 pi, and for one on which they do not depend.
struct Turns {
    double u = 0.0;
    double v = 0.0;
};

/// For a picture of a size in pixels, at a time.
[[nodiscard]] Turns count_turns(const camera::Camera& camera, double width, double height,
                                double time);

}  // namespace balcony::analyse
