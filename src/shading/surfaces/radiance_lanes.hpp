// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The radiances of the rays of a packet, and their way into a picture.

#include <cstddef>
#include <cstdint>

#include <Imath/ImathColor.h>

#include "shading/geometry/ray.hpp"
#include "shading/lanes/lane_arrays.hpp"

namespace balcony::render::surface_lanes {

struct alignas(64) Radiances {
    LaneVectors color;
    LaneFloats alpha{};

    void set(std::size_t lane, const Imath::Color4f& radiance) {
        color.set(lane, {radiance.r, radiance.g, radiance.b});
        alpha[lane] = radiance.a;
    }
};

/// The numbers of some lanes of a packet.
struct LaneCounts {
    std::size_t missing = 0;  ///< There is no ray.
    std::size_t shown = 0;    ///< Something is seen: alpha is above 0.
};

/// Writes the radiances of a packet as a square of colours whose rows are `stride` apart; black
/// where one is not finite, which is counted in `broken`. Other counts are of these lanes.
LaneCounts write(const embree::Packet& packet, const Radiances& radiances, LaneBits counted,
                 std::size_t stride, Imath::Color4f* to, std::uint64_t& broken);

}  // namespace balcony::render::surface_lanes
