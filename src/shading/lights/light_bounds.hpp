// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <Imath/ImathBox.h>
#include <Imath/ImathVec.h>

namespace balcony::render {

/// Bounds of the position, the direction and the strength of the emission of one or several lights:
/// Conty Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting"
/// (2018), section 4.1.
struct LightBounds {
    Imath::Box3f box;                   ///< Empty without lights.
    Imath::V3f axis{0.0F, 0.0F, 1.0F};  ///< Unit: the mean of the axes of emission.
    float cosine_spread = 1.0F;         ///< Of the largest angle between axis and axes.
    float cosine_falloff = 1.0F;        ///< Of the angle from an axis beyond which it is dark.
    bool two_sided = false;             ///< The same in the opposite directions.
    float power = 0.0F;                 ///< Irradiance at distance 1 along the axis.
};

[[nodiscard]] LightBounds bounds_of(std::span<const LightBounds> lights);

}  // namespace balcony::render
