// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Imath/ImathMatrix.h>

#include "scene/gltf/gltf_animations.hpp"
#include "scene/gltf/gltf_document.hpp"
#include "scene/gltf/gltf_materials.hpp"

namespace balcony::scene {

/// Makes a Scene from a glTF document: only the parts that the nodes of its scene use.
class GltfReader {
public:
    GltfReader(GltfDocument& document, Import& import);

    void read();

private:
    struct Node {
        std::size_t index = 0;
        M44d world_from_parent;
        NodeIndex moving_parent;
    };

    // gltf_geometry.cpp
    [[nodiscard]] std::vector<std::size_t> root_nodes() const;
    void read_node(const Node& node, std::vector<Node>& pending);
    void place_mesh(const Json& node, std::size_t node_index, const M44d& world_from_node);
    void warn_of_what_is_not_read();

    // gltf_meshes.cpp
    /// The meshes of a node: shared with other nodes unless it deforms them.
    const std::vector<MeshIndex>& meshes(std::size_t gltf_mesh,
                                         std::optional<std::size_t> deformer);
    void read_primitive(const Json& primitive, const std::string& name,
                        std::optional<std::size_t> deformer, std::vector<MeshIndex>& made);
    void deform(const Json& primitive, std::size_t deformer, MeshIndex mesh,
                std::span<const std::uint32_t> elements);
    /// `elements` receives, by vertex, the element of the accessors.
    [[nodiscard]] Mesh read_mesh(const Json& primitive, std::size_t mode,
                                 const GltfMaterial& material, const std::string& name,
                                 std::vector<std::uint32_t>& elements);
    [[nodiscard]] std::vector<std::array<std::uint32_t, 3>> read_triangles(const Json& primitive,
                                                                           std::size_t mode,
                                                                           std::size_t vertices);
    std::vector<std::uint32_t> number_vertices(std::vector<std::array<std::uint32_t, 3>>& triangles,
                                               std::size_t count);

    // gltf_lights.cpp
    void place_light(const Json& node, const M44d& world_from_node);

    // gltf_cameras.cpp
    void place_camera(const Json& node, const M44d& world_from_node);

    GltfDocument& document_;
    const Json& root_;
    Import& import_;
    Scene& scene_;
    GltfMaterials materials_;
    GltfAnimations animations_;
    Budget corners_;
    Budget instances_;
    // By mesh of the file and the node that deforms it.
    std::map<std::pair<std::size_t, std::optional<std::size_t>>, std::vector<MeshIndex>> meshes_;
    std::vector<Box3f> boxes_;                   // Of the scene's meshes.
    std::vector<std::uint32_t> vertex_numbers_;  // Scratch of number_vertices.
    std::set<std::size_t> visited_nodes_;
    std::size_t dropped_points_ = 0;
    std::size_t dropped_lines_ = 0;
};

}  // namespace balcony::scene
