// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set. The steps are those
// of MipPyramid::mean(), which explains them; a test holds both against each other.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/textures/texture_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "shading/textures/mip_pyramid.hpp"
#include "shading/textures/texture_lanes.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::texture_lanes::HWY_NAMESPACE {

namespace lanes = hwy::HWY_NAMESPACE;

using Tag = lanes::CappedTag<float, lane_count>;
using IntegerTag = lanes::RebindToSigned<Tag>;
using Vector = lanes::Vec<Tag>;
using Integers = lanes::Vec<IntegerTag>;
constexpr Tag tag;
constexpr IntegerTag integers;

HWY_INLINE Vector number(float value) { return lanes::Set(tag, value); }
HWY_INLINE Integers number(std::int32_t value) { return lanes::Set(integers, value); }
HWY_INLINE Vector sum(Vector a, Vector b) { return lanes::Add(a, b); }
HWY_INLINE Vector difference(Vector a, Vector b) { return lanes::Sub(a, b); }
HWY_INLINE Vector product(Vector a, Vector b) { return lanes::Mul(a, b); }
HWY_INLINE Vector mixed(Vector a, Vector b, Vector share) {
    return sum(a, product(share, difference(b, a)));
}

struct Vector2 {
    Vector u;
    Vector v;
};

struct Color {
    Vector red;
    Vector green;
    Vector blue;
};

HWY_INLINE Color mixed(const Color& a, const Color& b, Vector share) {
    return {mixed(a.red, b.red, share), mixed(a.green, b.green, share),
            mixed(a.blue, b.blue, share)};
}

struct Ellipse {
    Vector length;
    Vector width;
    Vector2 axis;
};

HWY_INLINE Ellipse ellipse_of(const Vector2& x, const Vector2& y) {
    const Vector half = number(0.5F);
    const Vector x_square = sum(product(x.u, x.u), product(x.v, x.v));
    const Vector y_square = sum(product(y.u, y.u), product(y.v, y.v));
    const Vector u_square = sum(product(x.u, x.u), product(y.u, y.u));
    const Vector apart =
        product(half, difference(difference(u_square, product(x.v, x.v)), product(y.v, y.v)));
    const Vector across = sum(product(x.u, x.v), product(y.u, y.v));
    const Vector root = lanes::Sqrt(sum(product(apart, apart), product(across, across)));
    const Vector length = lanes::Sqrt(sum(product(half, sum(x_square, y_square)), root));
    const Vector area = lanes::Abs(difference(product(x.u, y.v), product(x.v, y.u)));
    const Vector width =
        lanes::IfThenElseZero(lanes::Gt(length, lanes::Zero(tag)), lanes::Div(area, length));
    const auto wide = lanes::Ge(apart, lanes::Zero(tag));
    const Vector u = lanes::IfThenElse(wide, sum(root, apart), across);
    const Vector v = lanes::IfThenElse(wide, across, difference(root, apart));
    const Vector scale = lanes::Div(length, lanes::Sqrt(sum(product(u, u), product(v, v))));
    const auto usable = lanes::IsFinite(scale);
    return {length,
            width,
            {lanes::IfThenElse(usable, product(u, scale), length),
             lanes::IfThenElseZero(usable, product(v, scale))}};
}

// Two neighbouring texels of a row or column, and the weight of the second.
struct Neighbours {
    Integers first;
    Integers second;
    Vector weight;
};

HWY_INLINE Vector wrapped(Vector position, scene::Wrap wrap) {
    if (wrap == scene::Wrap::clamp) {
        return lanes::Min(lanes::Max(position, lanes::Zero(tag)), number(1.0F));
    }
    if (wrap == scene::Wrap::repeat) {
        return difference(position, lanes::Floor(position));
    }
    const Vector two = number(2.0F);
    const Vector in_period =
        difference(position, product(two, lanes::Floor(product(number(0.5F), position))));
    return lanes::IfThenElse(lanes::Gt(in_period, number(1.0F)), difference(two, in_period),
                             in_period);
}

