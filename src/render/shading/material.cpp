// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/shading/material.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace balcony::render {

namespace {

constexpr Color3f white(1.0F, 1.0F, 1.0F);

float square(float x) { return x * x; }

float opacity_of(const scene::Material& material, float texture_alpha) {
    const float alpha = std::clamp(material.alpha * texture_alpha, 0.0F, 1.0F);
    switch (material.alpha_mode) {
        case scene::AlphaMode::opaque: return 1.0F;
        case scene::AlphaMode::mask: return alpha >= material.alpha_cutoff ? 1.0F : 0.0F;
        case scene::AlphaMode::blend: return alpha;
    }
    return 1.0F;
}

// GGX's distribution of normals times the masking term, over four cosines.
float highlight(float roughness, float n_l, float n_v, float n_h) {
    const float a2 = square(square(roughness));
    const float distribution =
        a2 / (std::numbers::pi_v<float> * square(square(n_h) * (a2 - 1.0F) + 1.0F));
    const float masking = n_l * std::sqrt(square(n_v) * (1.0F - a2) + a2) +
                          n_v * std::sqrt(square(n_l) * (1.0F - a2) + a2);
    return distribution * 0.5F / masking;
}

}  // namespace

Color3f Appearance::normal_reflectance() const {
    return (1.0F - metallic) * 0.04F * white + metallic * base_color;
}

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
    return {material.base_color * Color3f(base.r, base.g, base.b),
            material.emission * Color3f(emission.r, emission.g, emission.b),
            opacity_of(material, base.a), std::clamp(material.metallic * surface.b, 0.0F, 1.0F),
            std::clamp(material.roughness * surface.g, 0.0F, 1.0F)};
}

float look_up_opacity(const scene::Material& material, const TextureLibrary& textures,
                      const TextureFootprint& footprint, TextureLibrary::ThreadCache cache) {
    return opacity_of(
        material,
        textures.look_up(material.base_color_texture, TextureEncoding::srgb, footprint, cache).a);
}

Color3f fresnel(const Color3f& normal_reflectance, float cosine) {
    const float c = std::clamp(1.0F - cosine, 0.0F, 1.0F);
    return normal_reflectance + square(square(c)) * c * (white - normal_reflectance);
}

Color3f reflected(const Appearance& appearance, const V3f& normal, const V3f& to_viewer,
                  const V3f& to_light) {
    const float n_l = normal.dot(to_light);
    const float n_v = normal.dot(to_viewer);
    if (n_l <= 0.0F || n_v <= 0.0F) {
        return Color3f(0.0F);
    }
    const V3f halfway = (to_light + to_viewer).normalized();
    const Color3f mirrored = fresnel(appearance.normal_reflectance(), to_viewer.dot(halfway));
    Color3f total = (white - mirrored) * appearance.diffuse() / std::numbers::pi_v<float>;
    if (!appearance.smooth()) {
        total += highlight(appearance.roughness, n_l, n_v, normal.dot(halfway)) * mirrored;
    }
    return n_l * total;
}

}  // namespace balcony::render
