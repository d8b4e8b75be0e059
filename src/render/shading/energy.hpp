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
#include <vector>

#include "render/shading/transport.hpp"

namespace balcony::render {

/// Layers with a smaller width are perfect mirrors.
inline constexpr float min_alpha = 1e-3F;

/// What a GGX layer reflects of even light, seen from a direction. It is linear in the reflectance
/// f0 + (f90 - f0) schlick(cosine) of the facets:
///
///     f0 single + (f90 - f0) single_edge      by the facets that the light meets first,
///     f0 all    + (f90 - f0) all_edge         multiplied by c(viewer) c(light).
struct LayerEnergy {
    float scale;  ///< c
    float single;
    float single_edge;
    float all;  ///< 1, unless something covers the layer.
    float all_edge;
};

/// LayerEnergy of one layer by cosine. Small: made for each point of a surface. The tables behind
/// it are made once, when the first of these is.
class LayerEnergies {
public:
    /// `alpha` from min_alpha to 1; below, a perfect mirror.
    explicit LayerEnergies(float alpha);

    [[nodiscard]] LayerEnergy at(float cosine) const;
    /// The mean, weighted by the cosine; without meaning for `scale`.
    [[nodiscard]] LayerEnergy mean() const;

private:
    struct Entry {
        float scale, single, single_edge, all_edge;
    };
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
