// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A scene prepared for tracing, and its queries for integrators.

#include <memory>
#include <optional>
#include <span>

#include "balcony/motion.hpp"
#include "balcony/scene.hpp"
#include "film/sums/tile_image.hpp"
#include "render/embree/accelerator.hpp"
#include "render/tracing/bright_patches.hpp"
#include "shading/lights/light_set.hpp"
#include "shading/materials/bsdf.hpp"
#include "shading/materials/material_set.hpp"
#include "shading/surfaces/surface.hpp"
#include "shading/textures/texture_library.hpp"

namespace balcony::render {

/// A scene with the data needed to trace it. Immutable; copies share most of it.
struct TracedScene {
    std::shared_ptr<const scene::Scene> scene;
    embree::Accelerator accelerator;
    SurfaceFinder surfaces;
    LightSet lights;
    std::shared_ptr<const TextureLibrary> textures;
    MaterialSet materials;
    scene::TimeInterval interval{};                  ///< The times of rays from 0 to 1.
    std::shared_ptr<const BrightPatches> patches{};  ///< Null: no path is sent to any.
};

/// The first surface on a ray.
struct Interaction {
    /// At a hit of the ray.
    Interaction(const TracedScene& traced, const DifferentialRay& ray, const embree::Hit& hit);

    Surface surface;
    PositionDifferentials moved;            ///< The ray's footprint; 0 in scenes without textures.
    const Appearance* constant = nullptr;   ///< If the mesh looks the same everywhere.
    const BsdfMaterial* uniform = nullptr;  ///< Of the constant appearance.
    std::optional<Appearance> varying{};    ///< Otherwise.

    [[nodiscard]] const Appearance& appearance() const {
        return constant != nullptr ? *constant : *varying;
    }
    [[nodiscard]] Bsdf bsdf() const;
    /// What passes against a ray of this direction straight on, as through a pane.
    [[nodiscard]] Color3f straight(const V3f& direction) const;
    /// The radiance that the surface emits against a ray of this direction.
    [[nodiscard]] Color3f emission(const V3f& direction) const {
        return appearance().emission_through_coat(-surface.coat_normal.dot(direction));
    }
};

/// Queries a scene; belongs to one thread.
class SceneTracer {
public:
    explicit SceneTracer(const TracedScene& traced) : traced_(&traced) {}

    [[nodiscard]] const TracedScene& scene() const { return *traced_; }
    [[nodiscard]] const LightSet& lights() const { return traced_->lights; }

    /// In a part of the scene, if one is given.
    [[nodiscard]] embree::Hit nearest(const DifferentialRay& ray,
                                      const embree::Accelerator* only = nullptr) const {
        return (only != nullptr ? *only : traced_->accelerator)
            .intersect({.origin = ray.origin, .direction = ray.direction, .time = ray.time});
    }

    /// What the layers show of a surface.
    [[nodiscard]] VisibleSurface visible(const Interaction& at) const;

    /// Requests the memory that interaction() reads, for a hit of soon, in two steps.
    void request_triangle(const embree::Hit& hit) const {
        if (hit.any()) {
            traced_->surfaces.request_triangle(hit);
        }
    }
    void request_corners(const embree::Hit& hit) const {
        if (hit.any()) {
            traced_->surfaces.request_corners(hit);
        }
    }

    /// The surface at a hit of the ray.
    [[nodiscard]] Interaction interaction(const DifferentialRay& ray,
                                          const embree::Hit& hit) const {
        return {*traced_, ray, hit};
    }

    /// What the material emits at a point of a triangle against a ray of this direction,
    /// unfiltered, by its opacity.
    [[nodiscard]] Color3f emission(const embree::Hit& hit, const V3f& direction, float time) const;

    /// The fraction of the light that reaches a surface from a direction and a distance, through
    /// panes, too.
    [[nodiscard]] Color3f transmittance(const Surface& surface, const V3f& to_light, float distance,
                                        float time) const;

    /// The ray from a surface to a light, in front of it if the direction is above the smooth
    /// surface, and behind otherwise.
    [[nodiscard]] static embree::Ray shadow_ray(const Surface& surface, const V3f& to_light,
                                                float distance, float time);
    /// The fraction of the light that passes along shadow rays, through panes, too: one, or a
    /// packet.
    [[nodiscard]] Color3f transmittance(const embree::Ray& ray) const {
        return traced_->accelerator.transmittance(ray, Panes(*traced_));
    }
    void transmittance(std::span<const embree::Ray> packet, std::span<Color3f> results) const {
        traced_->accelerator.transmittance(packet, Panes(*traced_), results);
    }
    /// The same without panes, which block the light. It has no colour.
    void openness(std::span<const embree::Ray> packet, std::span<Color3f> results) const {
        traced_->accelerator.transmittance(packet, Openings(*traced_), results);
    }

    /// Whether a shadow ray passes nothing but glass.
    [[nodiscard]] bool passes_glass(const embree::Ray& ray) const {
        return !is_black(traced_->accelerator.transmittance(ray, Glass(*traced_)));
    }
    /// The density with which LightSet::sample() finds, from a point, the light that is straight
    /// behind the glass on a ray.
    [[nodiscard]] float pdf_behind_glass(const LitPoint& from, const embree::Ray& ray) const;

private:
    // What passes a surface because of its opacity,
    struct Openings : embree::TransmittanceSource {
        explicit Openings(const TracedScene& of) : traced(&of) {}
        [[nodiscard]] Color3f transmittance(const embree::Hit& hit,
                                            const embree::Ray& ray) const override;
        const TracedScene* traced;
    };
    // and also as through a pane.
    struct Panes final : Openings {
        using Openings::Openings;
        [[nodiscard]] Color3f transmittance(const embree::Hit& hit,
                                            const embree::Ray& ray) const override;
    };

    // All that is glass.
    struct Glass final : Openings {
        using Openings::Openings;
        [[nodiscard]] Color3f transmittance(const embree::Hit& hit,
                                            const embree::Ray& ray) const override;
    };

    const TracedScene* traced_;
};

}  // namespace balcony::render
