// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Round bodies along and about curves.

#include <vector>

#include "balcony/scene.hpp"

namespace balcony::plates {

/// The points of an arc in the xz plane, from one angle to another in radians, counterclockwise
/// from x as seen with z up.
[[nodiscard]] std::vector<scene::V3d> arc(const scene::V3d& center, double radius, double from,
                                          double to, int steps);

enum class TubeEnds { round, closed };

/// A tube along a smooth path in the xz plane. Its ends are half spheres beyond the path, or it is
/// a ring whose last point is joined to the first.
[[nodiscard]] scene::Mesh tube(const std::vector<scene::V3d>& path, double radius, TubeEnds ends);

/// The surface that a curve in the xz plane, whose x is not negative, describes about the z axis,
/// seen from the left of the way along the curve. Its texture runs once around, and from bottom to
/// top along the curve.
[[nodiscard]] scene::Mesh lathe(const std::vector<scene::V3d>& profile, int sides);

/// Adds the triangles of a part, which has the same attributes, to a mesh.
void append(scene::Mesh& mesh, const scene::Mesh& part);

}  // namespace balcony::plates
