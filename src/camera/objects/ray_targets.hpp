// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rays followed to surfaces.

#include <memory>
#include <vector>

#include "balcony/catalogue.hpp"
#include "balcony/ray_target.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

/// A ray that starts on a surface does not meet it there: the least s, in lengths of its direction.
inline constexpr double min_ray_distance = 1e-9;

/// The unbounded plane through a point.
[[nodiscard]] std::shared_ptr<const RayTarget> plane_target(Triple at, Triple along_u,
                                                            Triple along_v);
/// Around the origin.
[[nodiscard]] std::shared_ptr<const RayTarget> sphere_target(Scalar radius);
/// Around the z axis, unbounded.
[[nodiscard]] std::shared_ptr<const RayTarget> cylinder_target(Scalar radius);

/// The parallelogram between three corners.
[[nodiscard]] std::shared_ptr<const RayTarget> parallelogram_target(
    const std::array<double, 3>& corner, const std::array<double, 3>& along_u,
    const std::array<double, 3>& along_v);

/// Vertical, unbounded panels above and below a polyline of points (x, y).
[[nodiscard]] std::shared_ptr<const RayTarget> panels_target(PointList points);

/// The triangles by their positions alone. Builds a tree of boxes over them.
[[nodiscard]] std::shared_ptr<const RayTarget> triangles_target(
    const std::vector<std::array<TexturedMesh::Corner, 3>>& triangles);

}  // namespace balcony::camera
