// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a material may have beyond glTF's plain one: covers, and light that passes through.

#include <optional>

#include <Imath/ImathColor.h>

#include "shading/materials/appearance.hpp"
#include "shading/materials/cover.hpp"
#include "shading/materials/energy.hpp"
#include "shading/materials/glass.hpp"
#include "shading/materials/microfacets.hpp"
#include "shading/materials/sheen.hpp"

namespace balcony::render {

/// KHR_materials_clearcoat: a GGX layer of an index of refraction of 1.5. Never a perfect mirror.
struct Coat {
    Coat(const Appearance& appearance, float alpha_below);

    float weight;
    float roughness;
    Ggx facets;
    LayerEnergies energies;
    Cover cover;
};

/// KHR_materials_sheen, under the coat.
struct Fibres {
    Fibres(const Appearance& appearance, float alpha_below);

    Color3f color;
    float weight;  ///< Of the color's brightest channel.
    Sheen sheen;
    Cover cover;
};

/// KHR_materials_transmission.
struct Passage {
    /// `f0` and `f90` are those of the layer.
    Passage(const Appearance& appearance, float alpha, const Color3f& f0, float f90, bool entering);

    /// Fresnel's reflectance, where the light is refracted.
    [[nodiscard]] Color3f reflectance(float cosine) const;
    /// What of the light passes a facet that reflects this.
    [[nodiscard]] Color3f transmittance(const Color3f& reflected) const;

    /// With which a facet reflects a sample instead of refracting it.
    [[nodiscard]] float reflection_probability(const Color3f& reflected) const;
    [[nodiscard]] GlassSide viewer_side() const { return outside ? glass_outside : glass_inside; }
    [[nodiscard]] GlassSide other_side() const { return outside ? glass_inside : glass_outside; }

    float share;  ///< Of the light.
    Color3f tint;
    Color3f f0;
    float f90;
    bool refracts;  ///< Into a solid; otherwise through a thin wall.
    bool outside;   ///< The viewer is.
    float ior;
    float eta;   ///< Of the light's side over that of the viewer's side.
    float lost;  ///< A factor of GlassEnergies::lost(): facets that reflect less lose less.
    GlassEnergies energies;  ///< Where the light is refracted.
};

/// What the covers do at a direction.
struct Covered {
    LayerEnergy layer{};  ///< That below them.
    LayerEnergy coat_energy{};
    Sheen::Energy sheen{};
    float coat = 0.0F;          ///< What it reflects of even light.
    float fibres = 0.0F;        ///< What they reflect of it in their brightest channel.
    float passed = 1.0F;        ///< The rest.
    float coat_scale = 1.0F;    ///< Of the layer below, by the coat,
    float fibres_scale = 1.0F;  ///< and by the fibres.
};

/// The coat at a direction, by its own normal.
struct CoatAt {
    float cosine = 0.0F;     ///< Between that normal and the direction.
    float scale = 1.0F;      ///< c of its facets.
    float reflected = 0.0F;  ///< Of even light.
    float shade = 1.0F;      ///< What the coat's tilt multiplies all layers below by.
};

/// The clearcoat's reflectance of a facet, for c(viewer) c(light).
[[nodiscard]] float coat_reflectance(float edge, float scale);

struct Layers {
    std::optional<Coat> coat;
    std::optional<Fibres> fibres;
    std::optional<Passage> passage;

    /// Light that has passed into a solid is below the covers.
    [[nodiscard]] bool is_below_covers() const {
        return passage && passage->refracts && !passage->outside;
    }
    [[nodiscard]] Covered at(const LayerEnergy& layer, float cosine) const;
    /// The coat with a normal of its own, where `flat` is as if it had that of the layers below.
    [[nodiscard]] CoatAt tilted_coat(const Covered& flat, float cosine) const;
    /// What the covers multiply the layer below with.
    [[nodiscard]] float cover_factor(const Covered& viewer, const Covered& light) const;
};

}  // namespace balcony::render
