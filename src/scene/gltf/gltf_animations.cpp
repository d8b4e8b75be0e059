// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/gltf/gltf_animations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace balcony::scene {

namespace {

constexpr std::array property_names{"translation", "rotation", "scale", "weights"};
constexpr std::array<std::size_t, 3> property_widths{3, 4, 3};

Interpolation interpolation_of(const std::string& name) {
    if (name == "LINEAR") {
        return Interpolation::linear;
    }
    if (name == "STEP") {
        return Interpolation::step;
    }
    if (name == "CUBICSPLINE") {
        return Interpolation::cubic_spline;
    }
    throw PartError{fmt::format("its interpolation {} is unknown", in_quotes(name))};
}

// Names are optional in the format.
std::string animation_name(const Json& animation, std::size_t index) {
    const std::string name = text_in(animation, "name");
    return name.empty() ? fmt::format("animation {}", index) : name;
}

// All numbers of an accessor.
std::vector<float> all_of(const GltfAccessor& accessor) {
    std::vector<std::uint32_t> elements(accessor.count());
    std::iota(elements.begin(), elements.end(), 0U);
    std::vector<float> numbers(accessor.count() * accessor.components());
    accessor.read(elements, numbers.data());
    return numbers;
}

}  // namespace

// Accessors can share the bytes of a file, and nodes can share a chain of parents.
GltfAnimations::GltfAnimations(GltfDocument& document, Import& import)
    : document_(document),
      import_(import),
      numbers_(4 * document.size() + (std::size_t{1} << 22U),
               "the file's animations have more numbers than a file of its size may have"),
      depths_(document.size() + (std::size_t{1} << 20U),
              "the file's moving nodes are nested deeper than in a file of its size") {
    for (std::size_t i = 0; i < array_size(document.root(), "animations"); ++i) {
        read_animation(i);
    }
    find_joints();
}

void GltfAnimations::read_animation(std::size_t index) {
    const Json& animation = member(document_.root(), "animations")[index];
    const std::string name = animation_name(animation, index);
    motion_.animations.push_back({name, 0.0, 0});
    for (std::size_t i = 0; i < array_size(animation, "channels"); ++i) {
        const Json& channel = animation["channels"][i];
        try {
            read_channel(animation, index, channel);
        } catch (const PartError& fault) {
            const Json& target = member(channel, "target");
            import_.warn(
                fmt::format("animation {}: channel {} ({}) is skipped: {}", in_quotes(name), i,
                            printable(text_in(target, "path", "without a path")), fault.reason));
        }
    }
}

void GltfAnimations::read_channel(const Json& animation, std::size_t index, const Json& channel) {
    const Json& target = member(channel, "target");
    const auto node = index_in(target, "node");
    // Extensions animate other things than nodes.
    if (!node) {
        return;
    }
    const std::string path = text_in(target, "path");
    const auto* const found = std::find(property_names.begin(), property_names.end(), path);
    if (found == property_names.end()) {
        throw PartError{fmt::format("{} cannot be animated", in_quotes(path))};
    }
    const auto moved = static_cast<std::size_t>(found - property_names.begin());
    const Json& moved_node = element(document_.root(), "nodes", *node);
    if (path != "weights" && !member(moved_node, "matrix").is_null()) {
        throw PartError{fmt::format("its node {} has a matrix, which cannot be animated",
                                    in_quotes(node_name(moved_node, *node)))};
    }
    const auto sampler = index_in(channel, "sampler");
    if (!sampler) {
        throw PartError{"it has no sampler"};
    }
    const bool is_weights = moved == property_widths.size();
    const std::size_t targets = morph_target_count(document_.root(), moved_node);
    if (is_weights && targets == 0) {
        throw PartError{fmt::format("its node {} has no morph targets",
                                    in_quotes(node_name(moved_node, *node)))};
    }
    const TrackIndex made =
        track(animation, index, *sampler,
              is_weights ? Numbers{targets, targets} : Numbers{property_widths[moved]});
    TrackIndex& slot = is_weights ? weight_tracks_[*node] : moved_[*node][moved];
    if (slot.valid()) {
        throw PartError{fmt::format("animation {} moves the node {} already",
                                    in_quotes(motion_.animations[animation_of_[slot]].name),
                                    in_quotes(node_name(moved_node, *node)))};
    }
    slot = made;
    Animation& followed = motion_.animations[index];
    followed.duration = std::max(followed.duration, motion_.tracks[made.value()].times.back());
    ++followed.channels;
}

