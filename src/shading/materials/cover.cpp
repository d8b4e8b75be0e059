// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/materials/cover.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::render {

namespace {

// Where a cover lets next to nothing through, how it is shared does not matter.
constexpr float min_transmitted = 1e-4F;

// Nothing has no parts.
float ratio(float part, float whole) { return whole > 1e-7F ? part / whole : 1.0F; }

}  // namespace

CoverTable::CoverTable(std::span<const ByCosine> transmitted) : rows_(transmitted.size()) {
    for (std::size_t width = 0; width < width_count; ++width) {
        const float alpha = table_width(width, width_count);
        const GgxTransport transport = ggx_transport(alpha);
        const LayerEnergies bare(alpha);
        for (std::size_t cover = 0; cover < transmitted.size(); ++cover) {
            ByCosine target = transmitted[cover];
            for (float& value : target) {
                value = std::max(value, min_transmitted);
            }
            const ByCosine both = balance(transport.reflected, target);
            ByCosine one;
            one.fill(1.0F);
            ByCosine scale{};
            for (std::size_t node = 0; node < cosine_count; ++node) {
                scale[node] = both[node] / bare.at(table_cosines()[node]).scale;
            }
            for (std::size_t node = 0; node < cosine_count; ++node) {
                const float passed = scale[node] / target[node];
                const LayerEnergy before = bare.at(table_cosines()[node]);
                rows_[cover][width][node] = {
                    scale[node], ratio(passed * transport.reflected(node, scale), before.single),
                    ratio(passed * transport.edge(node, scale), before.single_edge),
                    ratio(passed * before.scale * transport.edge(node, both), before.all_edge)};
            }
        }
    }
}

Cover::Cover(const CoverTable& table, float cover, float alpha) {
    if (alpha < min_alpha) {
        return;
    }
    const TablePosition at_width = position_of_width(alpha, CoverTable::width_count);
    const TablePosition at_cover = table_position(cover, table.rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        rows_[i] = &table.rows_[at_cover.node + i / 2][at_width.node + i % 2];
    }
    cover_fraction_ = at_cover.fraction;
    width_fraction_ = at_width.fraction;
}

float Cover::apply(LayerEnergy& energy, float weight, float transmitted, float cosine) const {
    CoverTable::Entry entry{std::sqrt(transmitted), 1.0F, 1.0F, 1.0F};
    if (rows_[0] != nullptr) {
        const TablePosition at = position_of_cosine(cosine);
        const auto look_up = [&](std::size_t cover) {
            const CoverTable::Entry* const lower = &(*rows_[2 * cover])[at.node];
            const CoverTable::Entry* const upper = &(*rows_[2 * cover + 1])[at.node];
            return between(between(lower[0], lower[1], at.fraction),
                           between(upper[0], upper[1], at.fraction), width_fraction_);
        };
        entry = between(look_up(0), look_up(1), cover_fraction_);
    }
    const auto covered = [&](float factor) {
        return 1.0F - weight + weight * transmitted * factor;
    };
    energy.single *= covered(entry.single);
    energy.single_edge *= covered(entry.single_edge);
    energy.all *= covered(1.0F);
    energy.all_edge *= covered(entry.all_edge);
    return entry.scale;
}

}  // namespace balcony::render
