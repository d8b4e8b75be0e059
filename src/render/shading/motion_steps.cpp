// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/shading/motion_steps.hpp"

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

}  // namespace balcony::render
