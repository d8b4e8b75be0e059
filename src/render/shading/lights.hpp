// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The lights of a scene: punctual lights, as defined by the glTF extension KHR_lights_punctual, and
// the default light at the viewer.

#include <cstddef>
#include <optional>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "balcony/scene.hpp"

namespace balcony::render {

/// An illuminated point, and the direction to its viewer.
struct LitPoint {
    Imath::V3f position;   ///< World coordinates.
    Imath::V3f to_viewer;  ///< Unit.
};

/// The light that arrives at a point from one light source, without occlusion.
struct Illumination {
    Imath::V3f to_light;           ///< Unit.
    float distance = 0.0F;         ///< Scene units; infinite for a directional light, 0 for the
                                   ///< light at the viewer, which casts no shadows.
    Imath::Color3f irradiance{0};  ///< On a plane perpendicular to its direction, in lux.
};

/// One light, chosen with a probability.
struct LightSample {
    Illumination arriving;
    float probability = 0.0F;  ///< The probability of selecting this light.
};

/// All lights of a scene, which must outlive the set.
class LightSet {
public:
    explicit LightSet(const scene::Scene& scene) : scene_(&scene) {}

    [[nodiscard]] std::size_t size() const {
        return scene_->lights.size() + (scene_->default_light ? 1 : 0);
    }

    /// The light from one source, by index. Nothing from a source at the point itself.
    [[nodiscard]] Illumination arriving(std::size_t light, const LitPoint& point) const;

    /// Selects one light by a number in [0, 1). The mean of irradiance / probability is the sum
    /// over all lights. Nothing if there are none.
    [[nodiscard]] std::optional<LightSample> sample(const LitPoint& point, float random) const;

private:
    const scene::Scene* scene_;
};

}  // namespace balcony::render
