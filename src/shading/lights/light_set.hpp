// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The lights of a scene: punctual lights, triangles that emit, and what is infinitely far away: an
// environment, and suns with an angular size. docs/lights.md describes how one is chosen.

#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "balcony/environment.hpp"
#include "balcony/motion.hpp"
#include "balcony/scene.hpp"
#include "shading/geometry/ray.hpp"
#include "shading/lights/punctual.hpp"

namespace balcony::render {

/// An illuminated point, and the direction to its viewer.
struct LitPoint {
    Imath::V3f position;      ///< World coordinates.
    Imath::V3f to_viewer;     ///< Unit.
    Imath::V3f normal{0.0F};  ///< Unit: only light from its side counts. 0: from all sides.
    float time = 0.0F;        ///< Of the ray to it: moving lights are where they are then.
};

/// Light that may arrive at a point along a random direction. The mean over all random numbers of
/// radiance / pdf, times any function of the direction, is the integral of the light from all
/// directions.
struct LightSample {
    Imath::V3f to_light;    ///< Unit.
    float distance = 0.0F;  ///< Infinite for the environment and suns; 0 for the light at the
                            ///< viewer, which casts no shadows.
    Imath::Color3f radiance{
        0};              ///< If delta: irradiance on a plane perpendicular to the direction.
    float pdf = 0.0F;    ///< By solid angle, times the probability of choosing this light.
                         ///< If delta: the probability alone.
    bool delta = false;  ///< No other way of sampling finds this direction.
    /// A point of an emissive triangle whose emission varies: the light is what the material emits
    /// there in this direction, times `radiance`. Nothing if `radiance` is all.
    embree::Hit emitter{};
};

class DistantLights;
struct DistantReceiver;
class DistantVisibility;
class TextureLibrary;

/// All lights of a scene, which must outlive the set. Copies share their data.
class LightSet {
public:
    /// The textures tell how strong emissive triangles are; without them, textures count as white.
    /// After a stop, the set is of no use.
    explicit LightSet(const scene::Scene& scene, const TextureLibrary* textures = nullptr,
                      const scene::Movement& movement = {}, const std::stop_token& stop = {});

    /// The same with an environment, and with another angular diameter of directional lights, in
    /// radians.
    [[nodiscard]] LightSet with(const std::optional<Environment>& environment,
                                const std::optional<double>& sun_angle = {}) const;

    /// The same with an estimate of what of the distant light reaches each place. It changes how
    /// lights are chosen.
    [[nodiscard]] LightSet with(std::shared_ptr<const DistantVisibility> visibility) const;
    /// Its probes are what such an estimate is made of.
    [[nodiscard]] const DistantLights& distant() const { return *distant_; }

    /// The same with a light at the viewer of each path, without falloff.
    [[nodiscard]] LightSet lit_from_eye() const;
    /// Otherwise LitPoint::to_viewer does not matter to sample().
    [[nodiscard]] bool are_at_eye() const { return lit_from_eye_; }

    [[nodiscard]] std::size_t emissive_triangles() const;

    // --------------------------------------------------------- one light at a time, at random

    /// Selects a light and a direction to it by three numbers in [0, 1). Nothing if no light
    /// arrives from what was selected.
    [[nodiscard]] std::optional<LightSample> sample(const LitPoint& point,
                                                    const Imath::V3f& random) const;

    /// The density of sample() in the direction of a point of a triangle that is visible from
    /// `point`; 0 if the triangle is never sampled.
    [[nodiscard]] float pdf_of_emitter(const LitPoint& point, const Imath::V3f& to_light,
                                       float distance, const embree::Hit& emitter) const;

    /// The radiance that a ray which leaves the scene meets: of the environment and of suns with an
    /// angular size.
    [[nodiscard]] Imath::Color3f radiance_from(const Imath::V3f& direction) const;

    /// The density of sample() for light from infinitely far away.
    [[nodiscard]] float pdf_of_distant(const LitPoint& point, const Imath::V3f& direction) const;

    /// Whether radiance_from() is not always 0.
    [[nodiscard]] bool has_distant() const;
    /// Whether there is an environment, which fills the background of the picture.
    [[nodiscard]] bool has_environment() const;

    // --------------------------------------------------- punctual lights and the default light

    /// Of the lights that arriving() knows.
    [[nodiscard]] std::size_t size() const;

    /// The light from one source, by index. Nothing from a source at the point itself.
    [[nodiscard]] Illumination arriving(std::size_t light, const LitPoint& point) const;

private:
    struct Finite;

    [[nodiscard]] float probability_of_distant(const LitPoint& point,
                                               const DistantReceiver& at) const;
    [[nodiscard]] std::optional<LightSample> sample_distant(const DistantReceiver& at,
                                                            const Imath::V3f& random) const;
    [[nodiscard]] DistantReceiver receiver(const LitPoint& point) const;
    [[nodiscard]] std::optional<LightSample> sample_finite(const LitPoint& point,
                                                           const Imath::V3f& random) const;

    const scene::Scene* scene_;
    std::shared_ptr<const Finite> finite_;
    std::shared_ptr<const DistantLights> distant_;
    std::shared_ptr<const DistantVisibility> visibility_;  // Null: not known.
    bool lit_from_eye_ = false;                            // And by nothing else.
};

}  // namespace balcony::render
