// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sixteen values that are computed together, by lane: those of the rays of a packet, or of the
// places of a block of paths.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <Imath/ImathVec.h>

namespace balcony::render {

inline constexpr std::size_t lane_count = 16;

/// Lane i is bit i.
using LaneBits = std::uint32_t;
inline constexpr LaneBits all_lanes = (LaneBits{1} << lane_count) - 1;

[[nodiscard]] constexpr LaneBits lane_bit(std::size_t lane) { return LaneBits{1} << lane; }

/// Calls visit(lane).
template <class Visit>
void for_each_lane(LaneBits lanes, const Visit& visit) {
    for (; lanes != 0; lanes &= lanes - 1) {
        visit(static_cast<std::size_t>(std::countr_zero(lanes)));
    }
}

using LaneFloats = std::array<float, lane_count>;
using LaneNumbers = std::array<std::uint32_t, lane_count>;

struct alignas(64) LanePairs {
    LaneFloats x{}, y{};

    [[nodiscard]] Imath::V2f of(std::size_t lane) const { return {x[lane], y[lane]}; }
    void set(std::size_t lane, const Imath::V2f& v) {
        x[lane] = v.x;
        y[lane] = v.y;
    }
};

struct alignas(64) LaneVectors {
    LaneFloats x{}, y{}, z{};

    [[nodiscard]] Imath::V3f of(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
    void set(std::size_t lane, const Imath::V3f& v) {
        x[lane] = v.x;
        y[lane] = v.y;
        z[lane] = v.z;
    }
    /// In a range of lanes.
    void fill(std::size_t first, std::size_t count, const Imath::V3f& v) {
        std::fill_n(x.begin() + first, count, v.x);
        std::fill_n(y.begin() + first, count, v.y);
        std::fill_n(z.begin() + first, count, v.z);
    }
};

}  // namespace balcony::render
