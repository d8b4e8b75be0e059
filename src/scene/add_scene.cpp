// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <iterator>
#include <utility>

#include "balcony/motion.hpp"
#include "balcony/scene.hpp"
#include "scene/axes.hpp"

namespace balcony::scene {

namespace {

template <class Index>
void shift(Index& index, std::size_t by) {
    if (index.valid()) {
        index = Index(index.value() + by);
    }
}

template <class Element>
void append(std::vector<Element>& all, std::vector<Element> added) {
    std::move(added.begin(), added.end(), std::back_inserter(all));
}

// The vertices of a mesh that follows joints are in the world by these, before its instance places
// them.
bool follows_joints(const Scene& scene, MeshIndex mesh) {
    return scene.motion &&
           std::any_of(scene.motion->deformations.begin(), scene.motion->deformations.end(),
                       [mesh](const Deformation& deformation) {
                           return deformation.mesh == mesh && !deformation.joints.empty();
                       });
}

// A node without a parent stands in a world with other axes.
void add_motion(Scene& scene, const Motion& added, const M44d& scene_from_added) {
    Motion all = scene.motion ? *scene.motion : Motion{};
    const std::size_t tracks = all.tracks.size();
    const std::size_t nodes = all.nodes.size();
    append(all.animations, added.animations);
    append(all.tracks, added.tracks);
    for (Node node : added.nodes) {
        if (!node.parent.valid()) {
            node.world_from_parent *= scene_from_added;
        }
        shift(node.parent, nodes);
        for (TrackIndex Node::*track :
             {&Node::translation_track, &Node::rotation_track, &Node::scale_track}) {
            shift(node.*track, tracks);
        }
        all.nodes.push_back(node);
    }
    for (MovingInstance moving : added.instances) {
        moving.instance += scene.instances.size();
        shift(moving.node, nodes);
        all.instances.push_back(moving);
    }
    for (MovingLight moving : added.lights) {
        moving.light += scene.lights.size();
        shift(moving.node, nodes);
        all.lights.push_back(moving);
    }
    for (MovingCamera moving : added.cameras) {
        moving.camera += scene.cameras.size();
        shift(moving.node, nodes);
        all.cameras.push_back(moving);
    }
    for (Deformation deformation : added.deformations) {
        shift(deformation.mesh, scene.meshes.size());
        shift(deformation.weights_track, tracks);
        for (Joint& joint : deformation.joints) {
            shift(joint.node, nodes);
        }
        all.deformations.push_back(std::move(deformation));
    }
    scene.motion = std::make_shared<const Motion>(std::move(all));
}

}  // namespace

void add_scene(Scene& scene, Scene added) {
    const M44d scene_from_added = turning(added.axes, scene.axes);
    const M44d added_from_scene = turning(scene.axes, added.axes);
    if (added.motion) {
        add_motion(scene, *added.motion, scene_from_added);
    }
    for (Material& material : added.materials) {
        for (const auto use : texture_uses) {
            shift((material.*use).index, scene.textures.size());
        }
    }
    for (Shared<Mesh>& mesh : added.meshes) {
        shift(mesh.edit().material, scene.materials.size());
    }
    for (Instance& instance : added.instances) {
        instance.world_from_mesh *= scene_from_added;
        if (follows_joints(added, instance.mesh)) {
            instance.world_from_mesh = added_from_scene * instance.world_from_mesh;
        }
        shift(instance.mesh, scene.meshes.size());
        instance.object += static_cast<std::uint32_t>(scene.objects.size());
    }
    for (Light& light : added.lights) {
        light.position = turned(light.position, added.axes, scene.axes);
        light.direction = turned(light.direction, added.axes, scene.axes);
    }
    for (Camera& camera : added.cameras) {
        for (V3d Camera::*axis :
             {&Camera::position, &Camera::right, &Camera::up, &Camera::forward}) {
            camera.*axis = turned(camera.*axis, added.axes, scene.axes);
        }
    }
    append(scene.meshes, std::move(added.meshes));
    append(scene.instances, std::move(added.instances));
    append(scene.objects, std::move(added.objects));
    append(scene.materials, std::move(added.materials));
    append(scene.textures, std::move(added.textures));
    append(scene.lights, std::move(added.lights));
    append(scene.cameras, std::move(added.cameras));
    append(scene.files, std::move(added.files));
    scene.default_light = scene.default_light && added.default_light;
    scene.emission_scale =
        scene.emission_scale == 1.0F ? added.emission_scale : scene.emission_scale;
}

}  // namespace balcony::scene
