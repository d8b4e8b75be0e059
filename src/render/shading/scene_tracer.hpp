// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A scene prepared for tracing, and its queries for integrators.

#include <memory>

#include "balcony/scene.hpp"
#include "render/embree/accelerator.hpp"
#include "render/shading/appearance.hpp"
#include "render/shading/lights.hpp"
#include "render/shading/surface.hpp"
#include "render/textures/texture_library.hpp"

namespace balcony::render {

/// A scene with the data needed to trace it. Immutable.
struct TracedScene {
    std::shared_ptr<const scene::Scene> scene;
    embree::Accelerator accelerator;
    SurfaceFinder surfaces;
    LightSet lights;
    std::unique_ptr<const TextureLibrary> textures;
    bool textured = false;  ///< Some material has a texture, so footprints matter.
};

/// The first surface on a ray.
struct Interaction {
    Surface surface;
    PositionDifferentials moved;  ///< The ray's footprint; 0 in scenes without textures.
    Appearance appearance;
};

/// Queries a scene; belongs to one thread.
class SceneTracer final : private embree::OpacitySource {
public:
    explicit SceneTracer(const TracedScene& traced)
        : traced_(&traced), cache_(traced.textures->thread_cache()) {}

    [[nodiscard]] const LightSet& lights() const { return traced_->lights; }

    [[nodiscard]] embree::Hit nearest(const Ray& ray) const {
        return traced_->accelerator.intersect({ray.origin, ray.direction});
    }

    /// The surface at a hit of the ray.
    [[nodiscard]] Interaction interaction(const Ray& ray, const embree::Hit& hit) const;

    /// The fraction of the light that reaches a surface from a direction and a distance.
    [[nodiscard]] float transmittance(const Surface& surface, const V3f& to_light,
                                      float distance) const;

private:
    [[nodiscard]] float opacity(const embree::Hit& hit) const override;

    const TracedScene* traced_;
    TextureLibrary::ThreadCache cache_;
};

}  // namespace balcony::render
