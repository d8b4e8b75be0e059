// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/materials/material_set.hpp"

#include <algorithm>
#include <array>

#include "shading/materials/transport.hpp"

namespace balcony::render {

namespace {

using Imath::Color4f;
using scene::Material;
using scene::TextureUse;

float opacity_of(const Material& material, float alpha) {
    const float opacity = std::clamp(material.alpha * alpha, 0.0F, 1.0F);
    switch (material.alpha_mode) {
        case scene::AlphaMode::opaque: return 1.0F;
        case scene::AlphaMode::mask: return opacity >= material.alpha_cutoff ? 1.0F : 0.0F;
        case scene::AlphaMode::blend: return opacity;
    }
    return 1.0F;
}

Appearance constant_part(const Material& material) {
    Appearance found;
    found.base_color = material.base_color;
    found.emission = material.emission;
    found.opacity = opacity_of(material, 1.0F);
    found.metallic = material.metallic;
    found.roughness = material.roughness;
    found.ior = material.ior;
    found.specular = material.specular;
    found.specular_color = material.specular_color;
    found.transmission = material.transmission;
    found.thin_walled = material.thin_walled;
    found.absorption = material.absorption;
    found.clearcoat = material.clearcoat;
    found.clearcoat_roughness = material.clearcoat_roughness;
    found.sheen_color = material.sheen_color;
    found.sheen_roughness = material.sheen_roughness;
    found.unlit = material.unlit;
    return found;
}

// Looks up the textures of a material at a point. Uses that share texels come one after the other,
// so that the image is looked up once.
class Texels {
public:
    Texels(const TextureLibrary& textures, const MeshPoint& point,
           const TriangleFootprint& footprint)
        : textures_(textures), point_(point), footprint_(footprint) {}

    [[nodiscard]] Color3f color(const TextureUse& use) {
        const Color4f& texel = look_up(use);
        return {texel.r, texel.g, texel.b};
    }

    [[nodiscard]] float number(const TextureUse& use) {
        const Color4f& texel = look_up(use);
        return std::array{texel.r, texel.g, texel.b, texel.a}[use.channel];
    }

    void multiply(const TextureUse& use, Color3f& factor) {
        if (use.valid()) {
            factor *= color(use);
        }
    }

    void multiply(const TextureUse& use, float& factor) {
        if (use.valid()) {
            factor = std::clamp(factor * number(use), 0.0F, 1.0F);
        }
    }

private:
    const Color4f& look_up(const TextureUse& use) {
        if (last_ == nullptr || !last_->shares_texels(use)) {
            texel_ = textures_.look_up(use.index, use.encoding,
                                       point_.texture_footprint(use, footprint_));
            last_ = &use;
        }
        return texel_;
    }

