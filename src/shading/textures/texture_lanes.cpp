// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/textures/texture_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>

#include "shading/textures/texture_lanes.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::texture_lanes::HWY_NAMESPACE {

#include "shading/lanes/registers.inl"

#include "shading/textures/texture_look_up.inl"

struct Footprint {
    Float2 at, along_x, along_y;
};

#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3
// The values of a table of 32, by the five lowest bits of an index. Gathering them takes longer.
HWY_INLINE Float of_32(const float* values, Int index) {
    return lanes::Vec<Tag>{_mm512_permutex2var_ps(lanes::LoadU(tag, values).raw, index.v.raw,
                                                  lanes::LoadU(tag, values + 16).raw)};
}

HWY_INLINE Int first_of_level(const ImageLevels& image, Int level) {
    static_assert(ImageLevels::max_count == 32);
    const std::int32_t* const values = image.first.data();
    return lanes::Vec<IntTag>{_mm512_permutex2var_epi32(
        lanes::LoadU(int_tag, values).raw, level.v.raw, lanes::LoadU(int_tag, values + 16).raw)};
}

// The values of the codes in the eight bits from `shift` on.
template <int shift>
HWY_INLINE Float decoded_channel(const float* values, Int codes) {
    const Int index = lanes::ShiftRight<shift>(codes.v);
    const Where by_bit_5 = has_bit(codes, 32 << shift);
    const Where by_bit_6 = has_bit(codes, 64 << shift);
    const auto of_64 = [&](const float* from) {
        return select(by_bit_5, of_32(from + 32, index), of_32(from, index));
    };
    const auto of_128 = [&](const float* from) {
        return select(by_bit_6, of_64(from + 64), of_64(from));
    };
    return select(has_bit(codes, 128 << shift), of_128(values + 128), of_128(values));
}
#else
HWY_INLINE Int first_of_level(const ImageLevels& image, Int level) {
    return lanes::GatherIndex(int_tag, image.first.data(), level.v);
}

template <int shift>
HWY_INLINE Float decoded_channel(const float* values, Int codes) {
    return lanes::GatherIndex(tag, values,
                              lanes::And(lanes::ShiftRight<shift>(codes.v), Int(0xff).v));
}
#endif

// The codes of two texels side by side.
struct Codes {
    Int left;
    Int right;
};

#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2
constexpr bool gathers_pairs = true;

// Both have 32 bits, so one gather of 64 bits finds them.
HWY_INLINE Codes gathered_pair(const std::byte* texels, Int left) {
    const lanes::Repartition<std::int64_t, IntTag> pairs;
    const auto* const from = reinterpret_cast<const std::int64_t*>(texels);
    const auto gathered = [&](auto index) {
        return lanes::BitCast(int_tag,
                              lanes::GatherOffset(pairs, from, lanes::ShiftLeft<2>(index)));
    };
    const lanes::Half<IntTag> half;
    const auto lower = gathered(lanes::PromoteTo(pairs, lanes::LowerHalf(half, left.v)));
    const auto upper = gathered(lanes::PromoteTo(pairs, lanes::UpperHalf(half, left.v)));
    return {lanes::ConcatEven(int_tag, upper, lower), lanes::ConcatOdd(int_tag, upper, lower)};
}
#else
constexpr bool gathers_pairs = false;

HWY_INLINE Codes gathered_pair(const std::byte*, Int left) { return {left, left}; }
#endif

class ByteTexels {
public:
    ByteTexels(const ImageLevels& image, const TexelBlock& texels, const ByteScale& scale)
        : image_(image), texels_(texels), scale_(scale) {}

    static HWY_INLINE Float3 black() { return {0.0F, 0.0F, 0.0F}; }
    static HWY_INLINE Float3 white() { return {1.0F, 1.0F, 1.0F}; }

    struct Colors {
        Float3 first;
        Float3 second;
    };

    // Of a level.
    struct Rows {
        HWY_INLINE Colors operator()(Int number) const {
            const Int begin = first + number * width;
            const Codes codes = are_pairs
                                    ? gathered_pair(texels->texels_.data(), begin + columns.first)
                                    : Codes{texels->codes_of(begin + columns.first),
                                            texels->codes_of(begin + columns.second)};
            return {texels->decoded(codes.left), texels->decoded(codes.right)};
        }

        const ByteTexels* texels;
        Int first;
        Int width;
        TexelPair columns;
        bool are_pairs;
    };
    HWY_INLINE Rows rows(Int level, Int width, const TexelPair& columns) const {
        return {this, first_of_level(image_, level), width, columns,
                gathers_pairs && texels_.in_memory() && all(columns.first + 1 == columns.second)};
    }

private:
    HWY_INLINE Int codes_of(Int texel) const {
        if (!texels_.in_memory()) {
            return in_file(texel);
        }
        const auto* const codes = reinterpret_cast<const std::int32_t*>(texels_.data());
        return lanes::GatherIndex(int_tag, codes, texel.v);
    }

    HWY_INLINE Float3 decoded(Int codes) const {
        const float* const values = scale_.values();
        return {decoded_channel<0>(values, codes), decoded_channel<8>(values, codes),
                decoded_channel<16>(values, codes)};
    }

    [[nodiscard]] Int in_file(Int texel) const {
        alignas(64) std::array<std::int32_t, lane_count> numbers;
        lanes::Store(texel.v, int_tag, numbers.data());
        for (std::size_t lane = 0; lane < lanes::Lanes(tag); ++lane) {
            numbers[lane] = texels_.at<std::int32_t>(static_cast<std::size_t>(numbers[lane]));
        }
        return lanes::Load(int_tag, numbers.data());
    }

    const ImageLevels& image_;
    const TexelBlock& texels_;
    const ByteScale& scale_;
};

void set_means(const ImageLevels& image, const TexelBlock& texels, const ByteScale& scale,
               const Footprints& footprints, LaneVectors& colors) {
    const ByteTexels bytes(image, texels, scale);
    for (std::size_t lane = 0; lane < lane_count; lane += lanes::Lanes(tag)) {
        const Footprint footprint{load(footprints.at, lane), load(footprints.along_x, lane),
                                  load(footprints.along_y, lane)};
        store(mean_over(image, bytes, footprint), colors, lane);
    }
}

}  // namespace balcony::render::texture_lanes::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace balcony::render::texture_lanes {

HWY_EXPORT(set_means);

void set_means(const ImageLevels& image, const TexelBlock& texels, const ByteScale& scale,
               const Footprints& footprints, LaneVectors& colors) {
    HWY_DYNAMIC_DISPATCH(set_means)(image, texels, scale, footprints, colors);
}

}  // namespace balcony::render::texture_lanes

#endif
