// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/surfaces/radiance_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>

#include "shading/surfaces/radiance_lanes.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::surface_lanes::HWY_NAMESPACE {

namespace lanes = hwy::HWY_NAMESPACE;

using embree::Packet;

using Tag = lanes::CappedTag<float, Packet::size>;
using IntegerTag = lanes::RebindToSigned<Tag>;
using Vector = lanes::Vec<Tag>;
using Mask = lanes::Mask<Tag>;
constexpr Tag tag;
constexpr IntegerTag integers;

LaneCounts write(const Packet& packet, const Radiances& radiances, LaneBits counted,
                 std::size_t stride, Imath::Color4f* to, std::uint64_t& broken) {
    alignas(64) std::array<Imath::Color4f, Packet::size> colors;
    LaneCounts counts;
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const Vector red = lanes::Load(tag, radiances.red.data() + lane);
        const Vector green = lanes::Load(tag, radiances.green.data() + lane);
        const Vector blue = lanes::Load(tag, radiances.blue.data() + lane);
        const Vector alpha = lanes::Load(tag, radiances.alpha.data() + lane);
        const Mask finite = lanes::And(lanes::And(lanes::IsFinite(red), lanes::IsFinite(green)),
                                       lanes::And(lanes::IsFinite(blue), lanes::IsFinite(alpha)));
        const auto shown = [&](Vector value) { return lanes::IfThenElseZero(finite, value); };
        lanes::StoreInterleaved4(shown(red), shown(green), shown(blue), shown(alpha), tag,
                                 &colors[lane].r);
        broken += lanes::CountTrue(tag, lanes::Not(finite));
        const std::uint32_t rest = counted >> lane;
        const std::uint8_t bits[8]{static_cast<std::uint8_t>(rest),
                                   static_cast<std::uint8_t>(rest >> 8U)};
        const Mask counts_here = lanes::LoadMaskBits(tag, bits);
        const Mask visible = lanes::Gt(shown(alpha), lanes::Zero(tag));
        counts.shown += lanes::CountTrue(tag, lanes::And(counts_here, visible));
        const Mask exists = lanes::RebindMask(
            tag,
            lanes::Ne(lanes::Load(integers, packet.valid.data() + lane), lanes::Zero(integers)));
        counts.missing += lanes::CountTrue(tag, lanes::AndNot(exists, counts_here));
    }
    const lanes::CappedTag<float, 4 * Packet::side> row_tag;
    for (std::size_t row = 0; row < Packet::side; ++row) {
        for (std::size_t k = 0; k < 4 * Packet::side; k += lanes::Lanes(row_tag)) {
            lanes::StoreU(lanes::Load(row_tag, &colors[row * Packet::side].r + k), row_tag,
                          &to[row * stride].r + k);
        }
    }
    return counts;
}

}  // namespace balcony::render::surface_lanes::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace balcony::render::surface_lanes {

HWY_EXPORT(write);

LaneCounts write(const embree::Packet& packet, const Radiances& radiances, LaneBits counted,
                 std::size_t stride, Imath::Color4f* to, std::uint64_t& broken) {
    return HWY_DYNAMIC_DISPATCH(write)(packet, radiances, counted, stride, to, broken);
}

}  // namespace balcony::render::surface_lanes

#endif
