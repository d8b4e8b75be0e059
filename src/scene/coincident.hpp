// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Geometry in the same place. A ray meets all of it, so that each ray of a scene with very much of
// it would take as long as a picture.

#include <cstddef>

#include "balcony/scene.hpp"

namespace balcony::scene {

/// How many triangles, or instances, may lie in the same place. Opaque ones cannot be told apart;
/// transparent ones, of which some are left out, let more light through than all of them would.
inline constexpr std::size_t max_coincident = 16;

/// Removes the triangles that have the same corners as max_coincident earlier ones of the mesh.
/// Returns their number.
std::size_t drop_coincident_triangles(Mesh& mesh);

/// Removes the instances that stand still where max_coincident earlier ones with the same triangles
/// do. Returns their number. Their objects remain.
std::size_t drop_coincident_instances(Scene& scene);

}  // namespace balcony::scene