HWY_INLINE Neighbours neighbours_of(Vector position, Integers count, scene::Wrap wrap) {
    const Vector x =
        difference(product(wrapped(position, wrap), lanes::ConvertTo(tag, count)), number(0.5F));
    const Vector below = lanes::Floor(x);
    const Integers last = lanes::Sub(count, number(1));
    // Also of a number that is not finite, so that no texel outside the image is read.
    const Integers first =
        lanes::Min(lanes::Max(lanes::ConvertTo(integers, below), number(-1)), last);
    const bool repeats = wrap == scene::Wrap::repeat;
    const Integers before = repeats ? last : lanes::Zero(integers);
    const Integers after = repeats ? lanes::Zero(integers) : last;
    return {lanes::IfThenElse(lanes::Lt(first, lanes::Zero(integers)), before, first),
            lanes::IfThenElse(lanes::Lt(first, last), lanes::Add(first, number(1)), after),
            difference(x, below)};
}

// The nearest texel twice.
HWY_INLINE Neighbours nearest_of(const Neighbours& found) {
    const auto before = lanes::RebindMask(integers, lanes::Lt(found.weight, number(0.5F)));
    const Integers chosen = lanes::IfThenElse(before, found.first, found.second);
    return {chosen, chosen, found.weight};
}

#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX3
// The values of a table of 32, by the five lowest bits of an index. Gathering them takes longer.
HWY_INLINE Vector of_32(const float* values, Integers index) {
    return Vector{_mm512_permutex2var_ps(lanes::LoadU(tag, values).raw, index.raw,
                                         lanes::LoadU(tag, values + 16).raw)};
}

HWY_INLINE Integers of_32(const std::int32_t* values, Integers index) {
    return Integers{_mm512_permutex2var_epi32(lanes::LoadU(integers, values).raw, index.raw,
                                              lanes::LoadU(integers, values + 16).raw)};
}

HWY_INLINE Integers value_of_level(const ByteLevels& levels, Integers level) {
    static_assert(ByteLevels::max_count == 32);
    return of_32(levels.first.data(), level);
}

// The values of the codes in the eight bits from `shift` on.
template <int shift>
HWY_INLINE Vector decoded_channel(const float* values, Integers codes) {
    const Integers index = lanes::ShiftRight<shift>(codes);
    const auto has = [&](std::int32_t bit) {
        return lanes::RebindMask(tag, lanes::TestBit(codes, number(bit << shift)));
    };
    const auto by_bit_5 = has(32);
    const auto by_bit_6 = has(64);
    const auto of_64 = [&](const float* from) {
        return lanes::IfThenElse(by_bit_5, of_32(from + 32, index), of_32(from, index));
    };
    const auto of_128 = [&](const float* from) {
        return lanes::IfThenElse(by_bit_6, of_64(from + 64), of_64(from));
    };
    return lanes::IfThenElse(has(128), of_128(values + 128), of_128(values));
}
#else
HWY_INLINE Integers value_of_level(const ByteLevels& levels, Integers level) {
    return lanes::GatherIndex(integers, levels.first.data(), level);
}

template <int shift>
HWY_INLINE Vector decoded_channel(const float* values, Integers codes) {
    return lanes::GatherIndex(tag, values,
                              lanes::And(lanes::ShiftRight<shift>(codes), number(0xff)));
}
#endif

// Two texels side by side.
struct Pair {
    Integers left;
    Integers right;
};

#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2
constexpr bool gathers_pairs = true;

// Both have 32 bits, so one gather of 64 bits finds them.
HWY_INLINE Pair gathered_pair(const std::byte* texels, Integers left) {
    const lanes::Repartition<std::int64_t, IntegerTag> pairs;
    const auto* const from = reinterpret_cast<const std::int64_t*>(texels);
    const auto gathered = [&](auto index) {
        return lanes::BitCast(integers,
                              lanes::GatherOffset(pairs, from, lanes::ShiftLeft<2>(index)));
    };
    const lanes::Half<IntegerTag> half;
    const Integers lower = gathered(lanes::PromoteTo(pairs, lanes::LowerHalf(half, left)));
    const Integers upper = gathered(lanes::PromoteTo(pairs, lanes::UpperHalf(half, left)));
    return {lanes::ConcatEven(integers, upper, lower), lanes::ConcatOdd(integers, upper, lower)};
}
#else
constexpr bool gathers_pairs = false;
#endif

