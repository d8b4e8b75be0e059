// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "balcony/dataset.hpp"

namespace balcony::dataset {

/// The rays of all pixels, with what their directions change from pixel to pixel. Where there is no
/// ray, all numbers are 0.
struct CameraRays {
    std::vector<V3d> origins;
    std::vector<V3d> directions;
    /// The angle in radians of a pixel: the root of the solid angle by which the directions of
    /// neighbours differ, |∂d/∂x × ∂d/∂y|^(1/2).
    std::vector<double> spreads;
};

/// In axes of the world. A picture of several camera layers is an error.
[[nodiscard]] Result<CameraRays> camera_rays(const camera::Picture& picture,
                                             const std::array<std::size_t, 2>& size, Axes axes,
                                             double time);

/// The rays of a camera in its own place, in OpenCV's axes.
[[nodiscard]] Result<CameraRays> rays_in_opencv(const Plan& plan, const PlannedCamera& camera);

/// What layouts with rays of one camera layer take; empty if a camera is that.
[[nodiscard]] std::string misfit_of_rays(const PlannedCamera& camera);

}  // namespace balcony::dataset
