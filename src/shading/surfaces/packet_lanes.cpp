// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/surfaces/packet_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>

#include "shading/surfaces/packet_lanes.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::packet_lanes::HWY_NAMESPACE {

namespace lanes = hwy::HWY_NAMESPACE;

using embree::Packet;

using Floats = Packet::Floats Packet::*;
using Integers = std::array<std::int32_t, Packet::size> Packet::*;

// Stores the values of a row from a column on. If a register has those of two packets, each gets a
// half.
template <class Tag, class Vector, class Member>
HWY_INLINE void store(Tag tag, Vector values, Member member, std::size_t row, std::size_t column,
                      Packet* packets) {
    constexpr std::size_t side = Packet::side;
    auto* const to = (packets[column / side].*member).data() + row * side + column % side;
#if HWY_TARGET != HWY_SCALAR
    if constexpr (lanes::MaxLanes(tag) > side) {
        const lanes::Half<Tag> half;
        lanes::Store(lanes::LowerHalf(half, values), half, to);
        lanes::Store(lanes::UpperHalf(half, values), half,
                     (packets[column / side + 1].*member).data() + row * side);
        return;
    }
#endif
    lanes::Store(values, tag, to);
}

template <class Tag>
HWY_INLINE void set_part(Tag tag, const rays::RayBatch::Arrays& rays, std::size_t i,
                         std::size_t row, std::size_t column, Packet* packets) {
    constexpr std::array<Floats, 3> origins{&Packet::origin_x, &Packet::origin_y,
                                            &Packet::origin_z};
    constexpr std::array<Floats, 3> directions{&Packet::direction_x, &Packet::direction_y,
                                               &Packet::direction_z};
    constexpr Integers valid = &Packet::valid;
    const lanes::Rebind<float, Tag> floats;
    const lanes::Rebind<std::int32_t, Tag> integers;
    const auto one = lanes::Set(tag, 1.0);
    const auto limit = lanes::Set(tag, embree::max_coordinate);
    auto traceable = lanes::Eq(lanes::LoadU(tag, rays.valid + i), one);
    auto square = lanes::Zero(tag);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto origin = lanes::LoadU(tag, rays.origin[axis] + i);
        const auto direction = lanes::LoadU(tag, rays.direction[axis] + i);
        traceable = lanes::And(traceable, lanes::Le(lanes::Abs(origin), limit));
        square = lanes::Add(square, lanes::Mul(direction, direction));
        store(floats, lanes::DemoteTo(floats, origin), origins[axis], row, column, packets);
        store(floats, lanes::DemoteTo(floats, direction), directions[axis], row, column, packets);
    }
    traceable = lanes::And(traceable,
                           lanes::Lt(lanes::Abs(lanes::Sub(square, one)), lanes::Set(tag, 1e-6)));
    const auto flags = lanes::IfThenElseZero(traceable, lanes::Set(tag, -1.0));
    store(integers, lanes::DemoteTo(integers, flags), valid, row, column, packets);
}

void set_rays(const rays::RayBatch::Arrays& rays, std::size_t first, std::size_t stride, float time,
              std::span<Packet> packets) {
    constexpr std::size_t side = Packet::side;
    const lanes::CappedTag<double, 2 * side> tag;
    const lanes::CappedTag<double, side> tag_of_one;
    const std::size_t width = packets.size() * side;
    for (std::size_t row = 0; row < side; ++row) {
        const std::size_t i = first + row * stride;
        std::size_t column = 0;
        for (; column + lanes::Lanes(tag) <= width; column += lanes::Lanes(tag)) {
            set_part(tag, rays, i + column, row, column, packets.data());
        }
        for (; column < width; column += lanes::Lanes(tag_of_one)) {
            set_part(tag_of_one, rays, i + column, row, column, packets.data());
        }
    }
    const lanes::CappedTag<float, Packet::size> floats;
    for (Packet& packet : packets) {
        for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(floats)) {
            lanes::Store(lanes::Set(floats, time), floats, packet.time.data() + lane);
            lanes::Store(lanes::Inf(floats), floats, packet.farthest.data() + lane);
        }
    }
}

void set_differentials(const rays::RayBatch::FootprintArrays& footprints, std::size_t first,
                       std::size_t stride, double part, Differentials& differentials) {
    using Arrays = std::array<const double*, 3>;
    constexpr std::size_t side = Packet::side;
    const lanes::CappedTag<double, side> tag;
    const lanes::Rebind<float, decltype(tag)> floats;
    const auto scale = lanes::Set(tag, part);
    const auto limit = lanes::Set(tag, embree::max_coordinate);
    const auto set = [&](std::size_t i, std::size_t lane, const Arrays& origin_by,
                         const Arrays& direction_by, LaneVectors& origin, LaneVectors& direction) {
        const auto scaled = [&](const double* values) {
            return lanes::Mul(scale, lanes::LoadU(tag, values + i));
        };
        auto in_range = lanes::Le(lanes::Abs(scaled(origin_by[0])), limit);
        const auto check = [&](const double* values) {
            in_range = lanes::And(in_range, lanes::Le(lanes::Abs(scaled(values)), limit));
        };
        check(origin_by[1]);
        check(origin_by[2]);
        for (const double* values : direction_by) {
            check(values);
        }
        const auto store = [&](const double* from, LaneFloats& to) {
            const auto value = lanes::IfThenElseZero(in_range, scaled(from));
            lanes::Store(lanes::DemoteTo(floats, value), floats, to.data() + lane);
        };
        const auto store_all = [&](const Arrays& from, LaneVectors& to) {
            store(from[0], to.x);
            store(from[1], to.y);
            store(from[2], to.z);
        };
        store_all(origin_by, origin);
        store_all(direction_by, direction);
    };
    for (std::size_t row = 0; row < side; ++row) {
        for (std::size_t column = 0; column < side; column += lanes::Lanes(tag)) {
            const std::size_t i = first + row * stride + column;
            const std::size_t lane = row * side + column;
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
