// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Round things: solids of revolution, and tubes along a path.

#include <span>

#include <Imath/ImathVec.h>

#include "balcony/scene.hpp"

namespace balcony::plates {

using Imath::V2d;
using Imath::V3d;

/// The surface that a profile sweeps around the z axis. Its points are (distance from the axis,
/// height), from the bottom upwards on the outside; edges sharper than 40 degrees stay sharp. The
/// texture runs once around along u, and along the length of the profile, its top up, along v.
[[nodiscard]] scene::Mesh lathe(std::span<const V2d> profile, int segments = 64);

/// A sphere about the origin.
[[nodiscard]] scene::Mesh sphere(double radius, int segments = 48);

/// A tube along a path of points, without caps; a closed path returns to its first point. The
/// texture runs along the path along u, and once around along v.
[[nodiscard]] scene::Mesh tube(std::span<const V3d> path, double radius, bool closed = false,
                               int segments = 20);

}  // namespace balcony::plates
