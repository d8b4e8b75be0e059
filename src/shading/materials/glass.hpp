// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The rough boundary of a refracting solid: Walter et al. 2007, with what it takes to lose no
// light.
//
// Here facets block light that has been reflected or refracted once. That part L(viewer) leaves the
// boundary on both sides, by the lobe of Kulla and Conty, "Revisiting Physically Based Shading at
// Imageworks" (2017), with n² as a weight of the side, where n is its index of refraction:
//
//     L(viewer) L(light) n(light)² / (π D),   D = the sum over both sides of n² times the mean of
//     L.

#include <array>
#include <cstddef>

#include "shading/materials/transport.hpp"

namespace balcony::render {

/// At an index of refraction of 1 there is no boundary, and no facet decides where the light goes.
inline constexpr float min_glass_ior = 1.001F;

/// Smoother glass loses light close to the horizon only, within about its width. A lobe that gives
/// it back there would be found by few samples, which would be bright spots in a picture.
inline constexpr float min_glass_alpha = 0.02F;

/// The sides of a boundary, as indices.
enum GlassSide : std::size_t { glass_inside, glass_outside };

class GlassEnergies {
public:
    /// Indices of refraction up to 3; above, 3. Smoother glass than min_glass_alpha counts as if it
    /// lost nothing. The tables behind it are made for each index when it is first used.
    GlassEnergies(float alpha, float ior);

    /// L, where LayerEnergy::single of the same facets is known.
    [[nodiscard]] float lost(GlassSide side, float cosine, float single) const;
    /// The part of the lost light that leaves on a side.
    [[nodiscard]] float share(GlassSide side) const { return share_[side]; }
    /// What of even light a viewer sees of the lost light, over L(viewer) L(light).
    [[nodiscard]] float scattered(GlassSide light) const { return scattered_[light]; }

private:
    struct Row {
        // By side; outside over what the same facets lose as mirrors, which changes less.
        std::array<ByCosine, 2> lost;
        std::array<float, 2> mean;
    };
    static constexpr std::size_t width_count = 20;
    using Rows = std::array<Row, width_count>;

    static Row make_row(float alpha, float ior);
    /// Made when they are first asked for.
    static const Rows& rows(float ior);

    const Row* lower_ = nullptr;  // The next one is the upper; none if smooth.
    float fraction_ = 0.0F;       // From the lower to the upper.
    std::array<float, 2> share_{};
    std::array<float, 2> scattered_{};
};

}  // namespace balcony::render
