// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light from infinitely far away: an environment and suns.

#include <optional>
#include <vector>

#include <Imath/ImathMatrix.h>

#include "balcony/scene.hpp"
#include "render/lights/environment_state.hpp"

namespace balcony::render {

/// Directions are chosen from all lights that cover more than a single direction together, because
/// a ray that leaves the scene cannot tell them apart.
class DistantLights {
public:
    struct Sample {
        Imath::V3f to_light;
        Imath::Color3f radiance{0};  ///< If delta: irradiance.
        float pdf = 0.0F;            ///< If delta: a probability.
        bool delta = false;
    };

    DistantLights(const scene::Scene& scene, const std::optional<Environment>& environment);

    [[nodiscard]] bool empty() const { return !environment_ && suns_.empty(); }
    [[nodiscard]] bool has_radiance() const { return environment_.has_value(); }

    [[nodiscard]] std::optional<Sample> sample(const Imath::V3f& normal,
                                               const Imath::V3f& random) const;
    [[nodiscard]] float pdf(const Imath::V3f& normal, const Imath::V3f& direction) const;
    [[nodiscard]] Imath::Color3f radiance(const Imath::V3f& direction) const;

private:
    struct Sun {
        Imath::V3f to_light;
        Imath::Color3f irradiance{0};
    };

    std::vector<Sun> suns_;
    std::optional<Environment::State> environment_;  // Only if it is not black.
    Imath::M33f environment_from_world_;             // Orthogonal.
};

}  // namespace balcony::render
