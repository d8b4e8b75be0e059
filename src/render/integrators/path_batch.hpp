// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The paths of a tile, which advance together, bounce by bounce: Áfra et al., "Local Shading
// Coherence Extraction for SIMD-Efficient Path Tracing on CPUs" (HPG 2016).

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/integrators/integrator.hpp"
#include "render/integrators/path_state.hpp"
#include "render/integrators/ray_order.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// Requests the memory of an object that is needed soon.
template <class T>
void prefetch(const T& object) {
    constexpr std::size_t cache_line = 64;
    for (std::size_t offset = 0; offset < sizeof(T); offset += cache_line) {
        __builtin_prefetch(reinterpret_cast<const char*>(&object) + offset);
    }
}

/// Keeps its memory between batches of camera rays.
class PathBatch {
public:
    void generate(std::span<const CameraRay> rays, Part part);

    /// Adds a path whose ray is to be traced.
    void add(const Path& path) {
        active_.push_back(static_cast<std::uint32_t>(paths_.size()));
        paths_.push_back(path);
    }

    [[nodiscard]] bool empty() const { return active_.empty(); }
    /// The number of paths that go on.
    [[nodiscard]] std::size_t size() const { return active_.size(); }
    [[nodiscard]] Path& operator[](std::size_t i) { return paths_[active_[i]]; }
    /// The path so many places after another, or the last one.
    [[nodiscard]] const Path& ahead(std::size_t i, std::size_t steps) const {
        return paths_[active_[std::min(i + steps, active_.size() - 1)]];
    }

    /// Calls advance(first, count) for one block of paths after another. It returns the lanes of
    /// those that go on; the others end.
    template <class Advance>
    void advance_blocks(const Advance& advance) {
        std::size_t kept = 0;
        for (std::size_t first = 0; first < active_.size(); first += lane_count) {
            const std::size_t count = std::min(lane_count, active_.size() - first);
            for_each_lane(advance(first, count),
                          [&](std::size_t lane) { active_[kept++] = active_[first + lane]; });
        }
        active_.resize(kept);
    }

    /// Finds where the rays end, in an order in which neighbours are similar. Afterwards neighbours
    /// meet the same instance. Those that come straight from the camera meet what is shown.
    void intersect(const SceneTracer& tracer, const ShownObjects& shown);

private:
    std::vector<Path> paths_;
    std::vector<std::uint32_t> active_;  // Indices of the paths that go on.
    std::vector<std::uint32_t> unordered_;
    std::vector<RayOrder::Key> keys_;
    RayOrder order_;
};

}  // namespace balcony::render
