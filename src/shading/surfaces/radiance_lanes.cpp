// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/surfaces/radiance_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>
#include <bit>

#include "shading/surfaces/radiance_lanes.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::surface_lanes::HWY_NAMESPACE {

#include "shading/lanes/registers.inl"

using embree::Packet;

LaneCounts write(const Packet& packet, const Radiances& radiances, LaneBits counted,
                 std::size_t stride, Imath::Color4f* to, std::uint64_t& broken) {
    alignas(64) std::array<Imath::Color4f, Packet::size> colors;
    LaneBits visible = 0;
    LaneBits missing = 0;
    for (std::size_t lane = 0; lane < Packet::size; lane += lanes::Lanes(tag)) {
        const Float3 color = load(radiances.color, lane);
        const Float alpha = load(radiances.alpha, lane);
        const Where finite = both(both(is_finite(color.x), is_finite(color.y)),
                                  both(is_finite(color.z), is_finite(alpha)));
        const Float3 shown = or_zero(finite, color);
        const Float shown_alpha = or_zero(finite, alpha);
        lanes::StoreInterleaved4(shown.x.v, shown.y.v, shown.z.v, shown_alpha.v, tag,
                                 &colors[lane].r);
        broken += lanes::CountTrue(tag, (!finite).m);
        visible |= bits_of(shown_alpha > 0.0F, lane);
        missing |= bits_of(Int(lanes::Load(int_tag, packet.valid.data() + lane)) == 0, lane);
    }
    LaneCounts counts;
    counts.shown = static_cast<std::size_t>(std::popcount(visible & counted));
    counts.missing = static_cast<std::size_t>(std::popcount(missing & counted));
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
