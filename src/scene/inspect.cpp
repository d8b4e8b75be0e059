// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/scene.hpp"

#include <array>
#include <span>
#include <vector>

#include "scene/placement.hpp"

namespace balcony::scene {

std::size_t Scene::triangle_count() const {
    std::size_t count = 0;
    for (const Instance& instance : instances) {
        count += meshes[instance.mesh.value()]->triangles.size();
    }
    return count;
}

namespace {

// The corners of a box, as vertices.
std::array<V3f, 8> corners_of(const Box3f& box) {
    std::array<V3f, 8> corners;
    for (unsigned i = 0; i < corners.size(); ++i) {
        const auto side = [&](unsigned axis) {
            return ((i >> axis & 1U) != 0 ? box.max : box.min)[static_cast<int>(axis)];
        };
        corners[i] = V3f(side(0), side(1), side(2));
    }
    return corners;
}

}  // namespace

Box3f Scene::bounds() const {
    std::size_t vertices = 0;
    for (const Instance& instance : instances) {
        vertices += meshes[instance.mesh.value()]->positions.size();
    }
    // About one second of work.
    constexpr std::size_t max_vertices = std::size_t{1} << 28U;
    std::vector<std::array<V3f, 8>> corners;
    if (vertices > max_vertices) {
        for (const Mesh& mesh : meshes) {
            corners.push_back(corners_of(box_of(mesh.positions)));
        }
    }
    Box3f box;
    for (const Instance& instance : instances) {
        const std::size_t mesh = instance.mesh.value();
        box.extendBy(corners.empty() ? box_of(meshes[mesh]->positions, instance.world_from_mesh)
                                     : box_of(corners[mesh], instance.world_from_mesh));
    }
    return box;
}

}  // namespace balcony::scene
