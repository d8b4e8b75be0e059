// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The sheen of cloth, KHR_materials_sheen: fibres that stand up from the surface.

#include "shading/materials/transport.hpp"

namespace balcony::render {

/// The "Charlie" distribution of Estevez and Kulla, "Production Friendly Microfacet Sheen BRDF"
/// (2017), with the visibility of Neubelt and Pettineo, "Crafting a Next-Gen Material Pipeline for
/// The Order: 1886" (2013). Of smooth fibres these reflect more light than they receive at a
/// grazing angle. Where the albedo is above 1, that is corrected by a factor of the viewer and the
/// same one of the light, which is reciprocal.
///
/// A roughness below 0.2 counts as 0.2. Cosines are those of directions with the normal of the
/// surface, in (0, 1].
class Sheen {
public:
    explicit Sheen(float roughness);

    /// At a cosine of the viewer or of the light.
    struct Energy {
        float scale;
        float albedo;  ///< Of even light; at most 1.
    };
    [[nodiscard]] Energy at(float cosine) const;

    /// The reflectance, for the scale of either direction.
    [[nodiscard]] float reflectance(float viewer, float light, float facet_squared_sine,
                                    float scale) const;

    /// By what the layer below shines through: for CoverTable, which has these rows.
    static constexpr std::size_t row_count = 24;
    [[nodiscard]] static ByCosine transmitted(std::size_t row);
    [[nodiscard]] float row() const { return row_; }

private:
    float inverse_alpha_;
    float row_;
};

}  // namespace balcony::render