class Sampler {
public:
    Sampler(const ByteLevels& levels, const TexelBlock& texels, const ByteScale& scale)
        : levels_(levels), texels_(texels), scale_(scale) {}

    HWY_INLINE Color bilinear(Integers level, const Vector2& at) const {
        const Integers width = side(levels_.width, level);
        Neighbours u = neighbours_of(at.u, width, levels_.wrap_u);
        Neighbours v = neighbours_of(at.v, side(levels_.height, level), levels_.wrap_v);
        if (!levels_.interpolated) {
            const auto is_image = lanes::Eq(level, lanes::Zero(integers));
            u = chosen(is_image, nearest_of(u), u);
            v = chosen(is_image, nearest_of(v), v);
        }
        const Integers first = value_of_level(levels_, level);
        const bool are_pairs =
            gathers_pairs && texels_.in_memory() &&
            lanes::AllTrue(integers, lanes::Eq(lanes::Add(u.first, number(1)), u.second));
        const auto row = [&](Integers number) {
            const Integers begin = lanes::Add(first, lanes::Mul(number, width));
            const Pair codes = pair(begin, u, are_pairs);
            return mixed(decoded(codes.left), decoded(codes.right), u.weight);
        };
        return mixed(row(v.first), row(v.second), v.weight);
    }

private:
    template <class Mask>
    static HWY_INLINE Neighbours chosen(Mask mask, const Neighbours& a, const Neighbours& b) {
        return {lanes::IfThenElse(mask, a.first, b.first),
                lanes::IfThenElse(mask, a.second, b.second), b.weight};
    }
    static HWY_INLINE Integers side(std::int32_t of_image, Integers level) {
        return lanes::Max(lanes::Shr(number(of_image), level), number(1));
    }

    HWY_INLINE Pair pair(Integers begin, const Neighbours& u,
                         [[maybe_unused]] bool side_by_side) const {
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2
        if (side_by_side) {
            return gathered_pair(texels_.data(), lanes::Add(begin, u.first));
        }
#endif
        return {codes_of(lanes::Add(begin, u.first)), codes_of(lanes::Add(begin, u.second))};
    }

    HWY_INLINE Integers codes_of(Integers texel) const {
        return texels_.in_memory()
                   ? lanes::GatherIndex(
                         integers, reinterpret_cast<const std::int32_t*>(texels_.data()), texel)
                   : in_file(texel);
    }

    HWY_INLINE Color decoded(Integers codes) const {
        const float* const values = scale_.values();
        return {decoded_channel<0>(values, codes), decoded_channel<8>(values, codes),
                decoded_channel<16>(values, codes)};
    }

    [[nodiscard]] Integers in_file(Integers texel) const {
        alignas(64) std::array<std::int32_t, lane_count> numbers;
        lanes::Store(texel, integers, numbers.data());
        for (std::size_t lane = 0; lane < lanes::Lanes(tag); ++lane) {
            numbers[lane] = texels_.at<std::int32_t>(static_cast<std::size_t>(numbers[lane]));
        }
        return lanes::Load(integers, numbers.data());
    }

    const ByteLevels& levels_;
    const TexelBlock& texels_;
    const ByteScale& scale_;
};

