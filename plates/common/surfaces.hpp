// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Meshes of smooth surfaces.

#include <functional>

#include "balcony/scene.hpp"

namespace balcony::plates {

/// A surface by a formula of u and v from 0 to 1, as columns × rows quadrangles. Its outside is on
/// the side of the cross product of the tangents along u and v. The texture has u to the right and
/// v upwards.
using SurfacePoint = std::function<scene::V3d(double u, double v)>;
[[nodiscard]] scene::Mesh smooth_surface(int columns, int rows, const SurfacePoint& point);

}  // namespace balcony::plates
