// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
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

    /// After the last node: gives the scene its motion.
    void finish();

private:
    using NodeTracks = std::array<TrackIndex, 3>;  // Of translation, rotation, scale.

    void read_animation(std::size_t index);
    void read_channel(const Json& animation, std::size_t index, const Json& channel);
    TrackIndex track(const Json& animation, std::size_t index, std::size_t sampler,
                     std::size_t width);
    [[nodiscard]] Track read_track(const Json& sampler, std::size_t width);
    void hang_new_parts();

    GltfDocument& document_;
    Import& import_;
    Motion motion_;
    Budget numbers_;
    Budget depths_;
    std::map<std::pair<std::size_t, std::size_t>, TrackIndex> tracks_;  // By animation and sampler.
    std::map<std::size_t, NodeTracks> moved_;                           // By node of the file.
    std::map<TrackIndex, std::size_t> animation_of_;
    std::vector<std::size_t> depth_;                        // Of the nodes in motion.
    NodeIndex visited_;                                     // The last one.
    std::size_t instances_ = 0, lights_ = 0, cameras_ = 0;  // Before it.
};

}  // namespace balcony::scene
