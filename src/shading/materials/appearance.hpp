// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// glTF 2.0's metallic-roughness material with its extensions at a point.

#include <algorithm>
#include <optional>

#include <Imath/ImathColor.h>

namespace balcony::render {

using Imath::Color3f;

[[nodiscard]] inline float largest(const Color3f& color) {
    return std::max({color.x, color.y, color.z});
}

/// No channel is above 0.
[[nodiscard]] inline bool is_black(const Color3f& color) { return !(largest(color) > 0.0F); }

/// A material with its textures evaluated. Each default means that the material has no such part.
struct Appearance {
    Color3f base_color;
    Color3f emission;
    float opacity = 1.0F;
    float metallic = 0.0F;
    float roughness = 1.0F;
    float ior = 1.5F;              ///< Index of refraction of the dielectric.
    float specular = 1.0F;         ///< The strength of its reflection.
    Color3f specular_color{1.0F};  ///< A factor of its reflectance at normal incidence.
    float transmission = 0.0F;     ///< The part of the light below it that passes through.
    bool thin_walled = true;       ///< Light passes without refraction.
    Color3f absorption{0.0F};      ///< Inside, per scene unit.
    float clearcoat = 0.0F;        ///< The strength of the coat on top.
    float clearcoat_roughness = 0.0F;
    Color3f sheen_color{0.0F};  ///< The reflectance of the fibres on top.
    float sheen_roughness = 0.0F;
    bool unlit = false;  ///< The base colour is shown as it is, without light.

    /// The same with mirrors and sharp highlights so rough. Nothing if there are none. Panes stay
    /// as they are: light passes them straight on, and mirrored lamps are too weak to be worth the
    /// noise of blurred ones.
    [[nodiscard]] std::optional<Appearance> softened(float least_roughness) const;

    /// The emission that leaves the clearcoat, by the cosine between its normal and the viewer.
    [[nodiscard]] Color3f emission_through_coat(float cosine) const;
};

}  // namespace balcony::render
