// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The base colour, lit from the ray's origin.

#include <cmath>

#include "render/integrators/ray_tree.hpp"

namespace balcony::render {

namespace {

class Preview final : public RayTree, private LightTracer {
public:
    using RayTree::RayTree;
    [[nodiscard]] LightTracer* light_tracer() override { return this; }

private:
    void trace_light(const Rays& all, std::span<Color4f> radiance) override {
        for (std::size_t i = 0; i < radiance.size(); ++i) {
            radiance[i] = all.valid[i] != 0 ? light(all, i) : Color4f(0.0F);
        }
    }

    [[nodiscard]] Color4f light(const Rays& all, std::size_t i) {
        const embree::Ray& from_camera = all.rays[i];
        const embree::Hit& hit = all.hits[i];
        if (!hit.any()) {
            return Color4f(0.0F);
        }
        // Most surfaces are opaque and have the same appearance everywhere.
        if (const Appearance* everywhere = tracer().uniform_appearance(hit)) {
            const V3f normal = tracer().normal(hit, from_camera.direction, from_camera.time);
            return opaque(radiance(*everywhere, normal, from_camera.direction));
        }
        const Ray ray{from_camera.origin, from_camera.direction, all.footprints.differentials(i),
                      from_camera.time};
        const Interaction at = tracer().interaction(ray, hit);
        return at.appearance.opacity >= 1.0F
                   ? opaque(radiance(at.appearance, at.surface.normal, ray.direction))
                   : trace(ray, hit).radiance;
    }

    static Color3f radiance(const Appearance& appearance, const V3f& normal, const V3f& direction) {
        return appearance.emission + std::abs(normal.dot(direction)) * appearance.base_color;
    }
    static Color4f opaque(const Color3f& color) { return {color.x, color.y, color.z, 1.0F}; }

    [[nodiscard]] Shaded shade(const Ray& ray, const Interaction& at) const override {
        const float cosine = std::abs(at.surface.normal.dot(ray.direction));
        return {at.appearance.emission, Color3f(0.0F), cosine * at.appearance.base_color};
    }
};

}  // namespace

std::unique_ptr<Integrator> make_preview(const TracedScene& traced, const Settings& settings) {
    return std::make_unique<Preview>(traced, settings);
}

}  // namespace balcony::render
