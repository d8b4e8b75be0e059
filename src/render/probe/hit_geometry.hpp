// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "balcony/scene.hpp"
#include "render/embree/accelerator.hpp"

namespace balcony::render {

/// What a hit tells about the geometry of a scene.
class HitGeometry {
public:
    explicit HitGeometry(const scene::Scene& scene) : scene_(&scene) {}

    [[nodiscard]] const scene::Instance& instance(const embree::Hit& hit) const {
        return scene_->instances[hit.instance];
    }
    [[nodiscard]] std::uint32_t object(const embree::Hit& hit) const {
        return instance(hit).object;
    }
    [[nodiscard]] const scene::Material& material(const embree::Hit& hit) const {
        return scene_->materials[mesh(hit).material.value()];
    }
    [[nodiscard]] std::array<scene::V3d, 3> corners(const embree::Hit& hit) const {
        std::array<scene::V3d, 3> corners;
        const auto& triangle = mesh(hit).triangles[hit.triangle];
        for (std::size_t i = 0; i < corners.size(); ++i) {
            corners[i] =
                scene::V3d(mesh(hit).positions[triangle[i]]) * instance(hit).world_from_mesh;
        }
        return corners;
    }
    [[nodiscard]] scene::V3f place(const embree::Hit& hit) const {
        const std::array<scene::V3d, 3> p = corners(hit);
        return scene::V3f(p[0] + double{hit.u} * (p[1] - p[0]) + double{hit.v} * (p[2] - p[0]));
    }
    /// Whether a ray meets the back of the triangle.
    [[nodiscard]] bool from_behind(const embree::Hit& hit, const scene::V3f& direction) const {
        const std::array<scene::V3d, 3> p = corners(hit);
        const double facing = (p[1] - p[0]).cross(p[2] - p[0]).dot(scene::V3d(direction));
        return instance(hit).world_from_mesh.determinant() < 0.0 ? facing < 0.0 : facing > 0.0;
    }

private:
    [[nodiscard]] const scene::Mesh& mesh(const embree::Hit& hit) const {
        return scene_->meshes[instance(hit).mesh.value()];
    }

    const scene::Scene* scene_;
};

}  // namespace balcony::render
