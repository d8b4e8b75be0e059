// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Punctual lights, as the glTF extension KHR_lights_punctual defines them.

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "balcony/scene.hpp"

namespace balcony::render {

/// The light that arrives at a point from one lamp, if nothing is in between.
struct Illumination {
    Imath::V3f to_light;           ///< Unit.
    float distance = 0.0F;         ///< Scene units; infinite for a directional light.
    Imath::Color3f irradiance{0};  ///< On a plane across its direction, lux.
};

[[nodiscard]] Illumination illuminate(const scene::Light& light, const Imath::V3f& position,
                                      double meters_per_unit);

}  // namespace balcony::render
