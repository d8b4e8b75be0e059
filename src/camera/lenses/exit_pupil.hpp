// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include "balcony/expr.hpp"
#include "camera/lenses/lens_optics.hpp"

namespace balcony::camera {

/// Where the light comes from that reaches the points of the sensor: for each a disc of directions
/// that contains all directions whose rays pass the lens. Directions are (m, n, √(1 - m² - n²)),
/// and points are in units of the distance from the last surface to the sensor. The light of a disc
/// in (m, n) is proportional to its area, so that discs of one size give the right vignetting.
///
/// With s = p/√(1 + |p|²), the direction from the point p to the middle of the last surface is
/// (m, n) = -s, and |s| is below 1 for every point. So the middle of the disc is near to -s for all
/// lenses, and a table of equal steps in |s|² is as exact for a lens without mounts, which light
/// reaches far off the axis, as for one that is dark there.
struct ExitPupil {
    /// The middle of the disc is at -h(|s|²) s; in its middle the ray passes.
    expr::Table middle;
    /// |s|² of the farthest point that light reaches.
    double largest_square = 0.0;
    /// The radius of the disc, times that distance.
    double radius = 0.0;
};

/// By tracing at these vergences; nothing if no light passes. The middle is that at the first one.
[[nodiscard]] std::optional<ExitPupil> find_exit_pupil(const LensOptics& lens,
                                                       const std::optional<FocusingGroup>& group,
                                                       std::span<const double> vergences);

}  // namespace balcony::camera
