// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "balcony/solve.hpp"

namespace balcony::solve {

/// The derivatives of the place of a target's point by the rotation and by the translation.
[[nodiscard]] std::array<V3d, 6> pose_derivatives(const Pose& pose, const V3d& point);

}  // namespace balcony::solve
