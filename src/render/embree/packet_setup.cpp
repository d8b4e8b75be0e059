// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/embree/packet_setup.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/embree/packet_setup.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::embree::HWY_NAMESPACE {

#include "shading/lanes/registers.inl"

HWY_INLINE Where within(const Float3& v, float limit) {
    const Float largest = limit;
    return both(largest >= absolute(v.x), both(largest >= absolute(v.y), largest >= absolute(v.z)));
}

// A component of a direction that is not lost.
HWY_INLINE Float kept(Float component) {
    return sign_of(component) * larger(absolute(component), min_component);
}

void prepare(Packet& packet, float reach) {
    const auto nothing = static_cast<std::int32_t>(Hit::nothing);
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const Float time = load(packet.time, lane);
        const Float farthest = load(packet.farthest, lane);
        const Float3 origin = load(packet.origin_x, packet.origin_y, packet.origin_z, lane);
        const Float3 direction =
            load(packet.direction_x, packet.direction_y, packet.direction_z, lane);
        const Where is_there = !(Int(lanes::Load(int_tag, &packet.valid[lane])) == 0);
        const Where traceable =
            both(both(is_there, farthest >= 0.0F),
                 both(both(time >= 0.0F, Float(1.0F) >= time),
                      both(within(origin, reach), within(direction, max_coordinate))));
        const Float3 along = select(traceable, direction, Float3{1.0F, 1.0F, 1.0F});
        store(or_zero(traceable, origin), packet.origin_x, packet.origin_y, packet.origin_z, lane);
        store(Float3{kept(along.x), kept(along.y), kept(along.z)}, packet.direction_x,
              packet.direction_y, packet.direction_z, lane);
        store(select(traceable, farthest, -1.0F), packet.farthest, lane);
        store(or_zero(traceable, time), packet.time, lane);
        store(Float(0.0F), packet.nearest, lane);
        store(Int(nothing), packet.mask, lane);
        store(Int(nothing), packet.geometry, lane);
        store(Int(nothing), packet.placement, lane);
    }
}

void prepare_all(Packet* packets, std::size_t count, float reach) {
    for (std::size_t k = 0; k < count; ++k) {
        prepare(packets[k], reach);
    }
}

}  // namespace balcony::render::embree::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace balcony::render::embree {

HWY_EXPORT(prepare_all);

void prepare(std::span<Packet> packets, float reach) {
    HWY_DYNAMIC_DISPATCH(prepare_all)(packets.data(), packets.size(), reach);
}

}  // namespace balcony::render::embree

#endif
