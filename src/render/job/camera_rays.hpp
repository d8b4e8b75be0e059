// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The rays of a camera as input of the tracer, in floats.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <Imath/ImathVec.h>

#include "balcony/motion.hpp"
#include "balcony/rays.hpp"
#include "shading/surfaces/packet_lanes.hpp"

namespace balcony::render {

using Imath::V2f;
using Imath::V3d;

/// Whether there is a ray whose origin is within Embree's limits.
[[nodiscard]] bool traceable(const rays::RayBatch& rays, std::size_t i);
/// 0 where a parameter is not finite, or was not requested.
[[nodiscard]] V2f parameters(const rays::RayBatch& rays, std::size_t i);
/// The number of pixels per unit of length at a point of a straight part of the ray, on a plane
/// across it; the geometric mean over its directions. 0 without footprints, or where it is not
/// finite.
[[nodiscard]] float magnification(const rays::RayBatch& rays, std::size_t i, std::size_t part,
                                  const V3d& point);
/// The change of a straight part of the ray over a fraction of a pixel; 0 along x or y where it is
/// not finite.
[[nodiscard]] RayDifferentials differentials(const rays::RayBatch& rays, std::size_t i,
                                             std::size_t part, double fraction);

/// The points of a packet: a square of a tile of a width, from the point (left, top) on, or the
/// part of it within the tile.
struct Square {
    std::size_t width = 0;
    std::size_t left = 0;
    std::size_t top = 0;

    /// So many squares to the right.
    [[nodiscard]] Square beside(std::size_t number) const {
        return {width, left + number * embree::Packet::side, top};
    }
};

/// Calls visit(i, lane) for each ray of the square.
template <class Visit>
void for_each_ray(const rays::RayBatch& rays, const Square& square, const Visit& visit) {
    constexpr std::size_t side = embree::Packet::side;
    const std::size_t columns = std::min(square.width - square.left, side);
    const std::size_t rows = std::min(rays.size() / square.width - square.top, side);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            visit((square.top + row) * square.width + square.left + column, row * side + column);
        }
    }
}

/// Calls visit(square of the first one, packets) for the packets side by side that cover a tile, at
/// most so many at once as are given.
template <class Visit>
void for_each_run(std::size_t width, std::size_t height, std::span<embree::Packet> packets,
                  const Visit& visit) {
    constexpr std::size_t side = embree::Packet::side;
    for (std::size_t top = 0; top < height; top += side) {
        for (std::size_t left = 0; left < width; left += packets.size() * side) {
            const std::size_t number = std::min((width - left + side - 1) / side, packets.size());
            visit(Square{width, left, top}, packets.first(number));
        }
    }
}

/// Sets packets side by side, of which the first has this square; `valid` as traceable(). `time` is
/// that of all rays, unless they have their own times, which are from 0 to 1 over the interval.
void set_packets(const rays::RayBatch& rays, const Square& square,
                 const scene::TimeInterval& interval, float time,
                 std::span<embree::Packet> packets);

/// The straight parts at which the rays of a packet are, by lane.
using LaneParts = std::array<std::uint16_t, embree::Packet::size>;

/// Sets the differentials of the rays of a square over a fraction of a pixel; 0 without footprints.
/// `parts` matters only to bent rays.
void set_differentials(const rays::RayBatch& rays, const Square& square, const LaneParts& parts,
                       double fraction, packet_lanes::Differentials& differentials);

}  // namespace balcony::render
