// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "balcony/scene.hpp"

namespace balcony::scene {

/// Whether a mesh that is placed emits light.
[[nodiscard]] inline bool has_emission(const Scene& scene) {
    return std::any_of(
        scene.instances.begin(), scene.instances.end(), [&](const Instance& instance) {
            const Mesh& mesh = scene.meshes[instance.mesh.value()];
            return scene.materials[mesh.material.value()].emission != Color3f(0.0F, 0.0F, 0.0F);
        });
}

/// Says in the scene whether it has no light.
inline void find_default_light(Scene& scene) {
    scene.default_light = scene.lights.empty() && !has_emission(scene);
}

}  // namespace balcony::scene
