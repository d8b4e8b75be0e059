// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include "balcony/expr.hpp"
#include "camera/lenses/lens_optics.hpp"

namespace balcony::camera {

/// Where the light comes from that reaches the points of the sensor: for each an ellipse of
/// directions that contains all directions whose rays pass the lens, a disc unless the lens is
/// anamorphic. Directions are (m, n, √(1 - m² - n²)), and points are in units of the distance from
/// the last surface to the sensor. The light of an area of (m, n) is proportional to it, so that
/// ellipses of one size give the right vignetting.
///
/// With s = p/√(1 + |p|²), the direction from the point p to the middle of the last surface is
/// (m, n) = -s, and |s| is below 1 for every point. So the middle of the ellipse is near to -s for
/// all lenses, and a table of equal steps in |s|² is as exact for a lens without mounts, which
/// light reaches far off the axis, as for one that is dark there.
struct ExitPupil {
    /// The middle is at (-h s.x, -k s.y), where the tables give h and k for |s|²: they are those of
    /// points beside and above the axis. In it the ray passes.
    std::array<expr::Table, 2> middle;
    /// |s|² of the farthest point that light reaches.
    double largest_square = 0.0;
    /// The half axes, times that distance.
    std::array<double, 2> radius{};
};

/// By tracing at these vergences; nothing if no light passes. The middle is that at the first one.
/// Blades are as wide as their circle.
[[nodiscard]] std::optional<ExitPupil> find_exit_pupil(const LensOptics& lens,
                                                       const std::optional<FocusingGroup>& group,
                                                       std::span<const double> vergences);

}  // namespace balcony::camera
