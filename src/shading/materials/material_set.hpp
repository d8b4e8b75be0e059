// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The appearance of surfaces by their materials.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/scene.hpp"
#include "shading/materials/appearance.hpp"
#include "shading/materials/bsdf_material.hpp"
#include "shading/surfaces/surface.hpp"
#include "shading/textures/texture_library.hpp"

namespace balcony::render {

/// Whether light goes straight on through some point of a surface of this material as through a
/// pane: a thin wall that is as smooth as a mirror there.
[[nodiscard]] bool may_be_pane(const scene::Material& material);

/// Whether light passes through surfaces of this material in any way, and nothing else comes from
/// them.
[[nodiscard]] bool is_glass(const scene::Material& material);
/// Whether such a surface is more than a pane: light is refracted or spread on its way through it.
[[nodiscard]] bool bends_light(const scene::Material& material);

/// The materials of a scene, prepared for look-ups.
class MaterialSet {
public:
    /// The scene and the textures must outlive it.
    MaterialSet(const scene::Scene& scene, const TextureLibrary& textures);

    /// Some material has a texture, so footprints matter.
    [[nodiscard]] bool has_textures() const { return has_textures_; }

    /// The appearance of a mesh if it is the same everywhere; otherwise null.
    [[nodiscard]] const Appearance* constant(const scene::Mesh& mesh) const {
        const Prepared& prepared = prepared_[mesh.material.value()];
        return !prepared.has_textures && mesh.colors.empty() ? &prepared.constant : nullptr;
    }

    /// The appearance at a surface, whose normals it bends by the normal maps. `moved` is the
    /// footprint of the ray, whose direction is that to the viewer reversed.
    [[nodiscard]] Appearance look_up(Surface& surface, const PositionDifferentials& moved,
                                     const V3f& to_viewer) const;

    /// A material of which one texture at most changes what is seen without lights.
    struct Plain {
        const Appearance* constant = nullptr;        ///< Without the texture.
        const scene::TextureUse* texture = nullptr;  ///< Of the base colour; null if there is none.
    };
    /// The material of a mesh if it is opaque, and its emission and normals are the same as without
    /// textures and from all directions.
    [[nodiscard]] std::optional<Plain> plain(const scene::Mesh& mesh) const;

    /// The reflection of a mesh if it is the same everywhere, seen from outside or inside;
    /// otherwise null.
    [[nodiscard]] const BsdfMaterial* uniform_bsdf(const scene::Mesh& mesh, bool entering) const {
        const Prepared& prepared = prepared_[mesh.material.value()];
        return prepared.bsdf && mesh.colors.empty() ? &(*prepared.bsdf)[entering ? 1 : 0] : nullptr;
    }

    /// The emission only, as below any clearcoat.
    [[nodiscard]] Color3f emission(const MeshPoint& point) const;
    /// The opacity only, after the alpha mask and according to the mode.
    [[nodiscard]] float opacity(const MeshPoint& point) const;

private:
    struct Prepared {
        Appearance constant;  // Without textures and colours of vertices.
        bool has_textures = false;
        // Seen from inside and from outside; nothing with textures.
        std::optional<std::array<BsdfMaterial, 2>> bsdf{};
    };

    const scene::Scene* scene_;
    const TextureLibrary* textures_;
    std::vector<Prepared> prepared_;                 // By material.
    std::vector<std::shared_ptr<const void>> rows_;  // Which the energies of the materials read.
    bool has_textures_ = false;
};

}  // namespace balcony::render
