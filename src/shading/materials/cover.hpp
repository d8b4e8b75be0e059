// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A GGX layer under a cover, that is, under a clearcoat or sheen.
//
// A cover that reflects the part E of even light leaves 1 - E. For the layer and the cover to
// conserve energy together and to be reciprocal, the layer is multiplied by v(viewer) v(light), the
// function with which a layer with a reflectance of 1 gives off 1 - E(viewer), as in energy.hpp.

#include <array>
#include <span>
#include <vector>

#include "shading/materials/energy.hpp"

namespace balcony::render {

/// By the widths of the layer and of the cover.
class CoverTable {
public:
    /// What each cover of a list lets through, by cosine.
    explicit CoverTable(std::span<const ByCosine> transmitted);

private:
    friend class Cover;

    /// v, and what the parts of LayerEnergy are multiplied by, over 1 - E.
    struct Entry {
        float scale, single, single_edge, all_edge;
    };
    using Row = std::array<Entry, cosine_count>;

    static constexpr std::size_t width_count = 24;
    std::vector<std::array<Row, width_count>> rows_;
};

/// One cover of one layer.
class Cover {
public:
    /// `cover` counts the table's covers and may lie between them. The table must live on.
    Cover(const CoverTable& table, float cover, float alpha);

    /// Multiplies by what a cover of this weight, from 0 to 1, does to a layer, where it lets pass
    /// the part `transmitted` of even light. Returns v.
    float apply(LayerEnergy& energy, float weight, float transmitted, float cosine) const;

private:
    std::array<const CoverTable::Row*, 4> rows_{};  // None for a mirror below.
    float cover_fraction_ = 0.0F;
    float width_fraction_ = 0.0F;
};

}  // namespace balcony::render
