// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The lights of a scene: punctual ones, as the glTF extension KHR_lights_punctual defines them, and
// the light at the viewer that shows a scene without any.

#include <cstddef>
#include <optional>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "balcony/scene.hpp"

namespace balcony::render {

/// A point that is lit, and where it is seen from.
struct LitPoint {
    Imath::V3f position;   ///< World coordinates.
    Imath::V3f to_viewer;  ///< Unit.
};

/// The light that arrives at a point from one light source, without occlusion.
struct Illumination {
    Imath::V3f to_light;           ///< Unit.
    float distance = 0.0F;         ///< Scene units; infinite for a directional light, 0 for the
                                   ///< light at the viewer, which nothing shadows.
    Imath::Color3f irradiance{0};  ///< On a plane perpendicular to its direction, in lux.
};

/// One light, chosen with a probability.
struct LightSample {
    Illumination arriving;
    float probability = 0.0F;  ///< Of this light among all. Its direction is then certain.
};

/// All lights of a scene, which must outlive the set.
class LightSet {
public:
    explicit LightSet(const scene::Scene& scene) : scene_(&scene) {}

    [[nodiscard]] std::size_t size() const;

    /// What arrives from a light, by index. Nothing from one that lies on the point.
    [[nodiscard]] Illumination arriving(std::size_t light, const LitPoint& point) const;

    /// One light by a number from [0, 1). The mean of irradiance / probability is the sum over all
    /// lights. Nothing where there are none.
    [[nodiscard]] std::optional<LightSample> sample(const LitPoint& point, float random) const;

private:
    const scene::Scene* scene_;
};

}  // namespace balcony::render
