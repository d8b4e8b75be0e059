// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/stages.hpp"

namespace balcony::camera {

/// A point of a disc: the distance from the centre, and the angle from 0 to 2 pi.
struct PolarPoint {
    Expr radius, angle;
};

/// The square from (-1, -1) to (1, 1) on a disc, by the concentric map of Shirley and Chiu, "A Low
/// Distortion Map between Disk and Square" (1997): squares around the centre become circles.
[[nodiscard]] PolarPoint on_disc(const AperturePoint& square, const Emitter& emit);

/// An aperture has no 1 or 2 sides.
[[nodiscard]] Diagnostic too_few_blades(std::size_t blades);

}  // namespace balcony::camera
