// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the reflection at a point of a surface takes from the material alone.

#include <numbers>
#include <optional>

#include <Imath/ImathColor.h>

#include "shading/geometry/frame.hpp"
#include "shading/materials/appearance.hpp"
#include "shading/materials/energy.hpp"
#include "shading/materials/layers.hpp"
#include "shading/materials/microfacets.hpp"

namespace balcony::render {

/// What reflects the light below any cover: the layer, and the diffuse part under it. The whole of
/// a material without further layers.
struct PlainMaterial {
    LayerReflectance<Color3f> specular{};
    LayerReflectance<float> dielectric{};  ///< The brightest channel, without metal.
    Color3f diffuse;
    float per_mean_below = 0.0F;  ///< 1 / (1 - Ē); 0 if no light comes below.
    float roughness;              ///< 0 of a mirror.
    Ggx facets;
    LayerEnergies energies;

    [[nodiscard]] bool is_mirror() const { return roughness == 0.0F; }
};

#include "shading/materials/plain_bsdf.inl"

/// The part of a Bsdf that does not depend on the normals: made once for a material that is the
/// same everywhere. The formulas are in bsdf.hpp.
struct BsdfMaterial : PlainMaterial {
    /// `entering` as in Bsdf: it matters only where light is refracted.
    explicit BsdfMaterial(const Appearance& appearance, bool entering = true);

    Color3f metal;                 ///< The metallic part of the base colour.
    std::optional<Layers> layers;  ///< Beyond the plain ones.

    /// Whether light passes through the surface.
    [[nodiscard]] bool transmits() const { return layers && layers->passage; }
    /// Whether it passes without being scattered.
    [[nodiscard]] bool is_clear() const { return transmits() && is_mirror(); }
    /// Whether all light is scattered widely, so that sampling the lights alone finds it.
    [[nodiscard]] bool is_rough() const;
    /// The reflectance for uniform light from all directions, without the mirror and without
    /// the Fresnel effect: an approximation for ambient light.
    [[nodiscard]] Color3f ambient_reflectance() const;

    /// What the covers do at a direction with this cosine, if there are layers.
    [[nodiscard]] Covered covered(float cosine) const;

private:
    void add_passage(const Appearance& appearance, const Color3f& f0, bool entering);
    void add_covers(const Appearance& appearance);
    [[nodiscard]] float mean_below_covers() const;
};

}  // namespace balcony::render
