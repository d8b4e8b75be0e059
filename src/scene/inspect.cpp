// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/scene.hpp"

namespace balcony::scene {

std::size_t Scene::triangle_count() const {
    std::size_t count = 0;
    for (const Instance& instance : instances) {
        count += meshes[instance.mesh.value()].triangles.size();
    }
    return count;
}

Box3f Scene::bounds() const {
    Box3f box;
    for (const Instance& instance : instances) {
        for (const V3f& position : meshes[instance.mesh.value()].positions) {
            box.extendBy(V3f(V3d(position) * instance.world_from_mesh));
        }
    }
    return box;
}

}  // namespace balcony::scene
