// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a rough layer reflects of the light that it receives, and what it takes to reflect all.
//
// A GGX layer accounts for light that meets one facet; what other facets block is lost, up to 70 %
// for a rough surface seen straight on. In a real surface it is reflected again. This renderer
// multiplies the layer by c(viewer) c(light), with that function c by which a layer with a
// reflectance of 1 reflects all light, from each direction:
//
//     c(viewer) · ∫ layer(viewer, light) c(light) cosine dlight = 1.
//
// Turquin, "Practical Multiple Scattering Compensation for Microfacet Models" (2019), divides by
// the integral at the viewer alone; the product is reciprocal as well. Such a function exists for a
// symmetric kernel and is the limit of a simple iteration (Sinkhorn and Knopp, "Concerning
// Nonnegative Matrices and Doubly Stochastic Matrices", 1967).

#include <array>
#include <memory>
#include <vector>

#include "shading/materials/microfacets.hpp"
#include "shading/materials/transport.hpp"

namespace balcony::render {

#include "shading/materials/energy.inl"

/// LayerEnergy in a table, where `all` is 1.
struct EnergyEntry {
    float scale, single, single_edge, all_edge;
};

/// Between two entries of a table.
template <typename Entry>
[[nodiscard]] Entry between(const Entry& a, const Entry& b, float t) {
    return {mix(a.scale, b.scale, t), mix(a.single, b.single, t),
            mix(a.single_edge, b.single_edge, t), mix(a.all_edge, b.all_edge, t)};
}

/// LayerEnergy of one layer by cosine. Small: made for each point of a surface, and copied. The
/// tables behind it are made once, when the first of these is.
class LayerEnergies {
public:
    /// `alpha` from min_alpha to 1; below, a perfect mirror.
    explicit LayerEnergies(float alpha);

    /// Makes at() quicker, for a layer of many points, at the price of memory: of what is returned,
    /// which must outlive this and its copies. Nothing for a mirror.
    [[nodiscard]] std::shared_ptr<const void> keep_row();

    [[nodiscard]] LayerEnergy at(float cosine) const {
        if (lower_ == nullptr) {
            const float edge = schlick(cosine);
            return {1.0F, 1.0F, edge, 1.0F, edge};
        }
        const TablePosition at = position_of_cosine(cosine);
        const Entry* const lower = &lower_[0].by_cosine[at.node];
        Entry entry = between(lower[0], lower[1], at.fraction);
        if (fraction_ > 0.0F) {
            const Entry* const upper = &lower_[1].by_cosine[at.node];
            entry = between(entry, between(upper[0], upper[1], at.fraction), fraction_);
        }
        return {entry.scale, entry.single, entry.single_edge, 1.0F, entry.all_edge};
    }
    /// The entries by cosine, between which at() interpolates, after keep_row(); otherwise null.
    [[nodiscard]] const EnergyEntry* row() const {
        return lower_ != nullptr && fraction_ == 0.0F ? lower_->by_cosine.data() : nullptr;
    }
    /// The mean, weighted by the cosine; without meaning for `scale`.
    [[nodiscard]] LayerEnergy mean() const;

private:
    using Entry = EnergyEntry;
    struct Row {
        std::array<Entry, cosine_count> by_cosine;
        Entry mean;
    };

    static const std::vector<Row>& rows();
    static Row make_row(float alpha);

    const Row* lower_ = nullptr;  // The next one is the upper; none for a mirror.
    float fraction_ = 0.0F;       // From the lower to the upper.
};

}  // namespace balcony::render
