// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light from infinitely far away: an environment and suns.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <Imath/ImathMatrix.h>

#include "balcony/scene.hpp"
#include "shading/lights/distant_visibility.hpp"
#include "shading/lights/environment_state.hpp"
#include "shading/lights/sun.hpp"

namespace balcony::render {

/// The environment and all suns with an angular size are one light with one density: a ray that
/// leaves the scene meets them together.
class DistantLights {
public:
    struct Sample {
        Imath::V3f to_light;
        Imath::Color3f radiance{0};  ///< If delta: irradiance.
        float pdf = 0.0F;            ///< If delta: a probability.
        bool delta = false;
    };

    /// The directional lights of the scene are suns; `sun_angle` replaces their angles.
    DistantLights(const scene::Scene& scene, const std::optional<Environment>& environment,
                  const std::optional<double>& sun_angle);

    [[nodiscard]] bool empty() const { return !environment_ && suns_.empty(); }
    [[nodiscard]] bool has_environment() const { return environment_.has_value(); }
    /// Whether radiance() is not always 0.
    [[nodiscard]] bool has_radiance() const { return has_radiance_; }
    [[nodiscard]] Imath::Color3f radiance(const Imath::V3f& direction) const;

    /// An estimate of the light that a surface receives.
    [[nodiscard]] float illuminance(const DistantReceiver& at) const;

    [[nodiscard]] std::optional<Sample> sample(const DistantReceiver& at,
                                               const Imath::V3f& random) const;
    [[nodiscard]] float pdf(const DistantReceiver& at, const Imath::V3f& direction) const;

    /// What reaches a point. `passed` tells how much light passes along a direction, from 0 to 1.
    [[nodiscard]] DistantProbe probe(
        const Imath::V3f& position, std::span<const Imath::V2f> random,
        const std::function<float(const Imath::V3f& to_light)>& passed) const;

private:
    // The illuminance of the environment and of a sun.
    [[nodiscard]] float of_environment(const DistantReceiver& at) const;
    [[nodiscard]] float of_sun(std::size_t sun, const DistantReceiver& at) const;

    /// A part of the samples goes to all lights evenly, since not all shadows are known, and the
    /// rest by the illuminance.
    class Shares {
    public:
        Shares(const DistantLights& lights, const DistantReceiver& at);
        [[nodiscard]] float operator()(float illuminance) const {
            return illuminance > 0.0F ? even_ + by_illuminance_ * illuminance : 0.0F;
        }

    private:
        float even_ = 0.0F;
        float by_illuminance_ = 0.0F;
    };

    [[nodiscard]] Imath::V3f sample_environment(const DistantReceiver& at,
                                                const Imath::V2f& random) const;
    [[nodiscard]] float pdf_of_environment(const DistantReceiver& at,
                                           const Imath::V3f& direction) const;
    [[nodiscard]] float pdf(const Shares& share, const DistantReceiver& at,
                            const Imath::V3f& direction) const;

    std::vector<Sun> suns_;
    std::optional<Environment::State> environment_;  // Only if it is not black.
    Imath::M33f environment_from_world_;             // Orthogonal.
    float environment_illuminance_ = 0.0F;           // Estimated: pi times the mean radiance.
    bool has_radiance_ = false;
};

}  // namespace balcony::render
