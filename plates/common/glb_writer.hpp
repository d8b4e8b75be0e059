// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Writes a scene as a binary glTF 2.0 file (GLB).

#include <cstdint>
#include <vector>

#include "balcony/scene.hpp"

namespace balcony::plates {

/// The bytes of a GLB file that holds the scene: one node an instance (named after its object) or
/// light, one mesh of a single primitive a mesh, embedded PNG images. Meshes are shared by their
/// instances. A z_up scene is turned to glTF's y up: (x, y, z) becomes (x, z, -y), in positions,
/// normals, placements and lights alike.
///
/// The scene must hold together: indices in range, normals and texture co-ordinates empty or one a
/// vertex, textures embedded as PNG. The same scene always gives the same bytes.
[[nodiscard]] std::vector<std::uint8_t> to_glb(const scene::Scene& scene);

}  // namespace balcony::plates
