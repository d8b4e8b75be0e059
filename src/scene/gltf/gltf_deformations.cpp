// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Morph targets and skins.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "scene/geometry.hpp"
#include "scene/gltf/gltf_animations.hpp"

namespace balcony::scene {

namespace {

// The elements of an attribute of a primitive or of a morph target; empty if there is none.
template <class Vector>
std::vector<Vector> attribute(GltfDocument& document, const Json& attributes,
                              const std::string& key, std::span<const std::uint32_t> elements) {
    const auto index = index_in(attributes, key);
    if (!index) {
        return {};
    }
    const GltfAccessor& found = document.accessor(*index, Vector::dimensions());
    if (std::any_of(elements.begin(), elements.end(),
                    [&](std::uint32_t element) { return element >= found.count(); })) {
        throw PartError{fmt::format("its {} are fewer than its positions", key)};
    }
    std::vector<Vector> values(elements.size());
    found.read(elements, reinterpret_cast<float*>(values.data()));
    return values;
}

void check_displacements(const std::vector<V3f>& displacements) {
    if (!std::all_of(displacements.begin(), displacements.end(), usable)) {
        throw PartError{"a displacement of its morph targets is not finite or too large"};
    }
}

}  // namespace

std::size_t morph_target_count(const Json& root, const Json& node) {
    const auto mesh = index_in(node, "mesh");
    if (!mesh) {
        return 0;
    }
    const Json& primitives = member(element(root, "meshes", *mesh), "primitives");
    return primitives.is_array() && !primitives.empty() ? array_size(primitives[0], "targets") : 0;
}

bool GltfAnimations::deforms(const Json& node) const {
    return !member(node, "skin").is_null() || morph_target_count(document_.root(), node) > 0;
}

void GltfAnimations::deform(std::size_t gltf_node, const Json& primitive, MeshIndex mesh,
                            std::span<const std::uint32_t> elements) {
    const Json& node = member(document_.root(), "nodes")[gltf_node];
    const Mesh& made = import_.scene.meshes[mesh.value()];
    Deformation deformation;
    deformation.mesh = mesh;
    deformation.positions = made.positions;
    deformation.normals = made.normals;
    if (!index_in(member(primitive, "attributes"), "NORMAL")) {
        deformation.flat = made.triangles;
    }
    read_targets(node, gltf_node, primitive, elements, deformation);
    const std::optional<std::size_t> skin = index_in(node, "skin");
    if (skin) {
        read_influences(primitive, elements, deformation);
        skinned_.insert(mesh);
    }
    motion_.deformations.push_back(std::move(deformation));
    skins_.push_back(skin);
}

void GltfAnimations::read_targets(const Json& node, std::size_t gltf_node, const Json& primitive,
                                  std::span<const std::uint32_t> elements,
                                  Deformation& deformation) {
    const std::size_t count = array_size(primitive, "targets");
    for (std::size_t i = 0; i < count; ++i) {
        const Json& target = primitive["targets"][i];
        numbers_.take(6 * elements.size());
        MorphTarget read{attribute<V3f>(document_, target, "POSITION", elements),
                         attribute<V3f>(document_, target, "NORMAL", elements)};
        check_displacements(read.positions);
        check_displacements(read.normals);
        deformation.targets.push_back(std::move(read));
    }
    const Json& mesh = element(document_.root(), "meshes", count_in(node, "mesh", 0));
    const Json& owner = member(node, "weights").is_null() ? mesh : node;
    for (const double weight : numbers_in(owner, "weights", std::vector<double>(count, 0.0))) {
        deformation.weights.push_back(static_cast<float>(weight));
    }
    const auto track = weight_tracks_.find(gltf_node);
    if (count > 0 && track != weight_tracks_.end() &&
        motion_.tracks[track->second.value()].width == count) {
        deformation.weights_track = track->second;
    }
}

// Weights that do not add up to 1 are scaled; a vertex without weights follows the first joint.
void GltfAnimations::read_influences(const Json& primitive, std::span<const std::uint32_t> elements,
                                     Deformation& deformation) {
    const Json& attributes = member(primitive, "attributes");
    std::vector<std::vector<V4f>> joints;
    std::vector<std::vector<V4f>> weights;
    for (std::size_t set = 0; index_in(attributes, fmt::format("JOINTS_{}", set)); ++set) {
        numbers_.take(16 * elements.size());
        joints.push_back(
            attribute<V4f>(document_, attributes, fmt::format("JOINTS_{}", set), elements));
        weights.push_back(
            attribute<V4f>(document_, attributes, fmt::format("WEIGHTS_{}", set), elements));
    }
    if (joints.empty() ||
        std::any_of(weights.begin(), weights.end(), [](const auto& set) { return set.empty(); })) {
        throw PartError{"it has a skin, but no JOINTS_0 and WEIGHTS_0"};
    }
    for (std::size_t vertex = 0; vertex < elements.size(); ++vertex) {
        const std::size_t first = deformation.influences.size();
        float total = 0.0F;
        for (std::size_t set = 0; set < joints.size(); ++set) {
            for (int i = 0; i < 4; ++i) {
                const float weight = weights[set][vertex][i];
                const float joint = joints[set][vertex][i];
                const bool counts = weight > 0.0F && std::isfinite(weight) && joint >= 0.0F;
                deformation.influences.push_back(
                    {counts ? static_cast<std::uint32_t>(joint) : 0, counts ? weight : 0.0F});
                total += deformation.influences.back().weight;
            }
        }
        if (!(total > 0.0F)) {
            deformation.influences[first].weight = total = 1.0F;
        }
        for (std::size_t i = first; i < deformation.influences.size(); ++i) {
            deformation.influences[i].weight /= total;
        }
    }
}

void GltfAnimations::find_joints() {
    for (std::size_t i = 0; i < array_size(document_.root(), "skins"); ++i) {
        try {
            for (const std::size_t joint :
                 indices_in(member(document_.root(), "skins")[i], "joints")) {
                joints_.emplace(joint, NodeIndex());
            }
        } catch (const PartError& fault) {
            import_.warn(fmt::format("skin {} is skipped: {}", i, fault.reason));
        }
    }
}

void GltfAnimations::bind(std::size_t skin, Deformation& deformation) {
    const Json& json = element(document_.root(), "skins", skin);
    const std::vector<std::size_t> joints = indices_in(json, "joints");
    numbers_.take(16 * joints.size());
    std::vector<float> matrices;
    if (const auto accessor = index_in(json, "inverseBindMatrices")) {
        const GltfAccessor& found = document_.accessor(*accessor, 16);
        if (found.count() < joints.size()) {
            throw PartError{fmt::format("it has {} and {} of their matrices",
                                        counted(joints.size(), "joint"), found.count())};
        }
        std::vector<std::uint32_t> elements(joints.size());
        std::iota(elements.begin(), elements.end(), 0U);
        matrices.resize(16 * joints.size());
        found.read(elements, matrices.data());
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const NodeIndex node = joints_[joints[i]];
        if (!node.valid()) {
            throw PartError{fmt::format("its joint {} is not in the scene", i)};
        }
        Joint joint{node, M44d()};
        for (std::size_t k = 0; k < 16 && !matrices.empty(); ++k) {
            const float number = matrices[16 * i + k];
            if (!std::isfinite(number)) {
                throw PartError{fmt::format("the matrix of its joint {} is not finite", i)};
            }
            joint.joint_from_mesh[static_cast<int>(k / 4)][k % 4] = static_cast<double>(number);
        }
        deformation.joints.push_back(joint);
    }
    for (const Influence& influence : deformation.influences) {
        if (influence.joint >= joints.size()) {
            throw PartError{
                fmt::format("a vertex follows joint {} of {}", influence.joint, joints.size())};
        }
    }
}

void GltfAnimations::finish_deformations() {
    for (std::size_t i = 0; i < skins_.size(); ++i) {
        Deformation& deformation = motion_.deformations[i];
        const std::string name = import_.scene.meshes[deformation.mesh.value()]->name;
        try {
            if (skins_[i]) {
                bind(*skins_[i], deformation);
            }
        } catch (const PartError& fault) {
            import_.warn(fmt::format("mesh {} is shown as stored, without skinning: {}",
                                     in_quotes(name), fault.reason));
            deformation.joints.clear();
        }
    }
}

}  // namespace balcony::scene
