// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Faces of formats whose corners refer to separate lists: OBJ, PLY and STL.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/import.hpp"

namespace balcony::scene {

inline constexpr std::uint32_t no_index = 0xffffffffU;

/// Indices into the lists of a FaceSet; no_index if the corner has no such value.
struct Corner {
    std::uint32_t position = no_index;
    std::uint32_t texture_coordinate = no_index;
    std::uint32_t normal = no_index;
};

/// Faces without normals in one smoothing group are smooth across their common edges.
using SmoothingGroup = std::uint32_t;
inline constexpr SmoothingGroup flat = 0;
/// Smooth, except at edges sharper than 45 degrees.
inline constexpr SmoothingGroup smooth_by_angle = 0xffffffffU;

/// A triangle.
struct Face {
    std::array<Corner, 3> corners;
    SmoothingGroup smoothing = smooth_by_angle;
    std::uint32_t section = 0;
};

/// The faces of a file in sections, each of which becomes a mesh.
struct FaceSet {
    struct Section {
        std::string object;
        MaterialIndex material{};
        std::uint32_t object_number = 0;  ///< Sections of one object have the same.
    };

    std::vector<V3f> positions;
    std::vector<Color3f> colors;  ///< Linear; empty or one per position.
    std::vector<V2f> texture_coordinates;
    std::vector<V3f> normals;
    std::vector<Face> faces;
    std::vector<Section> sections;

    /// Adds the triangles of a polygon, or counts it as skipped. Texture coordinates and normals
    /// are used if all its corners have them; their indices are in range.
    void add_polygon(std::span<Corner> corners, SmoothingGroup smoothing, std::uint32_t section);
    void skip_out_of_range() { ++out_of_range_; }
    void warn_of_skipped(Import& import) const;

private:
    std::size_t out_of_range_ = 0;
    std::size_t not_usable_ = 0;
    std::size_t malformed_ = 0;
    std::vector<V3f> polygon_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
};

/// Gives all corners a normal. Positions with the same coordinates count as one.
void add_missing_normals(FaceSet& set, Import& import);

/// The part of loading that is done when a reader of faces begins to read its text, to add normals,
/// and to make meshes.
inline constexpr double text_begins = 0.1;
inline constexpr double normals_begin = 0.5;
inline constexpr double meshes_begin = 0.8;

/// Adds a mesh and an instance for each section that has a usable triangle, and the objects.
void add_to_scene(FaceSet set, Import& import);

}  // namespace balcony::scene
