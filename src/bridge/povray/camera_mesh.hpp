// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The rays of a camera layer as a triangle mesh, in the axes of the rays, y up and right-handed.
//
// POV-Ray's mesh_camera with distribution 3 finds the face around a pixel by (u, v), interpolates
// its vertices P and normals N, and casts the ray from P - offset N along N. Vertices that lie
// `offset` ahead of the rays' origins therefore give rays that are exact at the vertices; the mesh
// does not collapse where all rays have one origin. Where the rays between the vertices deviate
// too much, cells are divided, at last into single pixels with a face of their own.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/picture_samples.hpp"

namespace balcony::bridge::povray {

using Imath::V2d;
using Imath::V3d;
using Imath::V3f;

/// What the meshes of one picture share.
struct MeshFrame {
    V3d center{0.0};      ///< Vertices are relative to it, so that floats suffice.
    double extent = 1.0;  ///< The largest distance of an origin from the center, or 1 if that is 0.
    double offset = 1.0;  ///< From the origin of a ray to its vertex.
};

/// Chosen for good triangles at a coarse grid of rays of all layers.
[[nodiscard]] MeshFrame mesh_frame(render::PictureSamples& samples, std::size_t width,
                                   std::size_t height);

using Face = std::array<std::uint32_t, 3>;

struct CameraMesh {
    std::vector<V3f> vertices;
    std::vector<V3f> normals;  ///< By vertex: directions of unit length.
    std::vector<V2d> places;   ///< By vertex: the column and row of pixels, 0 at a sample.
    std::vector<Face> faces;

    std::uint64_t rays = 0;
    std::uint64_t single_rays = 0;
    double largest_error = 0.0;  ///< In pixels, of all rays at all distances tested.
    bool complete = true;        ///< False if there would be too many faces.
};

/// The interpolating mesh of a layer in a pass. Fills `seen`, for the whole picture, and gives up
/// at more than max_faces.
[[nodiscard]] CameraMesh make_camera_mesh(render::PictureSamples& samples, std::size_t layer,
                                          std::size_t pass, std::size_t width, std::size_t height,
                                          const MeshFrame& frame, std::size_t max_faces,
                                          std::vector<std::uint8_t>& seen);

/// A face for each sample in a region, in their order, for distribution 0: the centroid is the
/// origin of the ray and the normal its direction. There are neither normals nor places.
[[nodiscard]] CameraMesh make_single_faces(render::PictureSamples& samples, std::size_t layer,
                                           std::size_t pass, const render::Region& region,
                                           const MeshFrame& frame, std::vector<std::uint8_t>& seen);

}  // namespace balcony::bridge::povray
