// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "balcony/motion.hpp"
#include "scene/gltf/gltf_document.hpp"
#include "scene/gltf/gltf_node.hpp"

namespace balcony::scene {

/// Reads the animations of a glTF document, and finds out what moves while its nodes are visited.
class GltfAnimations {
public:
    GltfAnimations(GltfDocument& document, Import& import);

    /// To be called for each node before its mesh, light and camera are added to the scene: those
    /// that are added until the next call hang on it. Gives the node if it moves, by itself or with
    /// its parent. Throws PartError.
    NodeIndex visit(std::size_t gltf_node, NodeIndex parent, const M44d& world_from_parent);

    /// Where a node that moves stands at time 0.
    [[nodiscard]] M44d world_from_node(NodeIndex node) const;

    /// Whether the mesh of a node changes its shape.
    [[nodiscard]] bool deforms(const Json& node) const;

    /// Reads how the mesh of a node deforms, which is in the scene already, made of a primitive
    /// of the file: by vertex of the mesh, an element of the accessors. Throws PartError.
    void deform(std::size_t gltf_node, const Json& primitive, MeshIndex mesh,
                std::span<const std::uint32_t> elements);

    /// Whether joints place a mesh.
    [[nodiscard]] bool is_skinned(MeshIndex mesh) const { return skinned_.contains(mesh); }

    /// After the last node: gives the scene its motion, and meshes their shapes at time 0.
    void finish();

private:
    using NodeTracks = std::array<TrackIndex, 3>;  // Of translation, rotation, scale.

    // The numbers of a quantity, and in how many elements of an accessor they are.
    struct Numbers {
        std::size_t width = 0;
        std::size_t elements = 1;
    };

    void read_animation(std::size_t index);
    void read_channel(const Json& animation, std::size_t index, const Json& channel);
    TrackIndex track(const Json& animation, std::size_t index, std::size_t sampler,
                     const Numbers& numbers);
    [[nodiscard]] Track read_track(const Json& sampler, const Numbers& numbers);
    void hang_new_parts();

    // gltf_deformations.cpp
    void find_joints();
    void read_targets(const Json& node, std::size_t gltf_node, const Json& primitive,
                      std::span<const std::uint32_t> elements, Deformation& deformation);
    void read_influences(const Json& primitive, std::span<const std::uint32_t> elements,
                         Deformation& deformation);
    void bind(std::size_t skin, Deformation& deformation);
    void finish_deformations();

    GltfDocument& document_;
    Import& import_;
    Motion motion_;
    Budget numbers_;
    Budget depths_;
    std::map<std::pair<std::size_t, std::size_t>, TrackIndex> tracks_;  // By animation and sampler.
    std::map<std::size_t, NodeTracks> moved_;                           // By node of the file.
    std::map<std::size_t, TrackIndex> weight_tracks_;                   // By node of the file.
    std::map<TrackIndex, std::size_t> animation_of_;
    std::map<std::size_t, NodeIndex> joints_;        // By node of the file; invalid if not visited.
    std::vector<std::optional<std::size_t>> skins_;  // By deformation.
    std::set<MeshIndex> skinned_;
    std::vector<std::size_t> depth_;                        // Of the nodes in motion.
    NodeIndex visited_;                                     // The last one.
    std::size_t instances_ = 0, lights_ = 0, cameras_ = 0;  // Before it.
};

/// The number of morph targets of a node's mesh.
[[nodiscard]] std::size_t morph_target_count(const Json& root, const Json& node);

}  // namespace balcony::scene
