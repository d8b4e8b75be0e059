// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// glTF 2.0's metallic-roughness material with its extensions at a point.

#include <algorithm>
#include <optional>
#include <vector>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "balcony/scene.hpp"
#include "render/shading/surface.hpp"
#include "render/textures/texture_library.hpp"

namespace balcony::render {

using Imath::Color3f;
using Imath::V3f;

[[nodiscard]] inline float largest(const Color3f& color) {
    return std::max({color.x, color.y, color.z});
}

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
};

/// The materials of a scene, prepared for look-ups.
class MaterialSet {
public:
    MaterialSet(const scene::Scene& scene, const TextureLibrary& textures);

    /// Some material has a texture, so footprints matter.
    [[nodiscard]] bool has_textures() const { return has_textures_; }

    /// The appearance at a surface, whose normal it bends by the normal map. `moved` is the
    /// footprint of the ray, whose direction is that to the viewer reversed.
    [[nodiscard]] Appearance look_up(Surface& surface, const PositionDifferentials& moved,
                                     const V3f& to_viewer) const;

    /// A material of which one texture at most changes what is seen without lights.
    struct Plain {
        const Appearance* constant = nullptr;        ///< Without the texture.
        const scene::TextureUse* texture = nullptr;  ///< Of the base colour; null if there is none.
    };
    /// The material of a mesh if it is opaque, and its emission and normals are the same as without
    /// textures.
    [[nodiscard]] std::optional<Plain> plain(const scene::Mesh& mesh) const;

    /// The emission only.
    [[nodiscard]] Color3f emission(const MeshPoint& point) const;
    /// The opacity only, after the alpha mask and according to the mode.
    [[nodiscard]] float opacity(const MeshPoint& point) const;

private:
    struct Prepared {
        Appearance constant;  // Without textures and colours of vertices.
        bool has_textures = false;
    };

    const scene::Scene* scene_;
    const TextureLibrary* textures_;
    std::vector<Prepared> prepared_;  // By material.
    bool has_textures_ = false;
};

}  // namespace balcony::render
