// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/materials/bsdf_material.hpp"

#include <algorithm>
#include <array>

namespace balcony::render {

namespace {

// KHR_materials_specular, with KHR_materials_ior.
Color3f dielectric_reflectance(const Appearance& appearance) {
    const Color3f f0 = normal_reflectance(appearance.ior) * appearance.specular_color;
    return appearance.specular *
           Color3f(std::min(f0.x, 1.0F), std::min(f0.y, 1.0F), std::min(f0.z, 1.0F));
}

// The width of GGX; 0 of a mirror.
float width(float roughness) {
    const float alpha = square(roughness);
    return alpha < min_alpha ? 0.0F : alpha;
}

}  // namespace

BsdfMaterial::BsdfMaterial(const Appearance& appearance, bool entering)
    : PlainMaterial{.diffuse = (1.0F - appearance.metallic) * (1.0F - appearance.transmission) *
                               appearance.base_color,
                    .roughness = width(appearance.roughness) > 0.0F ? appearance.roughness : 0.0F,
                    .facets = Ggx(width(appearance.roughness)),
                    .energies = LayerEnergies(width(appearance.roughness))},
      metal(appearance.metallic * appearance.base_color) {
    const float metallic = appearance.metallic;
    if (metallic > 0.0F) {
        const Color3f& color = appearance.base_color;
        specular.add(Color3f(metallic), color, Color3f(1.0F), color);
    }
    if (metallic < 1.0F) {
        const Color3f f0 = dielectric_reflectance(appearance);
        const Color3f f90(appearance.specular);
        const float opaque = (1.0F - metallic) * (1.0F - appearance.transmission);
        specular.add(Color3f(opaque), f0, f90, f0);
        dielectric.add(1.0F, largest(f0), appearance.specular, largest(f0));
        if (appearance.transmission > 0.0F) {
            add_passage(appearance, f0, entering);
        }
    }
    if (appearance.clearcoat > 0.0F || largest(appearance.sheen_color) > 0.0F) {
        add_covers(appearance);
    }
    const float mean = layers ? mean_below_covers() : passed_below(*this, energies.mean(), 1.0F);
    per_mean_below = mean > 0.0F ? 1.0F / mean : 0.0F;
}

void BsdfMaterial::add_passage(const Appearance& appearance, const Color3f& f0, bool entering) {
    layers.emplace().passage.emplace(appearance, width(roughness), f0, appearance.specular,
                                     entering);
    const Passage& passage = *layers->passage;
    if (!passage.refracts) {
        specular.add(Color3f(passage.share), f0, Color3f(passage.f90), Color3f(1.0F));
    }
}

void BsdfMaterial::add_covers(const Appearance& appearance) {
    if (!layers) {
        layers.emplace();
    }
    if (appearance.clearcoat > 0.0F) {
        layers->coat.emplace(appearance, width(roughness));
    }
    if (largest(appearance.sheen_color) > 0.0F) {
        layers->fibres.emplace(appearance, width(roughness));
    }
}

Covered BsdfMaterial::covered(float cosine) const {
    const LayerEnergy layer = energies.at(cosine);
    return layers->is_below_covers() ? Covered{.layer = layer} : layers->at(layer, cosine);
}

// Gauss and Legendre's rule, over the cosine, with the cosine as weight.
float BsdfMaterial::mean_below_covers() const {
    constexpr std::array<float, 6> points{0.0337652429F, 0.1693953068F, 0.3806904070F,
                                          0.6193095930F, 0.8306046932F, 0.9662347571F};
    constexpr std::array<float, 6> weights{0.0856622462F, 0.1803807865F, 0.2339569673F,
                                           0.2339569673F, 0.1803807865F, 0.0856622462F};
    float mean = 0.0F;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Covered at = covered(points[i]);
        mean += 2.0F * points[i] * weights[i] * passed_below(*this, at.layer, at.passed);
    }
    return mean;
}

bool BsdfMaterial::is_rough() const {
    constexpr float wide = 0.3F;
    const bool coat_is_rough = !layers || !layers->coat || layers->coat->roughness > wide;
    return roughness > wide && coat_is_rough && !transmits();
}

Color3f BsdfMaterial::ambient_reflectance() const {
    return is_mirror() ? diffuse : diffuse + metal;
}

}  // namespace balcony::render
