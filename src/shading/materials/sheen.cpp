// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/materials/sheen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "shading/materials/microfacets.hpp"

namespace balcony::render {

namespace {

using std::numbers::pi_v;

// Smoother fibres would show at the very horizon only, where they reflect too much.
constexpr float min_roughness = 0.2F;

struct Row {
    ByCosine scale;
    ByCosine albedo;
};

float roughness_of(std::size_t row) {
    const float fraction = static_cast<float>(row) / static_cast<float>(Sheen::row_count - 1);
    return min_roughness + fraction * (1.0F - min_roughness);
}

Row make_row(const Sheen& sheen) {
    constexpr std::size_t count = 64;
    const auto midpoint = [](std::size_t i) {
        return (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
    };
    Transport transport;
    for (std::size_t node = 0; node < cosine_count; ++node) {
        const float viewer = std::max(table_cosines()[node], 1e-4F);
        const V3f to_viewer(std::sqrt(std::max(1.0F - square(viewer), 0.0F)), 0.0F, viewer);
        for (std::size_t row = 0; row < count; ++row) {
            // Closer where the light grazes.
            const float light = square(midpoint(row));
            const float radius = std::sqrt(1.0F - square(light));
            const TablePosition at = position_of_cosine(light);
            for (std::size_t column = 0; column < count; ++column) {
                const float angle = pi_v<float> * midpoint(column);
                const V3f to_light(radius * std::cos(angle), radius * std::sin(angle), light);
                const HalfVector halfway({0.0F, 0.0F, 1.0F}, to_viewer, to_light);
                const float density = 2.0F * pi_v<float> * 2.0F * midpoint(row) / (count * count);
                transport.add(
                    node, at,
                    density * light * sheen.reflectance(viewer, light, halfway.squared_sine, 1.0F));
            }
        }
    }
    ByCosine scale;
    scale.fill(1.0F);
    const ByCosine one = scale;
    for (std::size_t node = 0; node < cosine_count; ++node) {
        scale[node] = 1.0F / std::max(transport(node, one), 1.0F);
    }
    Row made{scale, {}};
    for (std::size_t node = 0; node < cosine_count; ++node) {
        made.albedo[node] = scale[node] * transport(node, scale);
    }
    return made;
}

const std::array<Row, Sheen::row_count>& rows() {
    static const std::array<Row, Sheen::row_count> made = [] {
        std::array<Row, Sheen::row_count> all;
        for (std::size_t row = 0; row < Sheen::row_count; ++row) {
            all[row] = make_row(Sheen(roughness_of(row)));
        }
        return all;
    }();
    return made;
}

}  // namespace

Sheen::Sheen(float roughness)
    : inverse_alpha_(1.0F / square(std::max(roughness, min_roughness))),
      row_((roughness - min_roughness) / (1.0F - min_roughness) * (row_count - 1)) {}

Sheen::Energy Sheen::at(float cosine) const {
    const TablePosition row = table_position(row_, row_count);
    const TablePosition node = position_of_cosine(cosine);
    const auto look_up = [&](const ByCosine& lower, const ByCosine& upper) {
        const float low = mix(lower[node.node], lower[node.node + 1], node.fraction);
        const float high = mix(upper[node.node], upper[node.node + 1], node.fraction);
        return mix(low, high, row.fraction);
    };
    const Row& lower = rows()[row.node];
    const Row& upper = rows()[row.node + 1];
    return {look_up(lower.scale, upper.scale), look_up(lower.albedo, upper.albedo)};
}

float Sheen::reflectance(float viewer, float light, float facet_squared_sine, float scale) const {
    const float density = (2.0F + inverse_alpha_) *
                          std::pow(facet_squared_sine, 0.5F * inverse_alpha_) /
                          (2.0F * pi_v<float>);
    return scale * density / (4.0F * (viewer + light - viewer * light));
}

ByCosine Sheen::transmitted(std::size_t row) {
    ByCosine found = rows()[row].albedo;
    for (float& value : found) {
        value = 1.0F - value;
    }
    return found;
}

}  // namespace balcony::render
