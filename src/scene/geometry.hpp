// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/import.hpp"

namespace balcony::scene {

/// Converts a mesh from a file, with arbitrary numbers, into one that satisfies the invariants of
/// Mesh: skips triangles with an index out of range or a vertex that is not finite or too large,
/// triangles without area, copies beyond max_coincident, and unused vertices; adds flat normals to
/// a mesh without normals; normalises normals and tangents, replacing normals of length 0 by that
/// of the faces. Warns with counts and the mesh's name. Attributes of vertices must be empty or one
/// per vertex. Nothing if no triangle remains. For a mesh that will be deformed, which keeps all
/// copies, `vertices` receives, by vertex of the result, the vertex of the given mesh.
[[nodiscard]] std::optional<Mesh> finish_mesh(Mesh mesh, Import& import,
                                              std::vector<std::uint32_t>* vertices = nullptr);

/// A colour as formats of vertex colours store it, clamped to 0 .. 1, as linear light.
[[nodiscard]] Color3f linear_of_srgb(const Color3f& color);

/// Whether coordinates are finite and within max_coordinate.
[[nodiscard]] bool usable(const V3f& position);

}  // namespace balcony::scene
