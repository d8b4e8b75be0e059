// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/surfaces/packet_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>
#include <limits>
#include <utility>

#include "shading/surfaces/packet_lanes.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::packet_lanes::HWY_NAMESPACE {

#include "shading/lanes/registers.inl"

using embree::Packet;

// As many doubles as a row of a packet has, or those of two packets, if registers have so many.
using Doubles = lanes::CappedTag<double, Packet::side>;
using WideDoubles = lanes::CappedTag<double, 2 * Packet::side>;

template <class D>
HWY_INLINE Number<D> load(const double* values) {
    return lanes::LoadU(D(), values);
}

// Stores the values of a row from a column on. If a register has those of two packets, each gets a
// half.
template <class D, class Value>
HWY_INLINE void store(Number<D> values, std::array<Value, Packet::size> Packet::*member,
                      std::size_t row, std::size_t column, Packet* packets) {
    constexpr std::size_t side = Packet::side;
    const lanes::Rebind<Value, D> tag_of_values;
    const auto converted = lanes::DemoteTo(tag_of_values, values.v);
    Value* const to = (packets[column / side].*member).data() + row * side + column % side;
#if HWY_TARGET != HWY_SCALAR
    if constexpr (lanes::MaxLanes(tag_of_values) > side) {
        const lanes::Half<decltype(tag_of_values)> half;
        lanes::Store(lanes::LowerHalf(half, converted), half, to);
        lanes::Store(lanes::UpperHalf(half, converted), half,
                     (packets[column / side + 1].*member).data() + row * side);
        return;
    }
#endif
    lanes::Store(converted, tag_of_values, to);
}

template <class D>
HWY_INLINE void set_part(const rays::RayBatch::Arrays& rays, std::size_t i, std::size_t row,
                         std::size_t column, Packet* packets) {
    constexpr std::array origins{&Packet::origin_x, &Packet::origin_y, &Packet::origin_z};
    constexpr std::array directions{&Packet::direction_x, &Packet::direction_y,
                                    &Packet::direction_z};
    Condition<D> traceable = load<D>(rays.valid + i) == 1.0;
    Number<D> square = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Number<D> origin = load<D>(rays.origin[axis] + i);
        const Number<D> direction = load<D>(rays.direction[axis] + i);
        traceable = both(traceable, absolute(origin) <= double{embree::max_coordinate});
        square = square + direction * direction;
        store(origin, origins[axis], row, column, packets);
        store(direction, directions[axis], row, column, packets);
    }
    traceable = both(traceable, absolute(square - 1.0) < 1e-6);
    store(or_zero(traceable, Number<D>(-1.0)), &Packet::valid, row, column, packets);
}

void set_rays(const rays::RayBatch::Arrays& rays, std::size_t first, std::size_t stride, float time,
              std::span<Packet> packets) {
    const std::size_t width = packets.size() * Packet::side;
    for (std::size_t row = 0; row < Packet::side; ++row) {
        const std::size_t i = first + row * stride;
        std::size_t column = 0;
        for (; column + lanes::Lanes(WideDoubles()) <= width;
             column += lanes::Lanes(WideDoubles())) {
            set_part<WideDoubles>(rays, i + column, row, column, packets.data());
        }
        for (; column < width; column += lanes::Lanes(Doubles())) {
            set_part<Doubles>(rays, i + column, row, column, packets.data());
        }
    }
    for (Packet& packet : packets) {
        packet.time.fill(time);
        packet.farthest.fill(std::numeric_limits<float>::infinity());
    }
}

void set_differentials(const rays::RayBatch::FootprintArrays& footprints, std::size_t first,
                       std::size_t stride, double part, Differentials& differentials) {
    using Arrays = std::array<const double*, 3>;
    const auto set = [part](std::size_t i, std::size_t lane, const Arrays& origin_by,
                            const Arrays& direction_by, LaneVectors& origin,
                            LaneVectors& direction) {
        const auto scaled = [&](const double* values) { return part * load<Doubles>(values + i); };
        const auto in_range = [&](const Arrays& from) {
            const auto is_small = [&](const double* values) {
                return absolute(scaled(values)) <= double{embree::max_coordinate};
            };
            return both(is_small(from[0]), both(is_small(from[1]), is_small(from[2])));
        };
        const Condition<Doubles> kept = both(in_range(origin_by), in_range(direction_by));
        const auto store_all = [&](const Arrays& from, LaneVectors& to) {
            const lanes::Rebind<float, Doubles> floats;
            for (const auto& [values, lane_floats] :
                 {std::pair(from[0], &to.x), {from[1], &to.y}, {from[2], &to.z}}) {
                lanes::Store(lanes::DemoteTo(floats, or_zero(kept, scaled(values)).v), floats,
                             lane_floats->data() + lane);
            }
        };
        store_all(origin_by, origin);
        store_all(direction_by, direction);
    };
    for (std::size_t row = 0; row < Packet::side; ++row) {
        for (std::size_t column = 0; column < Packet::side; column += lanes::Lanes(Doubles())) {
            const std::size_t i = first + row * stride + column;
            const std::size_t lane = row * Packet::side + column;
            set(i, lane, footprints.origin_by_x, footprints.direction_by_x, differentials.origin_x,
                differentials.direction_x);
            set(i, lane, footprints.origin_by_y, footprints.direction_by_y, differentials.origin_y,
                differentials.direction_y);
        }
    }
}

}  // namespace balcony::render::packet_lanes::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace balcony::render::packet_lanes {

HWY_EXPORT(set_rays);
HWY_EXPORT(set_differentials);

void set_rays(const rays::RayBatch::Arrays& rays, std::size_t first, std::size_t stride, float time,
              std::span<embree::Packet> packets) {
    HWY_DYNAMIC_DISPATCH(set_rays)(rays, first, stride, time, packets);
}

void set_differentials(const rays::RayBatch::FootprintArrays& footprints, std::size_t first,
                       std::size_t stride, double part, Differentials& differentials) {
    HWY_DYNAMIC_DISPATCH(set_differentials)(footprints, first, stride, part, differentials);
}

}  // namespace balcony::render::packet_lanes

#endif
