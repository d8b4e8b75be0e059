// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/materials/layers.hpp"

#include <algorithm>
#include <array>

namespace balcony::render {

namespace {

constexpr std::size_t coat_count = 24;

float coat_alpha(const Appearance& appearance) {
    return std::max(square(appearance.clearcoat_roughness), min_alpha);
}

const LayerReflectance<float>& reflectance_of_coat() {
    static const LayerReflectance<float> reflectance = [] {
        const float f0 = normal_reflectance(1.5F);
        LayerReflectance<float> made;
        made.add(1.0F, f0, 1.0F, f0);
        return made;
    }();
    return reflectance;
}

const CoverTable& coat_table() {
    static const CoverTable table([] {
        std::array<ByCosine, coat_count> transmitted{};
        for (std::size_t row = 0; row < coat_count; ++row) {
            const LayerEnergies coat(table_width(row, coat_count));
            for (std::size_t node = 0; node < cosine_count; ++node) {
                transmitted[row][node] =
                    1.0F - reflectance_of_coat().albedo(coat.at(table_cosines()[node]));
            }
        }
        return transmitted;
    }());
    return table;
}

const CoverTable& sheen_table() {
    static const CoverTable table([] {
        std::array<ByCosine, Sheen::row_count> transmitted{};
        for (std::size_t row = 0; row < Sheen::row_count; ++row) {
            transmitted[row] = Sheen::transmitted(row);
        }
        return transmitted;
    }());
    return table;
}

float position_of_coat(float alpha) {
    const TablePosition at = position_of_width(alpha, coat_count);
    return static_cast<float>(at.node) + at.fraction;
}

}  // namespace

Coat::Coat(const Appearance& appearance, float alpha_below)
    : weight(appearance.clearcoat),
      roughness(appearance.clearcoat_roughness),
      facets(coat_alpha(appearance)),
      energies(coat_alpha(appearance)),
      cover(coat_table(), position_of_coat(coat_alpha(appearance)), alpha_below) {}

Fibres::Fibres(const Appearance& appearance, float alpha_below)
    : color(appearance.sheen_color),
      weight(largest(color)),
      sheen(appearance.sheen_roughness),
      cover(sheen_table(), sheen.row(), alpha_below) {}

Passage::Passage(const Appearance& appearance, float alpha, const Color3f& normal_reflectances,
                 float edge_reflectance, bool entering)
    : share((1.0F - appearance.metallic) * appearance.transmission),
      tint(appearance.base_color),
      f0(normal_reflectances),
      f90(edge_reflectance),
      refracts(!appearance.thin_walled),
      outside(entering),
      ior(std::max(appearance.ior, min_glass_ior)),
      eta(entering ? ior : 1.0F / ior),
      lost(std::min({1.0F, f90, f0.x / normal_reflectance(ior), f0.y / normal_reflectance(ior),
                     f0.z / normal_reflectance(ior)})),
      energies(refracts ? alpha : 0.0F, ior) {}

Color3f Passage::reflectance(float cosine) const {
    if (!refracts) {
        return f0 + schlick(cosine) * (Color3f(f90) - f0);
    }
    const float exact = fresnel(cosine, eta);
    if (exact >= 1.0F) {
        return Color3f(1.0F);
    }
    const float least = normal_reflectance(ior);
    const float edge = std::max(exact - least, 0.0F) / (1.0F - least);
    return f0 + edge * (Color3f(f90) - f0);
}

Color3f Passage::transmittance(const Color3f& reflected) const {
    return std::max(1.0F - largest(reflected), 0.0F) * tint;
}

float Passage::reflection_probability(const Color3f& reflected) const {
    const float back = largest(reflected);
    const float on = largest(transmittance(reflected));
    return back > 0.0F ? back / (back + on) : 0.0F;
}

std::optional<Appearance> Appearance::softened(float least_roughness) const {
    const auto is_sharp = [least_roughness](float one) { return one < 0.6F * least_roughness; };
    const bool is_pane = transmission > 0.0F && thin_walled && square(roughness) < min_alpha;
    const bool layer_is_sharp = !is_pane && is_sharp(roughness);
    const bool coat_is_sharp = clearcoat > 0.0F && is_sharp(clearcoat_roughness);
    if (!layer_is_sharp && !coat_is_sharp) {
        return std::nullopt;
    }
    Appearance made = *this;
    if (layer_is_sharp) {
        made.roughness = least_roughness;
    }
    if (coat_is_sharp) {
        made.clearcoat_roughness = least_roughness;
    }
    return made;
}

Color3f Appearance::emission_through_coat(float cosine) const {
    Color3f found = emission;
    if (clearcoat > 0.0F) {
        found *= 1.0F - clearcoat * coat_reflectance(schlick(cosine), 1.0F);
    }
    return found;
}

float coat_reflectance(float edge, float scale) {
    return reflectance_of_coat().at_facet(edge, scale);
}

Covered Layers::at(const LayerEnergy& layer, float cosine) const {
    Covered found;
    found.layer = layer;
    if (coat) {
        found.coat_energy = coat->energies.at(cosine);
        const float reflected = reflectance_of_coat().albedo(found.coat_energy);
        found.coat = coat->weight * reflected;
        found.coat_scale =
            coat->cover.apply(found.layer, coat->weight, std::max(1.0F - reflected, 0.0F), cosine);
        found.passed -= found.coat;
    }
    if (fibres) {
        found.sheen = fibres->sheen.at(cosine);
        found.fibres = fibres->weight * found.sheen.albedo * found.passed;
        found.fibres_scale = fibres->cover.apply(found.layer, fibres->weight,
                                                 std::max(1.0F - found.sheen.albedo, 0.0F), cosine);
        found.passed -= found.fibres;
    }
    return found;
}

CoatAt Layers::tilted_coat(const Covered& flat, float cosine) const {
    const LayerEnergy energy = coat->energies.at(std::max(cosine, 0.0F));
    const float reflected = coat->weight * reflectance_of_coat().albedo(energy);
    const float shade = reflected > flat.coat ? (1.0F - reflected) / (1.0F - flat.coat) : 1.0F;
    return {cosine, energy.scale, reflected, std::max(shade, 0.0F)};
}

float Layers::cover_factor(const Covered& viewer, const Covered& light) const {
    const auto factor = [](float weight, float scale) { return 1.0F - weight + weight * scale; };
    float product = 1.0F;
    if (coat) {
        product *= factor(coat->weight, viewer.coat_scale * light.coat_scale);
    }
    if (fibres) {
        product *= factor(fibres->weight, viewer.fibres_scale * light.fibres_scale);
    }
    return product;
}

}  // namespace balcony::render
