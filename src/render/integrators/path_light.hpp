// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where the light that paths find goes: to the result of the path itself, or to a tail that the
// paths of its group share (shared_tails.hpp).
//
// Guided paths find lamps behind glass: where a shadow ray ends at glass, and nothing but glass is
// on its way, a path goes there, and through the glass as any other. Other paths find the same
// light by chance. A direction is sampled with the density of lamps by the ones and with that of
// the surface by the others, and multiple importance sampling (Veach 1997) weighs both.

#include <cstddef>
#include <span>
#include <vector>

#include "render/integrators/integrator.hpp"
#include "render/integrators/path_batch.hpp"
#include "render/integrators/path_block.hpp"
#include "render/integrators/path_state.hpp"
#include "render/integrators/shadow_rays.hpp"
#include "render/integrators/shared_tails.hpp"

namespace balcony::render {

class PathLight {
public:
    PathLight(const TracedScene& traced, const PathSettings& settings)
        : bounces_(settings.bounces), shares_(SharedTails::can_share(traced, settings)) {}

    /// Of the paths of these rays, which must stay until the end.
    void begin(std::span<const CameraRay> rays, std::span<Seen> seen);
    [[nodiscard]] Part first_part() const { return shares_ ? Part::head : Part::whole; }
    /// The result of a path that is not a guided one.
    [[nodiscard]] Seen& seen(const Path& path) { return seen_[path.index]; }

    /// A limit of bounces ends the path where others would go on.
    void cut(const Path& path) const;
    /// Light that the path's ray brings.
    void add(const Path& path, const Color3f& light);
    /// Light that arrives along a shadow ray, if nothing is in its way. If glass is, a guided path
    /// may find it: one of its own, which starts at the path's surface.
    void add(const Path& path, const embree::Ray& shadow_ray, const Color3f& light,
             const Path* guided = nullptr);
    /// What a path receives of the light that arrives from a lamp: what is reflected, but all at a
    /// tail, which remembers what it reflects towards its own head.
    [[nodiscard]] Color3f received(const Path& path, const ArrivingLight& lamp);
    /// Guided paths begin among the others.
    void trace_shadow_rays(const SceneTracer& tracer, PathBatch& paths);

    /// At a surface that scatters light, before its next ray is chosen; with its place as
    /// PatchGuide::place().
    void end_head(PathBlock& block, std::size_t lane, const BrightPatches::Place* place);
    /// After add() of the light that the surface emits.
    void begin_tail(PathBlock& block, std::size_t lane);
    /// Multiplies the throughput by what the sample reflects.
    void scatter(Path& path, const BsdfSample& sample, bool passes_pane);

    /// After all paths have ended.
    void finish(const SceneTracer& tracer);

private:
    // What a guided path finds is added at the end, so that the order of paths does not matter.
    struct Guided {
        std::uint32_t index;  // Of the result or tail, as of the path from which it branches off.
        Part part;            // Likewise.
        Color3f light{0.0F};
        bool is_softened = false;
    };

    // How light has come to the camera.
    struct Way {
        std::size_t bounces;
        bool indirect;  // To the first surface that is not clear by way of another.
        bool softened;
    };

    void add(Part part, std::uint32_t index, const Color3f& light, const Way& way);
    void add_scattered(std::uint32_t index, const Color3f& light, const Way& way) const;
    void start(Path& guided, PathBatch& paths);
    void go_on_from_tail(Path& path, const BsdfSample& sample);

    BounceLimits bounces_;
    bool shares_;
    std::span<const CameraRay> rays_;
    std::span<Seen> seen_;
    ShadowRays shadow_rays_;
    SharedTails tails_;
    std::vector<Path> waiting_;  // That shadow rays may start.
    std::vector<Guided> guided_;
};

}  // namespace balcony::render
