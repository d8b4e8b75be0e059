// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "balcony/motion.hpp"
#include "shading/lights/light_bounds.hpp"

namespace balcony::render {

/// The lights of a scene that have no surface, at the times of rays. A lamp that moves is in the
/// nearest of its steps; a directional light is where it is in the scene. The scene must outlive
/// the object.
class MovingLamps {
public:
    MovingLamps(const scene::Scene& scene, const scene::Movement& movement);

    /// By index into Scene::lights.
    [[nodiscard]] const scene::Light& lamp(std::size_t light, float time) const;

    /// Of a point or a spot light, wherever it moves.
    [[nodiscard]] LightBounds bounds(std::size_t light) const;

private:
    const scene::Scene* scene_;
    std::unordered_map<std::size_t, std::vector<scene::Light>> steps_;
};

}  // namespace balcony::render