    const TextureLibrary& textures_;
    const MeshPoint& point_;
    const TriangleFootprint& footprint_;
    const TextureUse* last_ = nullptr;
    Color4f texel_{1.0F, 1.0F, 1.0F, 1.0F};
};

void look_up_textures(const Material& material, Texels& texels, Appearance& found, float& alpha) {
    texels.multiply(material.base_color_texture, found.base_color);
    texels.multiply(material.opacity_texture, alpha);
    texels.multiply(material.roughness_texture, found.roughness);
    texels.multiply(material.metallic_texture, found.metallic);
    texels.multiply(material.emission_texture, found.emission);
    texels.multiply(material.specular_texture, found.specular);
    texels.multiply(material.specular_color_texture, found.specular_color);
    texels.multiply(material.transmission_texture, found.transmission);
    texels.multiply(material.clearcoat_texture, found.clearcoat);
    texels.multiply(material.clearcoat_roughness_texture, found.clearcoat_roughness);
    texels.multiply(material.sheen_color_texture, found.sheen_color);
    texels.multiply(material.sheen_roughness_texture, found.sheen_roughness);
}

// glTF 2.0, section 3.9.3: texels from 0 to 1 stand for components from -1 to 1.
V3f in_tangent_space(const Color3f& texel, float scale) {
    const V3f normal = 2.0F * texel - V3f(1.0F);
    return {scale * normal.x, scale * normal.y, normal.z};
}

void bend_normals(const Material& material, Texels& texels, const V3f& to_viewer,
                  Surface& surface) {
    const auto bend = [&](const TextureUse& use, float scale, V3f& normal) {
        if (use.valid()) {
            normal =
                surface.mapped_normal(in_tangent_space(texels.color(use), scale), use, to_viewer);
        }
    };
    bend(material.normal_texture, material.normal_scale, surface.normal);
    bend(material.clearcoat_normal_texture, material.clearcoat_normal_scale, surface.coat_normal);
}

bool uses_textures(const Material& material) {
    return std::any_of(scene::texture_uses.begin(), scene::texture_uses.end(),
                       [&](const auto use) { return (material.*use).valid(); });
}

}  // namespace

bool may_be_pane(const Material& material) {
    return material.transmission > 0.0F && material.thin_walled && !material.unlit &&
           (material.roughness_texture.valid() ||
            material.roughness * material.roughness < min_alpha);
}

bool is_glass(const Material& material) {
    return material.transmission > 0.0F && !material.unlit &&
           material.alpha_mode == scene::AlphaMode::opaque && is_black(material.emission);
}

bool bends_light(const Material& material) {
    return is_glass(material) && (!may_be_pane(material) || material.roughness_texture.valid());
}

MaterialSet::MaterialSet(const scene::Scene& scene, const TextureLibrary& textures)
    : scene_(&scene), textures_(&textures) {
    prepared_.reserve(scene.materials.size());
    for (const Material& material : scene.materials) {
        const Appearance constant = constant_part(material);
        const bool textured = uses_textures(material);
        prepared_.push_back({constant, textured});
        if (!textured) {
            auto& sides = prepared_.back().bsdf;
            sides = {BsdfMaterial(constant, false), BsdfMaterial(constant, true)};
            for (BsdfMaterial& side : *sides) {
                rows_.push_back(side.energies.keep_row());
            }
        }
        has_textures_ = has_textures_ || prepared_.back().has_textures;
    }
}

std::optional<MaterialSet::Plain> MaterialSet::plain(const scene::Mesh& mesh) const {
    const Material& material = scene_->materials[mesh.material.value()];
    if (material.alpha_mode != scene::AlphaMode::opaque || !mesh.colors.empty() || material.unlit ||
        material.emission_texture.valid() || material.normal_texture.valid() ||
        (material.clearcoat > 0.0F && !is_black(material.emission))) {
        return std::nullopt;
    }
    return Plain{&prepared_[mesh.material.value()].constant,
                 material.base_color_texture.valid() ? &material.base_color_texture : nullptr};
}

Appearance MaterialSet::look_up(Surface& surface, const PositionDifferentials& moved,
                                const V3f& to_viewer) const {
    const MeshPoint& point = surface.in_mesh;
    const Prepared& prepared = prepared_[point.mesh->material.value()];
    Appearance found = prepared.constant;
    const Material& material = *surface.material;
    const Color4f tint = point.color();
    found.base_color *= Color3f(tint.r, tint.g, tint.b);
    float alpha = tint.a;
    if (prepared.has_textures) {
        const TriangleFootprint footprint = surface.triangle_footprint(moved);
        Texels texels(*textures_, point, footprint);
        look_up_textures(material, texels, found, alpha);
        bend_normals(material, texels, to_viewer, surface);
    }
    found.opacity = opacity_of(material, alpha);
    return found;
}

Color3f MaterialSet::emission(const MeshPoint& point) const {
    const Material& material = scene_->materials[point.mesh->material.value()];
    Color3f found = material.emission;
    const TriangleFootprint footprint;
    Texels(*textures_, point, footprint).multiply(material.emission_texture, found);
    return found;
}

float MaterialSet::opacity(const MeshPoint& point) const {
    const Material& material = scene_->materials[point.mesh->material.value()];
    if (material.alpha_mode == scene::AlphaMode::opaque) {
        return 1.0F;
    }
    float alpha = point.color().a;
    const TriangleFootprint footprint;
    Texels(*textures_, point, footprint).multiply(material.opacity_texture, alpha);
    return opacity_of(material, alpha);
}

}  // namespace balcony::render
