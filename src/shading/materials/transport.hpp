// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The light that a layer carries between directions, as matrices over a grid of cosines: what the
// tables of energy.hpp are made of.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shading/lanes/scalar.hpp"

namespace balcony::render {

#include "shading/materials/table.inl"

using ByCosine = std::array<float, cosine_count>;

/// GGX layers with a smaller width are perfect mirrors.
inline constexpr float min_alpha = 1e-3F;

/// Tables by the width of a layer have rows from min_alpha to 1, evenly spaced by the fourth root.
[[nodiscard]] inline TablePosition position_of_width(float alpha, std::size_t count) {
    constexpr float first = 0.177827941F;  // The fourth root of min_alpha.
    const float root = std::sqrt(std::sqrt(alpha));
    return table_position((root - first) / (1.0F - first) * static_cast<float>(count - 1), count);
}
[[nodiscard]] float table_width(std::size_t row, std::size_t count);

[[nodiscard]] const ByCosine& table_cosines();
/// How much of a function's mean, weighted by the cosine, each node holds.
[[nodiscard]] const ByCosine& cosine_weights();
[[nodiscard]] float cosine_mean(const ByCosine& function);

/// A linear map of functions of the cosine. An entry is the part of even light, seen from the
/// cosine of the row, that comes from around the cosine of the column.
class Transport {
public:
    Transport() : entries_(cosine_count * cosine_count, 0.0F) {}

    void add(std::size_t viewer, const TablePosition& light, float part);
    [[nodiscard]] float operator()(std::size_t viewer, const ByCosine& light) const;

private:
    std::vector<float> entries_;
};

/// What a GGX layer reflects by single scattering.
struct GgxTransport {
    Transport reflected;  ///< With a reflectance of 1.
    Transport edge;       ///< With the reflectance schlick(cosine).
};

[[nodiscard]] GgxTransport ggx_transport(float alpha);

/// What a GGX layer of glass reflects and refracts by single scattering, seen from one side, where
/// its relative index of refraction is `eta`. Radiance counts as in Bsdf.
struct GlassTransport {
    Transport reflected;
    Transport refracted;  ///< From the cosines of the other side.
};

[[nodiscard]] GlassTransport glass_transport(float alpha, float eta);

/// The positive function c for which c(viewer) · transport(viewer, c) is the target.
[[nodiscard]] ByCosine balance(const Transport& transport, const ByCosine& target);

}  // namespace balcony::render
