// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Traces the rays of a tile.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/integrators/integrator.hpp"
#include "render/job/light_levels.hpp"
#include "render/job/picture_rays.hpp"
#include "render/sampling/pixel_groups.hpp"

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
    /// The scene, settings and levels must outlive it.
    TileTracer(const TracedScene& traced, const Settings& settings, const IntegratorRow& integrator,
               const LightLevels& levels);

    /// Calls show(i, seen, part) with the result of each requested ray i that can be traced, and
    /// the straight part of the ray that met the scene first. Radiance that is not finite is
    /// replaced by black.
    template <class Show>
    void trace(const TilePoints& points, const TileRays& rays, const Mask& wanted,
               const Show& show) {
        trace(points, rays, wanted);
        for (std::size_t k = 0; k < seen_.size(); ++k) {
            show(indices_[k], seen_[k], seen_parts_[k]);
        }
    }

    /// Whether there is trace_light().
    [[nodiscard]] bool has_light_tracer() const { return light_tracer_ != nullptr; }
    /// The radiance of all rays that can be traced, as above, and 0 elsewhere. Counts the rays in
    /// the region `counted`.
    RayCounts trace_light(const Region& region, const Region& counted, const TileRays& rays,
                          std::span<Color4f> radiance);

    /// The number of samples whose radiance was not finite.
    [[nodiscard]] std::uint64_t repaired() const { return repaired_; }

private:
    void trace(const TilePoints& points, const TileRays& rays, const Mask& wanted);
    // Traces packets of straight rays, or one straight part after another of bent ones: the packets
    // then have the parts that hit something. `first` is the square of the first packet.
    void intersect(const TileRays& rays, const Square& first, std::span<embree::Packet> packets);
    // Traces straight rays or parts. What they pass gives way to what is behind: objects that they
    // start in, and for bent rays what is transparent, as integrators would go straight on there.
    void intersect(std::span<embree::Packet> packets, const ShownObjects& shown, bool bent) const;
    // The rays of a packet that pass their hits, and what they become behind them; their length is
    // what is left of theirs.
    LaneBits set_beyond(const embree::Packet& packet, bool bent, embree::Packet& beyond,
                        embree::Packet::Floats& lengths) const;
    // Writes a packet, which has a square of the region.
    surface_lanes::LaneCounts write_square(const Region& region, const Region& counted,
                                           std::size_t left, std::size_t top, std::size_t packet,
                                           std::span<Color4f> radiance);
    // Requests the rays of a packet with their first hits.
    void request(const TilePoints& points, const TileRays& rays, const Square& square,
                 const embree::Packet& packet, const LaneParts& parts, std::uint32_t number,
                 const PixelGroups& groups);

    const TracedScene* traced_;
    const LightLevels* levels_;
    float clamp_;  // Of all indirect light.
    double footprint_scale_;
    std::unique_ptr<Integrator> integrator_;
    LightTracer* light_tracer_;
    std::vector<bool> passed_;  // By object; empty if none is.
    // The rays at work; kept for their memory.
    std::vector<std::size_t> indices_;  // Of the requested points; the others are parallel to it.
    std::vector<std::uint16_t> seen_parts_;  // Of their rays.
    std::vector<CameraRay> requested_;
    std::vector<Seen> seen_;
    // Packets side by side.
    static constexpr std::size_t packets_at_once = 4;
    std::array<embree::Packet, packets_at_once> packets_;
    std::array<LaneParts, packets_at_once> parts_{};    // Of bent rays; otherwise 0.
    std::array<embree::Packet, packets_at_once> work_;  // Straight parts of bent rays.
    std::array<surface_lanes::Radiances, packets_at_once> radiances_;
    packet_lanes::Differentials differentials_;
    std::uint64_t repaired_ = 0;
};

}  // namespace balcony::render
