// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/materials/glass.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "shading/materials/energy.hpp"
#include "shading/materials/microfacets.hpp"

namespace balcony::render {

namespace {

// Indices of refraction are rounded to the nearest of 1024, evenly spaced by the fourth root of the
// reflectance at normal incidence, up to 3.
constexpr std::size_t ior_count = 1024;
constexpr float last_root = 0.707106781F;

std::size_t ior_number(float ior) {
    const float root = std::sqrt((ior - 1.0F) / (ior + 1.0F));
    const TablePosition at = table_position(root / last_root * (ior_count - 1), ior_count);
    return at.node + (at.fraction < 0.5F ? 0 : 1);
}

float ior_of(std::size_t number) {
    const float contrast = square(last_root * static_cast<float>(number) / (ior_count - 1));
    return std::max((1.0F + contrast) / (1.0F - contrast), min_glass_ior);
}

// Less than this is not worth a ratio.
constexpr float negligible = 1e-4F;

// The table holds the lost light over this, which changes less from node to node. Outside, it is
// what the same facets lose as mirrors. Inside it is not: at the horizon mirrors lose nothing, but
// facets that reflect totally do.
float table_scale(GlassSide side, float single) {
    return side == glass_outside ? 1.0F - single : 1.0F;
}

}  // namespace

GlassEnergies::Row GlassEnergies::make_row(float alpha, float ior) {
    const LayerEnergies layer(alpha);
    ByCosine one;
    one.fill(1.0F);
    Row row{};
    for (const GlassSide side : {glass_inside, glass_outside}) {
        const GlassTransport transport =
            glass_transport(alpha, side == glass_outside ? ior : 1.0F / ior);
        for (std::size_t node = 0; node < cosine_count; ++node) {
            const float lost =
                1.0F - transport.reflected(node, one) - transport.refracted(node, one);
            const float scale = table_scale(side, layer.at(table_cosines()[node]).single);
            row.mean[side] += cosine_weights()[node] * std::max(lost, 0.0F);
            row.lost[side][node] = std::max(lost, 0.0F) / std::max(scale, negligible);
        }
    }
    return row;
}

const GlassEnergies::Rows& GlassEnergies::rows(float ior) {
    static std::array<std::once_flag, ior_count> made;
    static std::array<std::unique_ptr<Rows>, ior_count> all;
    const std::size_t number = ior_number(ior);
    std::call_once(made[number], [number] {
        all[number] = std::make_unique<Rows>();
        for (std::size_t width = 0; width < width_count; ++width) {
            (*all[number])[width] = make_row(table_width(width, width_count), ior_of(number));
        }
    });
    return *all[number];
}

GlassEnergies::GlassEnergies(float alpha, float ior) {
    if (alpha < min_glass_alpha) {
        return;
    }
    const TablePosition at_width = position_of_width(alpha, width_count);
    lower_ = &rows(ior)[at_width.node];
    fraction_ = at_width.fraction;
    const std::array<float, 2> weight{square(ior), 1.0F};
    std::array<float, 2> weighted_mean{};
    for (const GlassSide side : {glass_inside, glass_outside}) {
        weighted_mean[side] =
            weight[side] * mix(lower_[0].mean[side], lower_[1].mean[side], fraction_);
    }
    const float sum = weighted_mean[0] + weighted_mean[1];
    for (const GlassSide side : {glass_inside, glass_outside}) {
        share_[side] = sum > 0.0F ? weighted_mean[side] / sum : 0.0F;
        scattered_[side] = sum > 0.0F ? weight[side] / sum : 0.0F;
    }
}

float GlassEnergies::lost(GlassSide side, float cosine, float single) const {
    if (lower_ == nullptr) {
        return 0.0F;
    }
    const TablePosition at = position_of_cosine(cosine);
    const auto look_up = [&](const ByCosine& table) {
        return mix(table[at.node], table[at.node + 1], at.fraction);
    };
    const float ratio =
        mix(look_up(lower_[0].lost[side]), look_up(lower_[1].lost[side]), fraction_);
    return std::clamp(ratio * table_scale(side, single), 0.0F, 1.0F);
}

}  // namespace balcony::render
