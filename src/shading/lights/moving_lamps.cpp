// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/moving_lamps.hpp"

#include <cmath>

#include "shading/lights/punctual.hpp"

namespace balcony::render {

MovingLamps::MovingLamps(const scene::Scene& scene, const scene::Movement& movement)
    : scene_(&scene) {
    for (const scene::LightSteps& moving : movement.lights) {
        const scene::Light& light = scene.lights[moving.light];
        if (light.kind == scene::LightKind::directional) {
            continue;
        }
        std::vector<scene::Light>& steps = steps_[moving.light];
        for (std::size_t i = 0; i < moving.positions.size(); ++i) {
            steps.push_back(light);
            steps.back().position = moving.positions[i];
            steps.back().direction = moving.directions[i];
        }
    }
}

const scene::Light& MovingLamps::lamp(std::size_t light, float time) const {
    const auto moving = steps_.empty() ? steps_.end() : steps_.find(light);
    if (moving == steps_.end()) {
        return scene_->lights[light];
    }
    const std::vector<scene::Light>& steps = moving->second;
    return steps[static_cast<std::size_t>(
        std::lround(time * static_cast<float>(steps.size() - 1)))];
}

LightBounds MovingLamps::bounds(std::size_t light) const {
    const auto moving = steps_.find(light);
    if (moving == steps_.end()) {
        return bounds_of(scene_->lights[light], scene_->meters_per_unit);
    }
    std::vector<LightBounds> all;
    for (const scene::Light& lamp : moving->second) {
        all.push_back(bounds_of(lamp, scene_->meters_per_unit));
        all.back().power /= static_cast<float>(moving->second.size());
    }
    return bounds_of(all);
}

}  // namespace balcony::render
