// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <Eigen/Core>

#include "balcony/solve.hpp"

namespace balcony::solve {

[[nodiscard]] inline Eigen::Vector3d eigen(const V3d& v) { return {v.x, v.y, v.z}; }
/// The matrix whose product with a vector is the cross product of v and that vector.
[[nodiscard]] Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v);

/// The derivatives of the place of a target's point by the rotation and by the translation.
[[nodiscard]] std::array<V3d, 6> pose_derivatives(const Pose& pose, const V3d& point);

}  // namespace balcony::solve
