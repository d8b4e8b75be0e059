// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Lights without a surface, as the glTF extension KHR_lights_punctual defines them.

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "balcony/scene.hpp"
#include "shading/lights/light_bounds.hpp"

namespace balcony::render {

/// The light that arrives at a point from one light source, without occlusion.
struct Illumination {
    Imath::V3f to_light;           ///< Unit.
    float distance = 0.0F;         ///< Scene units; infinite for a directional light, 0 for the
                                   ///< light at the viewer, which casts no shadows.
    Imath::Color3f irradiance{0};  ///< On a plane perpendicular to its direction, in lux.
};

/// The light of a lamp at a position. Nothing from a lamp at the position itself.
[[nodiscard]] Illumination light_of(const scene::Light& lamp, const Imath::V3f& position,
                                    double meters_per_unit);

/// Of a point or a spot light.
[[nodiscard]] LightBounds bounds_of(const scene::Light& lamp, double meters_per_unit);

}  // namespace balcony::render
