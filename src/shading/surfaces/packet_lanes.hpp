// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is computed for all rays of a packet together, in the widest registers of the machine. The
// results are the same on all machines, bit for bit.

#include <cstddef>
#include <span>

#include "balcony/rays.hpp"
#include "shading/geometry/ray.hpp"
#include "shading/surfaces/surface.hpp"

namespace balcony::render::packet_lanes {

/// Sets packets side by side to squares of the rays of a tile, which begin at ray `first` and whose
/// rows are `stride` apart; `valid` as traceable(). All have the same time.
void set_rays(const rays::RayBatch::Arrays& rays, std::size_t first, std::size_t stride, float time,
              std::span<embree::Packet> packets);

/// The differentials of the rays of a packet.
struct Differentials {
    LaneVectors origin_x, origin_y;
    LaneVectors direction_x, direction_y;

    [[nodiscard]] RayDifferentials of(std::size_t lane) const {
        return {origin_x.of(lane), origin_y.of(lane), direction_x.of(lane), direction_y.of(lane)};
    }
    void set(std::size_t lane, const RayDifferentials& from) {
        origin_x.set(lane, from.origin_x);
        origin_y.set(lane, from.origin_y);
        direction_x.set(lane, from.direction_x);
        direction_y.set(lane, from.direction_y);
    }
};

/// Sets the differentials of a packet whose rays were set by set_rays(): those of
/// render::differentials().
void set_differentials(const rays::RayBatch::FootprintArrays& footprints, std::size_t first,
                       std::size_t stride, double part, Differentials& differentials);

}  // namespace balcony::render::packet_lanes
