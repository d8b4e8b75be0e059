// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shading/packet_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>

#include "render/shading/packet_lanes.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::packet_lanes::HWY_NAMESPACE {

namespace lanes = hwy::HWY_NAMESPACE;

using embree::Packet;

void set_rays(const rays::RayBatch::Arrays& rays, std::size_t first, std::size_t stride,
              Packet& packet) {
    constexpr std::size_t side = Packet::side;
    const std::array origins{packet.origin_x.data(), packet.origin_y.data(),
                             packet.origin_z.data()};
    const std::array directions{packet.direction_x.data(), packet.direction_y.data(),
                                packet.direction_z.data()};
    const lanes::CappedTag<double, side> tag;
    const lanes::Rebind<float, decltype(tag)> floats;
    const lanes::Rebind<std::int32_t, decltype(tag)> integers;
    const auto one = lanes::Set(tag, 1.0);
    const auto limit = lanes::Set(tag, embree::max_coordinate);
    const auto tolerance = lanes::Set(tag, 1e-6);
    for (std::size_t row = 0; row < side; ++row) {
        for (std::size_t column = 0; column < side; column += lanes::Lanes(tag)) {
            const std::size_t i = first + row * stride + column;
            const std::size_t lane = row * side + column;
            auto traceable = lanes::Eq(lanes::LoadU(tag, rays.valid + i), one);
            auto square = lanes::Zero(tag);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto origin = lanes::LoadU(tag, rays.origin[axis] + i);
                const auto direction = lanes::LoadU(tag, rays.direction[axis] + i);
                traceable = lanes::And(traceable, lanes::Le(lanes::Abs(origin), limit));
                square = lanes::Add(square, lanes::Mul(direction, direction));
                lanes::Store(lanes::DemoteTo(floats, origin), floats, origins[axis] + lane);
                lanes::Store(lanes::DemoteTo(floats, direction), floats, directions[axis] + lane);
            }
            traceable =
                lanes::And(traceable, lanes::Lt(lanes::Abs(lanes::Sub(square, one)), tolerance));
            const auto flags = lanes::IfThenElseZero(traceable, lanes::Set(tag, -1.0));
            lanes::Store(lanes::DemoteTo(integers, flags), integers, packet.valid.data() + lane);
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
                         const Arrays& direction_by, Differentials::Vectors& origin,
                         Differentials::Vectors& direction) {
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
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto store = [&](const double* from, Packet::Floats& to) {
                const auto value = lanes::IfThenElseZero(in_range, scaled(from));
                lanes::Store(lanes::DemoteTo(floats, value), floats, to.data() + lane);
            };
            store(origin_by[axis], origin[axis]);
            store(direction_by[axis], direction[axis]);
        }
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

// The normal for shading is on the side of the geometric normal that faces the viewer, and just
// above the horizon if it faces away from the viewer.
void set_cosines(const Packet& packet, const Normals& normals, Packet::Floats& cosines) {
    using Vectors = std::array<const float*, 3>;
    const Vectors direction{packet.direction_x.data(), packet.direction_y.data(),
                            packet.direction_z.data()};
    const Vectors flat_normal{normals.flat_x.data(), normals.flat_y.data(), normals.flat_z.data()};
    const Vectors smooth_normal{normals.smooth_x.data(), normals.smooth_y.data(),
                                normals.smooth_z.data()};
    const lanes::CappedTag<float, Packet::size> tag;
    const auto zero = lanes::Zero(tag);
    const auto one = lanes::Set(tag, 1.0F);
    const auto min_cosine = lanes::Set(tag, 1e-3F);
    const auto dot = [&](const Vectors& a, const Vectors& b, std::size_t lane) {
        auto sum = zero;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            sum = lanes::Add(sum, lanes::Mul(lanes::Load(tag, a[axis] + lane),
                                             lanes::Load(tag, b[axis] + lane)));
        }
        return sum;
    };
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const auto has_normal = lanes::Gt(dot(smooth_normal, smooth_normal, lane), zero);
        const auto smooth_length = lanes::Sqrt(
            lanes::IfThenElse(has_normal, dot(smooth_normal, smooth_normal, lane), one));
        const auto towards = lanes::Div(dot(smooth_normal, direction, lane), smooth_length);
        // Negative where the two normals are on different sides of the triangle as the ray sees it.
        const auto flat_cosine = dot(flat_normal, direction, lane);
        const auto sides = lanes::Xor(dot(flat_normal, smooth_normal, lane), flat_cosine);
        const auto cosine = lanes::IfNegativeThenElse(sides, lanes::Neg(towards), towards);

        const auto missing = lanes::Sub(min_cosine, cosine);
        const auto bent_square =
            lanes::Add(one, lanes::Mul(missing, lanes::Add(lanes::Add(cosine, cosine), missing)));
        const auto bent = lanes::Div(min_cosine, lanes::Sqrt(bent_square));
        const auto smooth = lanes::IfThenElse(lanes::Ge(cosine, min_cosine), cosine, bent);
        if (lanes::AllTrue(tag, has_normal)) {
            lanes::Store(smooth, tag, cosines.data() + lane);
            continue;
        }

        // The normal of a small triangle is too short to be squared.
        auto size = zero;
        for (const float* component : flat_normal) {
            size = lanes::Max(size, lanes::Abs(lanes::Load(tag, component + lane)));
        }
        auto flat_square = zero;
        for (const float* component : flat_normal) {
            const auto part = lanes::Div(lanes::Load(tag, component + lane), size);
            flat_square = lanes::Add(flat_square, lanes::Mul(part, part));
        }
        const auto flat =
            lanes::Div(lanes::Abs(flat_cosine), lanes::Mul(size, lanes::Sqrt(flat_square)));
        lanes::Store(lanes::IfThenElse(has_normal, smooth, flat), tag, cosines.data() + lane);
    }
}

}  // namespace balcony::render::packet_lanes::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace balcony::render::packet_lanes {

HWY_EXPORT(set_rays);
HWY_EXPORT(set_differentials);
HWY_EXPORT(set_cosines);

void Differentials::set(std::size_t lane, const RayDifferentials& from) {
    const auto store = [lane](const V3f& vector, Vectors& to) {
        for (int axis = 0; axis < 3; ++axis) {
            to[static_cast<std::size_t>(axis)][lane] = vector[axis];
        }
    };
    store(from.origin_x, origin_x);
    store(from.origin_y, origin_y);
    store(from.direction_x, direction_x);
    store(from.direction_y, direction_y);
}

void set_rays(const rays::RayBatch::Arrays& rays, std::size_t first, std::size_t stride,
              embree::Packet& packet) {
    HWY_DYNAMIC_DISPATCH(set_rays)(rays, first, stride, packet);
}

void set_differentials(const rays::RayBatch::FootprintArrays& footprints, std::size_t first,
                       std::size_t stride, double part, Differentials& differentials) {
    HWY_DYNAMIC_DISPATCH(set_differentials)(footprints, first, stride, part, differentials);
}

void set_cosines(const embree::Packet& packet, const Normals& normals,
                 embree::Packet::Floats& cosines) {
    HWY_DYNAMIC_DISPATCH(set_cosines)(packet, normals, cosines);
}

}  // namespace balcony::render::packet_lanes

#endif
