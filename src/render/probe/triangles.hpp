// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "balcony/scene.hpp"

namespace balcony::render {

/// Calls a function with the corners of every triangle of a scene or of an object, with z up.
template <class Function>
void for_each_triangle(const scene::Scene& scene, std::optional<std::uint32_t> object,
                       const Function& function) {
    for (const scene::Instance& instance : scene.instances) {
        if (object && instance.object != *object) {
            continue;
        }
        const scene::Mesh& mesh = scene.meshes[instance.mesh.value()];
        const auto corner = [&](std::uint32_t i) {
            return turned(scene::V3d(mesh.positions[i]) * instance.world_from_mesh, scene.axes,
                          Axes::z_up);
        };
        for (const auto& triangle : mesh.triangles) {
            function(std::array{corner(triangle[0]), corner(triangle[1]), corner(triangle[2])});
        }
    }
}

}  // namespace balcony::render
