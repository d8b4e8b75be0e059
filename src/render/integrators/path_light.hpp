// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where the light that paths find goes: to the result of the path itself, or to a tail that the
// paths of its group share (shared_tails.hpp).

#include <cstddef>
#include <span>

#include "render/integrators/integrator.hpp"
#include "render/integrators/path_block.hpp"
#include "render/integrators/path_state.hpp"
#include "render/integrators/shadow_rays.hpp"
#include "render/integrators/shared_tails.hpp"

namespace balcony::render {

class PathLight {
public:
    /// The settings must outlive it.
    PathLight(const TracedScene& traced, const PathSettings& settings)
        : settings_(&settings), shares_(SharedTails::can_share(traced, settings)) {}

    /// Of the paths of these rays.
    void begin(std::span<const CameraRay> rays, std::span<Seen> seen);
    [[nodiscard]] Part first_part() const { return shares_ ? Part::head : Part::whole; }
    [[nodiscard]] Seen& seen(const Path& path) { return seen_[path.index]; }

    /// Light that the path's ray brings.
    void add(const Path& path, const Color3f& light);
    /// Light that arrives along a shadow ray, if nothing is in its way.
    void add(const Path& path, const embree::Ray& shadow_ray, const Color3f& light) {
        shadow_rays_.add({shadow_ray, light, path.index, path.packet, path.bounces.all == 0,
                          path.part, path.is_softened});
    }
    /// What a path receives of the light that arrives from a lamp: what is reflected, but all at a
    /// tail, which remembers what it reflects towards its own head.
    [[nodiscard]] Color3f received(const Path& path, const ArrivingLight& lamp);
    void trace_shadow_rays(const SceneTracer& tracer);

    /// At a surface that scatters light, before its next ray is chosen.
    void end_head(PathBlock& block, std::size_t lane);
    /// After add() of the light that the surface emits.
    void begin_tail(PathBlock& block, std::size_t lane);
    /// Multiplies the throughput by what the sample reflects.
    void scatter(Path& path, const BsdfSample& sample, bool passes_pane);

    /// After all paths have ended.
    void share_tails(const SceneTracer& tracer);

private:
    void add_scattered(Seen& seen, const Color3f& light, std::size_t bounces, bool softened) const;
    void add_onward(std::uint32_t index, const Color3f& light, bool softened);
    void go_on_from_tail(Path& path, const BsdfSample& sample);

    const PathSettings* settings_;
    bool shares_;
    std::span<Seen> seen_;
    ShadowRays shadow_rays_;
    SharedTails tails_;
};

}  // namespace balcony::render
