// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Arrays of NumPy for all frames of a camera.

#include <string>
#include <vector>

#include "dataset/layouts/camera_rays.hpp"

namespace balcony::dataset {

/// Vectors as float32.
[[nodiscard]] std::string vectors_npy(const std::vector<std::size_t>& shape,
                                      const std::vector<V3d>& vectors);

/// By pose, 4 x 4 in double precision: from the axes of OpenCV at a place in the camera to the
/// world of the scene.
[[nodiscard]] std::string poses_npy(const Plan& plan, std::size_t scene,
                                    const camera::Pose& in_camera);

}  // namespace balcony::dataset
