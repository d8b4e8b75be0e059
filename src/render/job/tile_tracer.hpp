// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Traces the rays of a tile.

#include <cstdint>
#include <memory>
#include <vector>

#include "render/integrators/integrator.hpp"
#include "render/job/picture_rays.hpp"

namespace balcony::render {

/// The points of a tile in one pass: a sample in each pixel of a region.
struct TilePoints {
    Region region;
    std::size_t pass = 0;
    PassNumbers numbers;
    rays::Tile grid;
    const std::vector<std::uint8_t>* active = nullptr;  ///< Points to sample; all if null.

    [[nodiscard]] std::size_t size() const { return region.size(); }
    [[nodiscard]] bool is_active(std::size_t i) const {
        return active == nullptr || (*active)[i] != 0;
    }
};

/// Traces rays; belongs to one thread.
class TileTracer {
public:
    TileTracer(const TracedScene& traced, const Settings& settings, IntegratorMaker make);

    /// Calls show(i, seen) with the result of each requested ray i. Radiance that is not finite is
    /// replaced by black.
    template <class Show>
    void trace(const TilePoints& points, const TileRays& rays, const Mask& wanted,
               const Show& show) {
        trace(points, rays, wanted);
        for (std::size_t k = 0; k < seen_.size(); ++k) {
            show(indices_[k], seen_[k]);
        }
    }

    /// Whether there is trace_light().
    [[nodiscard]] bool has_light_tracer() const { return light_tracer_ != nullptr; }
    /// The radiance of all rays that can be traced, as above, and 0 elsewhere. Sets `valid`.
    void trace_light(const Region& region, TileRays& rays, std::span<Color4f> radiance);

    /// The number of samples whose radiance was not finite.
    [[nodiscard]] std::uint64_t repaired() const { return repaired_; }

private:
    void trace(const TilePoints& points, const TileRays& rays, const Mask& wanted);
    // Replaces what is not finite by black.
    void repair(LightTracer::Lanes& colors);
    [[nodiscard]] Ray camera_ray(const TileRays& rays, std::size_t i) const;

    const TracedScene* traced_;
    double footprint_scale_;
    std::unique_ptr<Integrator> integrator_;
    LightTracer* light_tracer_;
    // The rays at work; kept for their memory.
    std::vector<embree::Hit> hits_;     // Of all points.
    std::vector<std::size_t> indices_;  // Of the requested points; the others are parallel to it.
    std::vector<CameraRay> requested_;
    std::vector<Seen> seen_;
    embree::Packet packet_;
    packet_lanes::Differentials differentials_;
    LightTracer::Lanes lanes_;
    std::uint64_t repaired_ = 0;
};

}  // namespace balcony::render
