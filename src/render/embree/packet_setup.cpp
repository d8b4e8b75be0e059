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

namespace lanes = hwy::HWY_NAMESPACE;

void prepare(Packet& packet, float reach) {
    const lanes::CappedTag<float, Packet::size> tag;
    const lanes::RebindToSigned<decltype(tag)> integers;
    const lanes::RebindToUnsigned<decltype(tag)> numbers;
    const auto zero = lanes::Zero(tag);
    const auto one = lanes::Set(tag, 1.0F);
    const auto farthest_origin = lanes::Set(tag, reach);
    const auto largest = lanes::Set(tag, max_coordinate);
    const auto smallest = lanes::Set(tag, min_component);
    const auto nothing = lanes::Set(numbers, Hit::nothing);
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const auto load = [lane, tag](const Packet::Floats& values) {
            return lanes::Load(tag, values.data() + lane);
        };
        const auto time = load(packet.time);
        const auto farthest = load(packet.farthest);
        auto traceable = lanes::And(lanes::Ge(time, zero), lanes::Le(time, one));
        traceable = lanes::And(traceable, lanes::Ge(farthest, zero));
        traceable = lanes::And(
            traceable, lanes::RebindMask(tag, lanes::Ne(lanes::Load(integers, &packet.valid[lane]),
                                                        lanes::Zero(integers))));
        for (const Packet::Floats* origin :
             {&packet.origin_x, &packet.origin_y, &packet.origin_z}) {
            traceable =
                lanes::And(traceable, lanes::Le(lanes::Abs(load(*origin)), farthest_origin));
        }
        for (const Packet::Floats* direction :
             {&packet.direction_x, &packet.direction_y, &packet.direction_z}) {
            traceable = lanes::And(traceable, lanes::Le(lanes::Abs(load(*direction)), largest));
        }
        for (Packet::Floats* origin : {&packet.origin_x, &packet.origin_y, &packet.origin_z}) {
            lanes::Store(lanes::IfThenElseZero(traceable, load(*origin)), tag,
                         origin->data() + lane);
        }
        for (Packet::Floats* direction :
             {&packet.direction_x, &packet.direction_y, &packet.direction_z}) {
            const auto component = lanes::IfThenElse(traceable, load(*direction), one);
            const auto size = lanes::Max(lanes::Abs(component), smallest);
            lanes::Store(lanes::CopySign(size, component), tag, direction->data() + lane);
        }
        lanes::Store(lanes::IfThenElse(traceable, farthest, lanes::Neg(one)), tag,
                     packet.farthest.data() + lane);
        lanes::Store(lanes::IfThenElseZero(traceable, time), tag, packet.time.data() + lane);
        lanes::Store(zero, tag, packet.nearest.data() + lane);
        lanes::Store(nothing, numbers, packet.mask.data() + lane);
        lanes::Store(nothing, numbers, packet.geometry.data() + lane);
        lanes::Store(nothing, numbers, packet.placement.data() + lane);
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
