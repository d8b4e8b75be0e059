// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The lights of the scene with sharp shadows, ambient light without shadows, mirrors and glass.

#include <algorithm>

#include "render/integrators/ray_tree.hpp"
#include "shading/materials/bsdf.hpp"
#include "shading/materials/footprint.hpp"

namespace balcony::render {

namespace {

// Surfaces with a roughness below this are perfect mirrors: without other samples, rays cannot show
// what a glossy surface reflects.
constexpr float mirror_roughness = 0.1F;

// The minimum weight of a traced reflection: less than half a step of an 8-bit picture.
constexpr float min_weight = 1.0F / 512.0F;

bool is_mirror(const Appearance& appearance) { return appearance.roughness < mirror_roughness; }

Bsdf bsdf_at(const Interaction& at, const V3f& side_normal) {
    if (at.uniform != nullptr && !at.uniform->transmits() && !is_mirror(at.appearance())) {
        return {*at.uniform, at.surface.normal, side_normal};
    }
    Appearance appearance = at.appearance();
    if (is_mirror(appearance)) {
        appearance.roughness = 0.0F;
    }
    Bsdf made(appearance, at.surface.normal, side_normal, at.surface.entering);
    made.set_coat_normal(at.surface.coat_normal);
    return made;
}

// For what passes, frosted glass is clear.
Bsdf clear_at(const Interaction& at) {
    Appearance appearance = at.appearance();
    appearance.roughness = 0.0F;
    Bsdf made(appearance, at.surface.normal, at.surface.geometric_normal, at.surface.entering);
    made.set_coat_normal(at.surface.coat_normal);
    return made;
}

class Direct final : public RayTree {
public:
    Direct(const TracedScene& traced, const Settings& settings)
        : RayTree(traced), settings_(settings.direct), ambient_(*settings.ambient) {}

private:
    [[nodiscard]] Shaded shade(const DifferentialRay& ray, const Interaction& at) const override {
        if (at.appearance().unlit) {
            return {at.appearance().base_color, Color3f(0.0F), Color3f(0.0F)};
        }
        // A facet of a coarse mesh that faces away from a light is lit if the smooth surface is:
        // the shadow ray decides.
        const Bsdf bsdf = bsdf_at(at, at.surface.normal);
        return {at.emission(ray.direction), ambient_ * bsdf.material().ambient_reflectance(),
                reflected_light(ray, at.surface, bsdf)};
    }

    [[nodiscard]] Color3f reflected_light(const DifferentialRay& ray, const Surface& surface,
                                          const Bsdf& bsdf) const {
        const V3f to_viewer = -ray.direction;
        const LightSet& lights = tracer().lights();
        const LitPoint point{surface.position, to_viewer, V3f(0.0F), ray.time};
        const Bsdf::View view = bsdf.view_from(to_viewer);
        Color3f total(0.0F);
        for (std::size_t light = 0; light < lights.size(); ++light) {
            const Illumination arriving = lights.arriving(light, point);
            if (largest(arriving.irradiance) <= 0.0F) {
                continue;
            }
            const Color3f unshadowed =
                arriving.irradiance * bsdf.evaluate(view, arriving.to_light).reflected;
            if (largest(unshadowed) > 0.0F) {
                total += unshadowed * tracer().transmittance(surface, arriving.to_light,
                                                             arriving.distance, ray.time);
            }
        }
        return total;
    }

    [[nodiscard]] Branches scatter(const Branch& arriving, const Color3f& weight,
                                   const Interaction& at) const override {
        const Appearance& appearance = at.appearance();
        if (appearance.unlit || arriving.reflections >= settings_.mirror_depth) {
            return {};
        }
        Branches next;
        if (is_mirror(appearance)) {
            next[0] = branch(
                arriving, weight, at,
                bsdf_at(at, at.surface.geometric_normal).sample_mirror(-arriving.ray.direction));
        }
        if (appearance.transmission > 0.0F) {
            next[1] =
                branch(arriving, weight, at, clear_at(at).sample_passage(-arriving.ray.direction));
        }
        return next;
    }

    [[nodiscard]] static std::optional<Branch> branch(const Branch& arriving, const Color3f& weight,
                                                      const Interaction& at,
                                                      const std::optional<BsdfSample>& sample) {
        const Color3f scattered = sample ? weight * sample->weight : Color3f(0.0F);
        if (largest(scattered) < min_weight) {
            return std::nullopt;
        }
        Branch next = arriving;
        next.weight = scattered;
        ++next.reflections;
        next.ray.direction = sample->to_light;
        next.ray.origin = at.surface.start(next.ray.direction);
        next.ray.differentials = after_sample(arriving.ray, at.moved, *sample, 1.0F);
        return next;
    }

    DirectSettings settings_;
    Color3f ambient_;
};

}  // namespace

// A texture only reduces the roughness.
bool has_mirrors(const scene::Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), [](const auto& material) {
        return !material.unlit &&
               (material.roughness < mirror_roughness || material.roughness_texture.valid() ||
                material.transmission > 0.0F);
    });
}

std::unique_ptr<Integrator> make_direct(const TracedScene& traced, const Settings& settings) {
    return std::make_unique<Direct>(traced, settings);
}

}  // namespace balcony::render
