// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Morph: a camera whose rays are between those of two others.

#include "balcony/picture.hpp"

namespace balcony::camera {

struct Morph {
    Camera first, second;  ///< Their lenses and times have no effect.
    /// A number as a formula of the point of the picture, in fractions from its top left corner: 0
    /// is the first camera and 1 the second. Other numbers extrapolate.
    Formula amount;
    Fit fit = Fit::fit;  ///< Of a camera with another aspect than the picture's.
    Axes axes = Axes::z_up;
    /// The aspect of the picture; by default, that of the first camera that has one.
    std::optional<double> aspect{};
};

/// The parts of a camera with the rays of a morph. At each point of the picture, it starts where
/// the way from the first camera's origin to the second's is `amount`, and turns by this part of
/// the angle from the first direction to the second. There is a ray where both cameras have one and
/// these are not opposite; where the amount is 0 or 1, where that camera has one.
///
/// The eye object has the origins and the direction object the unit directions, both by (u, v) from
/// (0, 0) at the bottom left of the picture to (1, 1). Further moves transform the rays.
[[nodiscard]] Camera::Parts morphed(const Morph& morph);

}  // namespace balcony::camera
