// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/shading/appearance.hpp"

#include <algorithm>

namespace balcony::render {

namespace {

float opacity_of(const scene::Material& material, float texture_alpha) {
    const float alpha = std::clamp(material.alpha * texture_alpha, 0.0F, 1.0F);
    switch (material.alpha_mode) {
        case scene::AlphaMode::opaque: return 1.0F;
        case scene::AlphaMode::mask: return alpha >= material.alpha_cutoff ? 1.0F : 0.0F;
        case scene::AlphaMode::blend: return alpha;
    }
    return 1.0F;
}

}  // namespace

bool has_textures(const scene::Material& material) {
    return material.base_color_texture.valid() || material.emission_texture.valid() ||
           material.metallic_roughness_texture.valid();
}

Appearance look_up(const scene::Material& material, const TextureLibrary& textures,
                   const TextureFootprint& footprint, TextureLibrary::ThreadCache cache) {
    const auto texel = [&](scene::TextureIndex texture, TextureEncoding encoding) {
        return textures.look_up(texture, encoding, footprint, cache);
    };
    const Imath::Color4f base = texel(material.base_color_texture, TextureEncoding::srgb);
    const Imath::Color4f emission = texel(material.emission_texture, TextureEncoding::srgb);
    const Imath::Color4f surface =
        texel(material.metallic_roughness_texture, TextureEncoding::linear);
    Appearance found;
    found.base_color = material.base_color * Color3f(base.r, base.g, base.b);
    found.emission = material.emission * Color3f(emission.r, emission.g, emission.b);
    found.opacity = opacity_of(material, base.a);
    found.metallic = std::clamp(material.metallic * surface.b, 0.0F, 1.0F);
    found.roughness = std::clamp(material.roughness * surface.g, 0.0F, 1.0F);
    return found;
}

float look_up_opacity(const scene::Material& material, const TextureLibrary& textures,
                      const TextureFootprint& footprint, TextureLibrary::ThreadCache cache) {
    return opacity_of(
        material,
        textures.look_up(material.base_color_texture, TextureEncoding::srgb, footprint, cache).a);
}

}  // namespace balcony::render
