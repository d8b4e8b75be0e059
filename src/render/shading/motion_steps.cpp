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

}  // namespace balcony::render
