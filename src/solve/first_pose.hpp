// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "balcony/rays.hpp"
#include "balcony/solve.hpp"

namespace balcony::solve {

/// A pose in which the points of a target are near these rays, one for each point, that begin at
/// about one place: the direct linear transform of Hartley and Zisserman, "Multiple View Geometry"
/// (2004), chapter 4, with directions in place of picture points. At least 4 points of a plane or 6
/// others; nothing if there are fewer, if they are on a line, or if a ray has no direction.
[[nodiscard]] std::optional<Pose> first_pose(std::span<const rays::Ray> rays,
                                             std::span<const V3d> points);

}  // namespace balcony::solve
