// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The data of the paths that a path tracer works at.

#include <cstdint>

#include "balcony/integrators.hpp"
#include "render/sampling/sample_block.hpp"
#include "render/tracing/scene_tracer.hpp"
#include "shading/lights/light_set.hpp"
#include "shading/materials/bsdf.hpp"
#include "shading/surfaces/surface.hpp"

namespace balcony::render {

/// How often the light of a path has been scattered by now.
struct Bounces {
    std::uint8_t all = 0;
    std::uint8_t diffuse = 0;
    std::uint8_t glossy = 0;
    std::uint8_t transmission = 0;

    bool operator==(const Bounces&) const = default;
};

/// Where a path has come to: shared_tails.hpp explains heads and tails.
enum class Part : std::uint8_t {
    head,     ///< On its way to the surface where its head ends.
    between,  ///< On its way from there to the surface where its tail begins.
    tail,     ///< At that surface.
    onward,   ///< Behind it.
    whole,    ///< Nowhere in particular: it shares no tail.
    guided,   ///< It is a guided path, or was one (guided paths: path_light.hpp).
};

/// A path in progress, from the camera.
struct Path {
    DifferentialRay ray;  ///< The one to trace next.
    embree::Hit hit;      ///< Where it ends.
    Color3f throughput{1.0F};
    V3f eye;                              ///< The origin of the camera ray.
    LitPoint from{V3f(0.0F), V3f(0.0F)};  ///< Where the light was scattered last.
    /// The density with which the ray's direction was chosen there. Panes that the ray has passed
    /// straight on do not change it, as shadow rays pass them, too. 0 if no other method of
    /// sampling finds it: the camera ray, or a mirror reflection.
    float pdf = 0.0F;
    /// Of the surfaces to come: where light has been scattered, a lamp in a mirror is softened.
    float least_roughness = 0.0F;
    bool is_softened = false;    ///< Such a surface was rougher than it is.
    bool is_clear = true;        ///< Only mirrors and clear glass have scattered its light.
    bool shows = true;           ///< So far, where most of the light of each comes from.
    std::uint8_t scattered = 0;  ///< How often it was scattered from the first other surface on.
    Color3f absorption{0.0F};    ///< Of what the ray passes, per scene unit.
    float absorbed = 0.0F;       ///< The length from there up to which light has been absorbed.
    Sampler sampler;
    std::uint32_t index = 0;   ///< Of its result.
    std::uint32_t packet = 0;  ///< Of its camera ray.
    Bounces bounces{};
    std::uint8_t crossings = 0;
    float transmittance = 1.0F;  ///< Of the surfaces crossed since the light was scattered last.
    /// The ray was chosen towards a lamp behind glass, and has not been scattered since.
    bool is_guided = false;
    /// The ray was chosen otherwise, at a surface from where guided ones start, too.
    bool may_be_guided = false;
    bool is_last = false;  ///< The ray only collects the light that is emitted where it ends.
    /// Not even that: it only tells whether it ends at a surface, whose light a limit cuts off.
    bool is_cut = false;
    Part part = Part::whole;
    /// From the tail on, the throughput up to there, and `throughput` counts from there.
    Color3f before_tail{1.0F};
};

/// Moves the ray of a path behind a surface that it passes by chance, because of its opacity.
void pass_through(Path& path, const Interaction& at);

/// Moves the ray of a path straight on behind a pane.
void pass_pane(Path& path, const Interaction& at);

/// Absorbs light between the place where it was scattered last and this one. The length is that
/// between the places, not from the ray's origin, which is next to the surface.
void absorb(Path& path, const V3f& position);

/// Counts a scattering. After the largest number of bounces a ray still collects the light of lamps
/// that it meets, for which sampling the lamps has left a part.
void count_bounce(Path& path, BsdfLobe lobe, const BounceLimits& limits);

/// Whether limits of diffuse or of glossy bounces are low, so that it matters which a bounce is.
[[nodiscard]] bool counts_by_surface(const BounceLimits& limits);

/// Light, or as much of it that its largest channel is the limit.
[[nodiscard]] Color3f limited(const Color3f& light, float limit);

/// The probability with which Russian roulette lets a path with this throughput go on. The root of
/// the light and not the light itself: the time that is saved by ending more paths is worth less
/// than the noise that it adds.
[[nodiscard]] float survival(const Color3f& throughput);

/// Russian roulette: a path that carries little light ends, or carries more.
/// Its light counts so many times.
[[nodiscard]] bool survives(Path& path, SampleReader& numbers, float factor = 1.0F);

}  // namespace balcony::render
