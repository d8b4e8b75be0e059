// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The two integrators: the radiance that comes along a ray.

#include <cstdint>
#include <memory>
#include <vector>

#include "balcony/render.hpp"
#include "render/embree/accelerator.hpp"
#include "render/shading/material.hpp"
#include "render/shading/surface.hpp"
#include "render/textures/texture_library.hpp"

namespace balcony::render {

/// A scene with all that tracing it needs.
struct TracedScene {
    std::shared_ptr<const scene::Scene> scene;
    embree::Accelerator accelerator;
    SurfaceFinder surfaces;
    std::unique_ptr<const TextureLibrary> textures;
    bool textured = false;  ///< Some material has a texture, so footprints matter.
};

/// The first surface on a ray that is there at all.
struct VisibleSurface {
    bool any = false;
    V3f position;
    V3f normal;
    Color3f albedo;
    std::uint32_t object = 0;
};

/// Traces rays; belongs to one thread.
class Tracer final : private embree::OpacitySource {
public:
    Tracer(const TracedScene& traced, const Settings& settings);

    struct Result {
        Color4f radiance;  ///< Premultiplied.
        VisibleSurface visible;
    };
    /// What a camera ray sees, given where it hits first.
    [[nodiscard]] Result trace(const Ray& ray, const embree::Hit& first);

private:
    // A ray yet to be followed, and how much of what it finds reaches the camera.
    struct Pending {
        Ray ray;
        Color3f weight;
        std::size_t reflections = 0;
        std::size_t crossings = 0;
    };

    void follow(const Pending& pending, const embree::Hit& hit, Result& result);
    void follow_through(const Pending& pending, const Surface& surface,
                        const PositionDifferentials& moved, float opacity);
    void follow_reflection(const Pending& pending, const Surface& surface,
                           const PositionDifferentials& moved, const Appearance& appearance);
    [[nodiscard]] Color3f shade(const Ray& ray, const Surface& surface,
                                const Appearance& appearance) const;
    [[nodiscard]] Color3f light(const Ray& ray, const Surface& surface,
                                const Appearance& appearance) const;
    [[nodiscard]] float opacity(const embree::Hit& hit) const override;

    const TracedScene* traced_;
    const Settings* settings_;
    TextureLibrary::ThreadCache cache_;
    std::vector<Pending> pending_;
};

}  // namespace balcony::render
