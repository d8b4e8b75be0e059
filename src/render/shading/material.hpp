// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// glTF 2.0's metallic-roughness material at a point, and how it reflects.

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "balcony/scene.hpp"
#include "render/textures/texture_library.hpp"

namespace balcony::render {

using Imath::Color3f;
using Imath::V3f;

/// Below this roughness a surface mirrors.
inline constexpr float smooth_roughness = 0.1F;

/// A material with its textures looked up.
struct Appearance {
    Color3f base_color;
    Color3f emission;
    float opacity = 1.0F;
    float metallic = 0.0F;
    float roughness = 1.0F;

    [[nodiscard]] bool smooth() const { return roughness < smooth_roughness; }
    [[nodiscard]] Color3f diffuse() const { return (1.0F - metallic) * base_color; }
    /// Reflectance at normal incidence: 4 % of an index of refraction of 1.5, or the metal's
    /// colour.
    [[nodiscard]] Color3f normal_reflectance() const;
};

[[nodiscard]] bool has_textures(const scene::Material& material);

[[nodiscard]] Appearance look_up(const scene::Material& material, const TextureLibrary& textures,
                                 const TextureFootprint& footprint,
                                 TextureLibrary::ThreadCache cache);

/// The opacity alone: after the mask, with the mode taken into account.
[[nodiscard]] float look_up_opacity(const scene::Material& material, const TextureLibrary& textures,
                                    const TextureFootprint& footprint,
                                    TextureLibrary::ThreadCache cache);

/// Schlick's approximation of Fresnel's reflectance.
[[nodiscard]] Color3f fresnel(const Color3f& normal_reflectance, float cosine);

/// The radiance towards the viewer for an irradiance of 1 on a plane across the light's direction:
/// Lambert and GGX (Walter et al. 2007) with Smith's height-correlated masking, times the cosine.
/// All directions are unit and point away from the surface. A smooth surface has no highlight; it
/// mirrors.
[[nodiscard]] Color3f reflected(const Appearance& appearance, const V3f& normal,
                                const V3f& to_viewer, const V3f& to_light);

}  // namespace balcony::render