HWY_INLINE Color mean(const ByteLevels& levels, const Sampler& sampler, const Vector2& at,
                      const Vector2& along_x, const Vector2& along_y) {
    const Vector one = number(1.0F);
    const Vector2 size{number(static_cast<float>(levels.width)),
                       number(static_cast<float>(levels.height))};
    const Ellipse ellipse = ellipse_of({product(along_x.u, size.u), product(along_x.v, size.v)},
                                       {product(along_y.u, size.u), product(along_y.v, size.v)});
    const Vector aspect = lanes::Min(lanes::Div(ellipse.length, lanes::Max(ellipse.width, one)),
                                     number(static_cast<float>(MipPyramid::max_probes)));
    const Integers probes =
        lanes::Max(lanes::ConvertTo(integers, sum(aspect, number(0.7F))), number(1));
    const Vector probe_count = lanes::ConvertTo(tag, probes);
    const Vector spacing = lanes::Div(one, probe_count);
    const Vector width =
        lanes::Max(lanes::Max(ellipse.width, product(ellipse.length, spacing)), one);

    const Integers bits = lanes::BitCast(integers, width);
    const Integers last = number(levels.last);
    const Integers exponent = lanes::Sub(lanes::ShiftRight<23>(bits), number(127));
    const Integers level = lanes::Min(exponent, last);
    const Vector fraction = difference(
        lanes::BitCast(tag, lanes::Or(lanes::And(bits, number(0x007fffff)), number(0x3f800000))),
        one);
    const Vector next =
        lanes::IfThenElseZero(lanes::RebindMask(tag, lanes::Lt(level, last)), fraction);
    const Integers blurred = lanes::Min(lanes::Add(level, number(1)), last);
    const bool between_levels = !lanes::AllTrue(tag, lanes::Eq(next, lanes::Zero(tag)));

    const Vector2 step{lanes::Div(product(spacing, ellipse.axis.u), size.u),
                       lanes::Div(product(spacing, ellipse.axis.v), size.v)};
    const Vector half_way = product(number(0.5F), difference(probe_count, one));
    Vector2 probe{difference(at.u, product(half_way, step.u)),
                  difference(at.v, product(half_way, step.v))};
    Color total{lanes::Zero(tag), lanes::Zero(tag), lanes::Zero(tag)};
    for (std::int32_t done = 0;; ++done) {
        const auto active = lanes::RebindMask(tag, lanes::Gt(probes, number(done)));
        if (lanes::AllFalse(tag, active)) {
            break;
        }
        const Color sharper = sampler.bilinear(level, probe);
        const Color color =
            between_levels ? mixed(sharper, sampler.bilinear(blurred, probe), next) : sharper;
        total.red = sum(total.red, lanes::IfThenElseZero(active, color.red));
        total.green = sum(total.green, lanes::IfThenElseZero(active, color.green));
        total.blue = sum(total.blue, lanes::IfThenElseZero(active, color.blue));
        probe = {sum(probe.u, step.u), sum(probe.v, step.v)};
    }
    return {product(total.red, spacing), product(total.green, spacing),
            product(total.blue, spacing)};
}

void set_means(const ByteLevels& levels, const TexelBlock& texels, const ByteScale& scale,
               const Footprints& footprints, Colors& colors) {
    const Sampler sampler(levels, texels, scale);
    const auto within = [](const Vector2& v) {
        const Vector limit = number(MipPyramid::max_coordinate);
        return lanes::And(lanes::Lt(lanes::Abs(v.u), limit), lanes::Lt(lanes::Abs(v.v), limit));
    };
    for (std::size_t lane = 0; lane < lane_count; lane += lanes::Lanes(tag)) {
        const auto load = [lane](const Floats& u, const Floats& v) {
            return Vector2{lanes::Load(tag, u.data() + lane), lanes::Load(tag, v.data() + lane)};
        };
        const auto where = [](auto mask, const Vector2& v) {
            return Vector2{lanes::IfThenElseZero(mask, v.u), lanes::IfThenElseZero(mask, v.v)};
        };
        const Vector2 at = load(footprints.at_u, footprints.at_v);
        const Vector2 along_x = load(footprints.along_x_u, footprints.along_x_v);
        const Vector2 along_y = load(footprints.along_y_u, footprints.along_y_v);
        const auto inside = within(at);
        const auto filtered = lanes::And(inside, lanes::And(within(along_x), within(along_y)));
        const Color found = mean(levels, sampler, where(inside, at), where(filtered, along_x),
                                 where(filtered, along_y));
        const auto store = [&](Vector value, Floats& to) {
            lanes::Store(lanes::IfThenElse(inside, value, number(1.0F)), tag, to.data() + lane);
        };
        store(found.red, colors.red);
        store(found.green, colors.green);
        store(found.blue, colors.blue);
    }
}

}  // namespace balcony::render::texture_lanes::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace balcony::render::texture_lanes {

HWY_EXPORT(set_means);

void set_means(const ByteLevels& levels, const TexelBlock& texels, const ByteScale& scale,
               const Footprints& footprints, Colors& colors) {
    HWY_DYNAMIC_DISPATCH(set_means)(levels, texels, scale, footprints, colors);
}

}  // namespace balcony::render::texture_lanes

#endif
