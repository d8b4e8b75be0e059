// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The interface of integrators, which compute the radiance along a ray.

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "balcony/render.hpp"
#include "film/sums/tile_image.hpp"
#include "render/embree/accelerator.hpp"
#include "render/sampling/sampler.hpp"
#include "render/tracing/scene_tracer.hpp"
#include "render/tracing/shown_objects.hpp"
#include "shading/surfaces/packet_lanes.hpp"
#include "shading/surfaces/surface_lanes.hpp"

namespace balcony::render {

/// The result of tracing a ray.
struct Seen {
    Color4f radiance{0.0F};  ///< Premultiplied.
    Color4f mirrored{0.0F};  ///< The factors of the background in mirrors, by colour.
    LightParts parts;        ///< Of the radiance.
    float softened = 0.0F;   ///< The luminance that came by way of softened mirrors or glass.
    float left_out = 0.0F;   ///< The luminance that limits have left out.
    /// The luminance of what of one unit of light a limit of bounces cuts off.
    float cut = 0.0F;
    VisibleSurface visible;
    VisibleSurface shown;  ///< The same, or what a mirror or clear glass shows instead of itself.
    /// Where the ray ends that has passed surfaces because of their opacity; nothing if it meets
    /// none. If a ray is divided at such surfaces, it is the first one.
    std::optional<V3f> end{};
    Coverage coverage;  ///< Of all that is seen directly.
};

/// A ray of the camera with its first hit, and the random numbers of its pixel and pass.
struct CameraRay {
    DifferentialRay ray;
    embree::Hit first;
    Sampler sampler;
    std::uint32_t packet = 0;  ///< Rays of a packet are neighbours in the picture, and in a batch.
    std::uint32_t group = 0;   ///< The paths of a group may share what they find.
    /// Of what a path finds at once of indirect light, in each channel.
    float limit = std::numeric_limits<float>::infinity();
};

/// The differentials of packets of camera rays, which are computed on request.
class DifferentialSource {
public:
    virtual ~DifferentialSource() = default;
    /// Those of a packet by its number, until those of another are requested.
    [[nodiscard]] virtual const packet_lanes::Differentials& of_packet(std::size_t packet) = 0;
};

/// Whether rays that leave the scene show the environment.
[[nodiscard]] inline bool shows_environment(const TracedScene& traced, const Settings& settings) {
    return traced.lights.has_environment() && !settings.background && settings.light.visible;
}

/// A faster way to the radiance alone, for integrators without random numbers.
class LightTracer {
public:
    virtual ~LightTracer() = default;
    /// The radiances of packets of camera rays with their first hits: that of Integrator::trace(),
    /// up to rounding errors; 0 where there is no ray.
    virtual void trace_light(std::span<const embree::Packet> packets,
                             DifferentialSource& differentials,
                             std::span<surface_lanes::Radiances> radiances) = 0;
};

/// Belongs to one thread.
class Integrator {
public:
    virtual ~Integrator() = default;

    /// The radiance of each ray, usually those of a tile and a pass. It depends on no other rays
    /// than those of its group. At most PixelGroups::size rays have the same group. Behind their
    /// first hits, the rays meet what is shown until they are reflected or refracted.
    virtual void trace(std::span<const CameraRay> rays, const ShownObjects& shown,
                       std::span<Seen> seen) = 0;

    /// Null if there is no faster way.
    [[nodiscard]] virtual LightTracer* light_tracer() { return nullptr; }
};

/// A row of the table in integrators.cpp. A new integrator needs a file with a class and its row's
/// functions, and the row; its settings are declared in balcony/integrators.hpp.
struct IntegratorRow {
    IntegratorInfo info;
    /// The scene and the settings must outlive the integrator.
    std::unique_ptr<Integrator> (*make)(const TracedScene& traced, const Settings& settings);
    /// The errors of its own settings; null if there are none.
    Diagnostics (*check)(const Settings& settings) = nullptr;
    /// Whether it shows something in a scene as a mirror, which reflects the background; null if it
    /// never does.
    bool (*shows_mirrors)(const scene::Scene& scene) = nullptr;
    /// Whether it finds the light of an environment, so that ambient light is one.
    bool traces_environment = false;
};

/// The row of an integrator by its name; null if there is none.
[[nodiscard]] const IntegratorRow* find_integrator(std::string_view name);

}  // namespace balcony::render