TrackIndex GltfAnimations::track(const Json& animation, std::size_t index, std::size_t sampler,
                                 const Numbers& numbers) {
    const auto known = tracks_.find({index, sampler});
    if (known != tracks_.end()) {
        if (motion_.tracks[known->second.value()].width != numbers.width) {
            throw PartError{
                fmt::format("its sampler {} is also that of another property", sampler)};
        }
        return known->second;
    }
    Track made = read_track(element(animation, "samplers", sampler), numbers);
    const TrackIndex track(motion_.tracks.size());
    motion_.tracks.push_back(std::move(made));
    animation_of_[track] = index;
    tracks_[{index, sampler}] = track;
    return track;
}

// glTF 2.0, section 3.11.
Track GltfAnimations::read_track(const Json& sampler, const Numbers& numbers) {
    Track track;
    track.width = numbers.width;
    track.interpolation = interpolation_of(text_in(sampler, "interpolation", "LINEAR"));
    const auto input = index_in(sampler, "input");
    const auto output = index_in(sampler, "output");
    if (!input || !output) {
        throw PartError{"its sampler has no 'input' or no 'output'"};
    }
    const GltfAccessor& times = document_.accessor(*input, 1);
    const GltfAccessor& values = document_.accessor(*output, numbers.width / numbers.elements);
    const std::size_t rows =
        numbers.elements * (track.interpolation == Interpolation::cubic_spline ? 3 : 1);
    if (times.count() == 0 || values.count() != rows * times.count()) {
        throw PartError{fmt::format("it has {} and {} where {} are required",
                                    counted(times.count(), "key"), counted(values.count(), "value"),
                                    std::max<std::size_t>(rows * times.count(), 1))};
    }
    numbers_.take(times.count() + values.count() * values.components());
    const std::vector<float> seconds = all_of(times);
    for (std::size_t key = 0; key < seconds.size(); ++key) {
        const double time = seconds[key];
        if (!std::isfinite(time) || (key > 0 && !(time > track.times.back()))) {
            throw PartError{fmt::format("its times do not increase at key {}", key)};
        }
        track.times.push_back(time);
    }
    track.values = all_of(values);
    for (std::size_t i = 0; i < track.values.size(); ++i) {
        if (!std::isfinite(track.values[i])) {
            throw PartError{fmt::format("its value {} is not finite", i / values.components())};
        }
    }
    return track;
}

NodeIndex GltfAnimations::visit(std::size_t gltf_node, NodeIndex parent,
                                const M44d& world_from_parent) {
    hang_new_parts();
    visited_ = {};
    const auto moved = moved_.find(gltf_node);
    const auto joint = joints_.find(gltf_node);
    if (moved == moved_.end() && joint == joints_.end() && !parent.valid()) {
        return {};
    }
    const Json& json = member(document_.root(), "nodes")[gltf_node];
    Node node{parent, world_from_parent, local_transform(json), {}, {}, {}, {}, {}, {}};
    if (moved != moved_.end()) {
        const GltfTransform rest(json);
        node.translation = rest.translation;
        node.rotation = rest.rotation;
        node.scale = rest.scale;
        node.translation_track = moved->second[0];
        node.rotation_track = moved->second[1];
        node.scale_track = moved->second[2];
    }
    const std::size_t depth = parent.valid() ? depth_[parent.value()] + 1 : 1;
    depths_.take(depth);
    motion_.nodes.push_back(node);
    depth_.push_back(depth);
    visited_ = NodeIndex(motion_.nodes.size() - 1);
    if (joint != joints_.end()) {
        joint->second = visited_;
    }
    return visited_;
}

M44d GltfAnimations::world_from_node(NodeIndex node) const {
    return scene::world_from_node(motion_, node, 0.0);
}

void GltfAnimations::hang_new_parts() {
    const Scene& scene = import_.scene;
    if (visited_.valid()) {
        for (std::size_t i = instances_; i < scene.instances.size(); ++i) {
            if (!skinned_.contains(scene.instances[i].mesh)) {
                motion_.instances.push_back({i, visited_});
            }
        }
        for (std::size_t i = lights_; i < scene.lights.size(); ++i) {
            motion_.lights.push_back({i, visited_});
        }
        for (std::size_t i = cameras_; i < scene.cameras.size(); ++i) {
            motion_.cameras.push_back({i, visited_});
        }
    }
    instances_ = scene.instances.size();
    lights_ = scene.lights.size();
    cameras_ = scene.cameras.size();
}

void GltfAnimations::finish() {
    hang_new_parts();
    finish_deformations();
    const bool moves = !motion_.animations.empty();
    if (!moves && motion_.deformations.empty()) {
        return;
    }
    import_.scene.motion = std::make_shared<const Motion>(std::move(motion_));
    Result<Scene> placed = moved_to(std::move(import_.scene), 0.0);
    import_.scene = std::move(*placed);
    for (const Diagnostic& found : placed.diagnostics) {
        import_.warn(found.message, found.remedy);
    }
    if (!moves) {
        import_.scene.motion = nullptr;
    }
}

}  // namespace balcony::scene
