// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/geometry/motion_steps.hpp"

#include <algorithm>

namespace balcony::render {

BetweenSteps::BetweenSteps(float time, std::size_t count) {
    if (count > 1) {
        const float place = time * static_cast<float>(count - 1);
        before = std::min(static_cast<std::size_t>(std::max(place, 0.0F)), count - 2);
        part = place - static_cast<float>(before);
    }
}

MotionSteps::MotionSteps(const scene::Scene& scene, const scene::Movement& movement)
    : scene_(&scene) {
    for (const scene::InstanceSteps& steps : movement.instances) {
        instances_.emplace(steps.instance, &steps);
    }
    for (const scene::MeshSteps& steps : movement.meshes) {
        shapes_.emplace(steps.mesh.value(), steps.shapes.get());
    }
}

std::size_t MotionSteps::shape_count(scene::MeshIndex mesh) const {
    const auto found = shapes_.find(mesh.value());
    return found == shapes_.end() ? 1 : found->second->size();
}

scene::M44d MotionSteps::matrix(std::size_t instance, float time) const {
    const std::span<const scene::M44d> steps = matrices(instance);
    const BetweenSteps place(time, steps.size());
    const auto part = static_cast<double>(place.part);
    return part == 0.0 ? steps[place.before]
                       : steps[place.before] * (1.0 - part) + steps[place.before + 1] * part;
}

Imath::V3f MotionSteps::position(scene::MeshIndex mesh, std::size_t vertex, float time) const {
    const auto found = shapes_.find(mesh.value());
    if (found == shapes_.end()) {
        return scene_->meshes[mesh.value()]->positions[vertex];
    }
    const std::vector<scene::Shape>& shapes = *found->second;
    const BetweenSteps place(time, shapes.size());
    const Imath::V3f& before = shapes[place.before].positions[vertex];
    return place.part == 0.0F ? before
                              : (1.0F - place.part) * before +
                                    place.part * shapes[place.before + 1].positions[vertex];
}

MovingPlacements::MovingPlacements(const scene::Movement& movement) {
    for (const scene::InstanceSteps& steps : movement.instances) {
        std::vector<Imath::M44f>& matrices = steps_[static_cast<std::uint32_t>(steps.instance)];
        for (const scene::M44d& world_from_mesh : steps.world_from_mesh) {
            matrices.emplace_back(world_from_mesh);
        }
    }
}

std::optional<Imath::M44f> MovingPlacements::world_from_mesh(std::uint32_t instance,
                                                             float time) const {
    const auto moving = steps_.find(instance);
    if (moving == steps_.end()) {
        return std::nullopt;
    }
    const std::vector<Imath::M44f>& steps = moving->second;
    const BetweenSteps place(time, steps.size());
    return steps[place.before] * (1.0F - place.part) + steps[place.before + 1] * place.part;
}

std::size_t MovingPlacements::step_count(std::uint32_t instance) const {
    const auto moving = steps_.find(instance);
    return moving == steps_.end() ? 1 : moving->second.size();
}

MovingMeshes::MovingMeshes(const scene::Movement& movement) {
    for (const scene::MeshSteps& steps : movement.meshes) {
        shapes_.emplace(steps.mesh.value(), steps.shapes);
    }
}

std::optional<MeshCorners> MovingMeshes::corners(scene::MeshIndex mesh,
                                                 const std::array<std::uint32_t, 3>& triangle,
                                                 float time) const {
    const auto moving = shapes_.find(mesh.value());
    if (moving == shapes_.end()) {
        return std::nullopt;
    }
    const std::vector<scene::Shape>& shapes = *moving->second;
    const BetweenSteps place(time, shapes.size());
    const scene::Shape& a = shapes[place.before];
    const scene::Shape& b = shapes[place.before + 1];
    MeshCorners found;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex = triangle[i];
        found.positions[i] =
            (1.0F - place.part) * a.positions[vertex] + place.part * b.positions[vertex];
        if (!a.normals.empty()) {
            found.normals[i] =
                (1.0F - place.part) * a.normals[vertex] + place.part * b.normals[vertex];
        }
    }
    return found;
}

std::size_t MovingMeshes::step_count(scene::MeshIndex mesh) const {
    const auto moving = shapes_.find(mesh.value());
    return moving == shapes_.end() ? 1 : moving->second->size();
}

}  // namespace balcony::render
