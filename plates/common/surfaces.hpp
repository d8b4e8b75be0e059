// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Meshes of smooth surfaces.

#include <functional>
#include <span>
#include <vector>

#include "balcony/scene.hpp"

namespace balcony::plates {

/// A surface by a formula of u and v from 0 to 1, as columns × rows quadrangles. Its outside is on
/// the side of the cross product of the tangents along u and v. The texture has u to the right and
/// v upwards.
using SurfacePoint = std::function<scene::V3d(double u, double v)>;
[[nodiscard]] scene::Mesh smooth_surface(int columns, int rows, const SurfacePoint& point);

/// A curve through points, as equally many pieces between each two.
[[nodiscard]] std::vector<scene::V3d> smooth_curve(std::span<const scene::V3d> points,
                                                   int pieces_per_segment);

/// Adds the triangles of a mesh with the same material to another one.
void append(scene::Mesh& mesh, const scene::Mesh& part);

}  // namespace balcony::plates
