// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/import.hpp"

namespace balcony::scene {

/// Turns a mesh as a file gives it, with any numbers at all, into one that keeps Mesh's promises:
/// leaves out triangles with an index out of range or a corner that is no usable number, and
/// vertices that no triangle uses; gives flat normals to a mesh that has none; makes normals unit
/// length, with that of the faces where one has no length. Warns with counts and the mesh's name.
/// Normals and texture co-ordinates must be empty or one a vertex. Nothing if no triangle is left.
[[nodiscard]] std::optional<Mesh> finish_mesh(Mesh mesh, Import& import);

/// Whether coordinates are finite and within max_coordinate.
[[nodiscard]] bool usable(const V3f& position);

}  // namespace balcony::scene
