// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The text of a scene whose camera is replaced by a mesh_camera.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "balcony/base.hpp"
#include "bridge/povray/camera_mesh.hpp"
#include "bridge/povray/scene_axes.hpp"

namespace balcony::bridge::povray {

/// The mesh of some rows of POV-Ray's picture.
struct StripMesh {
    std::size_t first_row = 0;
    CameraMesh mesh;
};

/// The picture that POV-Ray renders: strips one below the other.
struct MeshPicture {
    std::size_t width = 0;
    std::size_t height = 0;
    std::span<const StripMesh> strips;
    /// Whether each sample has a face of its own, with distribution 0.
    bool single_faces = false;
};

/// POV-Ray 3.7 shows the first row of such faces in the rows 0 and 1 of its picture, the second one
/// in row 2, and so on.
inline constexpr std::size_t first_row_of_single_faces = 1;

/// Writes a copy of the scene with the camera behind it, so that the places of POV-Ray's messages
/// are right and the camera is the one that counts, the last.
[[nodiscard]] Diagnostics write_scene(const std::filesystem::path& file, std::string_view scene,
                                      const MeshPicture& picture, const MeshFrame& frame,
                                      const AxesRow& axes);

}  // namespace balcony::bridge::povray
