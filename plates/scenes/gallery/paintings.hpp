// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The paintings that hang in the gallery, each computed from formulas.

#include <array>

#include "common/painting.hpp"

namespace balcony::plates {

/// A detail of the Mandelbrot set, lit as a relief.
Color mandelbrot(const Sample& sample);

/// Domain colouring of a rational complex function.
Color rational_function(const Sample& sample);

/// Woven ribbons that wind into a point, after Escher's "Whirlpools".
Color whirlpool(const Sample& sample);

/// The word BALCONY, its middle swollen as in Escher's lithograph of that name.
Color poster(const Sample& sample);

/// Ridges behind a lake with a red sun, in the mood of Japanese woodcuts.
Color woodcut(const Sample& sample);

/// A sunflower whose seeds stand in golden angles (H. Vogel, 1979).
Color sunflower(const Sample& sample);

/// Chrome and matt spheres over a chequered floor, as in the first years of ray tracing.
Color spheres(const Sample& sample);

}  // namespace balcony::plates
