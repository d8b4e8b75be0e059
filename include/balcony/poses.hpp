// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Poses: places of cameras as other programs have them.

#include <array>
#include <span>
#include <string_view>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/camera.hpp"

namespace balcony::app {

/// What the axes of a camera are to a program.
struct CameraAxes {
    std::string_view name;
    std::string_view meaning;
    /// Its x, y and z as vectors of Balcony, whose built-in cameras look along x and have y to the
    /// left and z above them.
    std::array<Imath::V3d, 3> axes;
};
[[nodiscard]] std::span<const CameraAxes> camera_axes();

/// The rows of a matrix from the axes of a camera to those of the world: a rotation, and the place
/// of the camera as the last column.
using PoseMatrix = std::array<std::array<double, 4>, 3>;

/// The pose of a matrix, of cameras whose axes have this name, in a world with these axes. A matrix
/// that is not a rotation to 1e-4, and a name that is not known, are errors.
[[nodiscard]] Result<camera::Pose> pose_of(const PoseMatrix& matrix, std::string_view axes,
                                           Axes world);

/// The matrix of a pose: pose_of() gives the pose back.
[[nodiscard]] Result<PoseMatrix> matrix_of(const camera::Pose& pose, std::string_view axes,
                                           Axes world);

/// Where a point of what stands in a pose is, and which of its points is at a place.
[[nodiscard]] Imath::V3d place_of(const camera::Pose& pose, const Imath::V3d& point);
[[nodiscard]] Imath::V3d point_at(const camera::Pose& pose, const Imath::V3d& place);

/// The pose of what stands in a pose inside of another one.
[[nodiscard]] camera::Pose combined(const camera::Pose& outer, const camera::Pose& inner);

}  // namespace balcony::app
