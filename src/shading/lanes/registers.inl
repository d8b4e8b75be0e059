// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The vocabulary of scalar.hpp for a register of lanes, and how lanes are loaded and stored. A file
// that Highway compiles for each instruction set includes this within its HWY_NAMESPACE, and then
// the formulas (*.inl).

#undef BALCONY_FORMULA
#define BALCONY_FORMULA HWY_INLINE

namespace lanes = hwy::HWY_NAMESPACE;

using Tag = lanes::CappedTag<float, lane_count>;
using IntTag = lanes::RebindToSigned<Tag>;
constexpr Tag tag;
constexpr IntTag int_tag;

// Which lanes of registers with a tag a condition holds for.
template <class D>
struct Condition {
    HWY_INLINE Condition(lanes::Mask<D> mask) : m(mask) {}
    lanes::Mask<D> m;

    HWY_INLINE friend Condition operator!(Condition a) { return lanes::Not(a.m); }
    HWY_INLINE friend Condition both(Condition a, Condition b) { return lanes::And(a.m, b.m); }
    HWY_INLINE friend bool any(Condition a) { return !lanes::AllFalse(D(), a.m); }
    HWY_INLINE friend bool all(Condition a) { return lanes::AllTrue(D(), a.m); }
};
using Where = Condition<Tag>;
HWY_INLINE Where where_int(lanes::Mask<IntTag> mask) { return lanes::RebindMask(tag, mask); }

// Floating-point numbers of registers with a tag.
template <class D>
struct Number {
    using Lanes = Condition<D>;

    Number() = default;
    HWY_INLINE Number(lanes::Vec<D> vector) : v(vector) {}
    HWY_INLINE Number(lanes::TFromD<D> value) : v(lanes::Set(D(), value)) {}
    lanes::Vec<D> v;

    HWY_INLINE friend Number operator+(Number a, Number b) { return lanes::Add(a.v, b.v); }
    HWY_INLINE friend Number operator-(Number a, Number b) { return lanes::Sub(a.v, b.v); }
    HWY_INLINE friend Number operator*(Number a, Number b) { return lanes::Mul(a.v, b.v); }
    HWY_INLINE friend Number operator/(Number a, Number b) { return lanes::Div(a.v, b.v); }
    HWY_INLINE friend Number operator-(Number a) { return lanes::Neg(a.v); }
    HWY_INLINE friend Lanes operator==(Number a, Number b) { return lanes::Eq(a.v, b.v); }
    HWY_INLINE friend Lanes operator>(Number a, Number b) { return lanes::Gt(a.v, b.v); }
    HWY_INLINE friend Lanes operator>=(Number a, Number b) { return lanes::Ge(a.v, b.v); }
    HWY_INLINE friend Lanes operator<(Number a, Number b) { return lanes::Lt(a.v, b.v); }
    HWY_INLINE friend Lanes operator<=(Number a, Number b) { return lanes::Le(a.v, b.v); }

    HWY_INLINE friend Number square(Number a) { return a * a; }
    HWY_INLINE friend Number root(Number a) { return lanes::Sqrt(a.v); }
    HWY_INLINE friend Number larger(Number a, Number b) { return lanes::Max(a.v, b.v); }
    HWY_INLINE friend Number smaller(Number a, Number b) { return lanes::Min(a.v, b.v); }
    HWY_INLINE friend Number clamped(Number a, Number low, Number high) {
        return lanes::Clamp(a.v, low.v, high.v);
    }
    HWY_INLINE friend Number absolute(Number a) { return lanes::Abs(a.v); }
    HWY_INLINE friend Number floored(Number a) { return lanes::Floor(a.v); }
    HWY_INLINE friend Number sign_of(Number a) { return lanes::CopySign(Number(1).v, a.v); }
    HWY_INLINE friend Number mix(Number a, Number b, Number fraction) {
        return a + fraction * (b - a);
    }
    HWY_INLINE friend Number select(Lanes where, Number a, Number b) {
        return lanes::IfThenElse(where.m, a.v, b.v);
    }
    HWY_INLINE friend Number or_zero(Lanes where, Number a) {
        return lanes::IfThenElseZero(where.m, a.v);
    }
    HWY_INLINE friend Number negated_if(Lanes where, Number a) { return select(where, -a, a); }
    HWY_INLINE friend Lanes is_finite(Number a) { return lanes::IsFinite(a.v); }
};
using Float = Number<Tag>;

struct Int {
    Int() = default;
    HWY_INLINE Int(lanes::Vec<IntTag> vector) : v(vector) {}
    HWY_INLINE Int(std::int32_t value) : v(lanes::Set(int_tag, value)) {}
    lanes::Vec<IntTag> v;
};
using Index = Int;

HWY_INLINE Int operator+(Int a, Int b) { return lanes::Add(a.v, b.v); }
HWY_INLINE Int operator-(Int a, Int b) { return lanes::Sub(a.v, b.v); }
HWY_INLINE Int operator*(Int a, Int b) { return lanes::Mul(a.v, b.v); }
HWY_INLINE Int operator>>(Int a, Int bits) { return lanes::Shr(a.v, bits.v); }
HWY_INLINE Where operator==(Int a, Int b) { return where_int(lanes::Eq(a.v, b.v)); }
HWY_INLINE Where operator<(Int a, Int b) { return where_int(lanes::Lt(a.v, b.v)); }
HWY_INLINE Int larger(Int a, Int b) { return lanes::Max(a.v, b.v); }
HWY_INLINE Int smaller(Int a, Int b) { return lanes::Min(a.v, b.v); }
HWY_INLINE Int select(Where where, Int a, Int b) {
    return lanes::IfThenElse(lanes::RebindMask(int_tag, where.m), a.v, b.v);
}
HWY_INLINE Int truncated(Float a) { return lanes::ConvertTo(int_tag, a.v); }
HWY_INLINE Index as_index(Int a) { return a; }
HWY_INLINE Float as_float(Int a) { return lanes::ConvertTo(tag, a.v); }
HWY_INLINE Where has_bit(Int a, Int bit) { return where_int(lanes::TestBit(a.v, bit.v)); }
HWY_INLINE Int exponent_of(Float a) {
    return Int(lanes::ShiftRight<23>(lanes::BitCast(int_tag, a.v))) - 127;
}
HWY_INLINE Float fraction_of(Float a) {
    const auto bits = lanes::And(lanes::BitCast(int_tag, a.v), Int(0x007fffff).v);
    return Float(lanes::BitCast(tag, lanes::Or(bits, Int(0x3f800000).v))) - 1.0F;
}

struct Float2 {
    Float x, y;
};

HWY_INLINE Float2 operator+(const Float2& a, const Float2& b) { return {a.x + b.x, a.y + b.y}; }
HWY_INLINE Float2 operator-(const Float2& a, const Float2& b) { return {a.x - b.x, a.y - b.y}; }
HWY_INLINE Float2 operator*(const Float2& a, const Float2& b) { return {a.x * b.x, a.y * b.y}; }
HWY_INLINE Float2 operator*(Float a, const Float2& b) { return {a * b.x, a * b.y}; }
HWY_INLINE Float2 operator*(const Float2& a, Float b) { return b * a; }
HWY_INLINE Float2 operator/(const Float2& a, const Float2& b) { return {a.x / b.x, a.y / b.y}; }
HWY_INLINE Float dot(const Float2& a, const Float2& b) { return a.x * b.x + a.y * b.y; }
HWY_INLINE Float2 select(Where where, const Float2& a, const Float2& b) {
    return {select(where, a.x, b.x), select(where, a.y, b.y)};
}
HWY_INLINE Float2 or_zero(Where where, const Float2& a) {
    return {or_zero(where, a.x), or_zero(where, a.y)};
}

struct Float3 {
    Float x, y, z;
};

HWY_INLINE Float3 operator+(const Float3& a, const Float3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Float3 operator-(const Float3& a, const Float3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Float3 operator-(const Float3& a) { return {-a.x, -a.y, -a.z}; }
HWY_INLINE Float3 operator*(Float a, const Float3& b) { return {a * b.x, a * b.y, a * b.z}; }
HWY_INLINE Float3 operator*(const Float3& a, Float b) { return b * a; }
HWY_INLINE Float3 operator*(const Float3& a, const Float3& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
HWY_INLINE Float3 operator/(const Float3& a, Float b) { return {a.x / b, a.y / b, a.z / b}; }
HWY_INLINE Float dot(const Float3& a, const Float3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HWY_INLINE Float3 cross(const Float3& a, const Float3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HWY_INLINE Float3 unit(const Float3& a) { return a / root(dot(a, a)); }
HWY_INLINE Float largest(const Float3& color) { return larger(larger(color.x, color.y), color.z); }
HWY_INLINE Float3 mix(const Float3& a, const Float3& b, Float fraction) {
    return a + fraction * (b - a);
}
HWY_INLINE Float3 select(Where where, const Float3& a, const Float3& b) {
    return {select(where, a.x, b.x), select(where, a.y, b.y), select(where, a.z, b.z)};
}
HWY_INLINE Float3 or_zero(Where where, const Float3& a) {
    return {or_zero(where, a.x), or_zero(where, a.y), or_zero(where, a.z)};
}

HWY_INLINE Float load(const LaneFloats& values, std::size_t lane) {
    return lanes::Load(tag, values.data() + lane);
}
HWY_INLINE Float3 load(const LaneVectors& v, std::size_t lane) {
    return {load(v.x, lane), load(v.y, lane), load(v.z, lane)};
}
HWY_INLINE void store(Int value, LaneNumbers& values, std::size_t lane) {
    const lanes::RebindToUnsigned<Tag> numbers;
    lanes::Store(lanes::BitCast(numbers, value.v), numbers, values.data() + lane);
}
HWY_INLINE Float2 load(const LanePairs& v, std::size_t lane) {
    return {load(v.x, lane), load(v.y, lane)};
}
HWY_INLINE void store(Float value, LaneFloats& values, std::size_t lane) {
    lanes::Store(value.v, tag, values.data() + lane);
}
HWY_INLINE void store(const Float3& v, LaneFloats& x, LaneFloats& y, LaneFloats& z,
                      std::size_t lane) {
    store(v.x, x, lane);
    store(v.y, y, lane);
    store(v.z, z, lane);
}
HWY_INLINE void store(const Float3& v, LaneVectors& values, std::size_t lane) {
    store(v, values.x, values.y, values.z, lane);
}
HWY_INLINE Float3 load(const LaneFloats& x, const LaneFloats& y, const LaneFloats& z,
                       std::size_t lane) {
    return {load(x, lane), load(y, lane), load(z, lane)};
}
HWY_INLINE Int load(const LaneNumbers& values, std::size_t lane) {
    const lanes::RebindToUnsigned<Tag> numbers;
    return lanes::BitCast(int_tag, lanes::Load(numbers, values.data() + lane));
}
// Into some lanes.
HWY_INLINE void store(Where where, Float value, LaneFloats& values, std::size_t lane) {
    store(select(where, value, load(values, lane)), values, lane);
}
HWY_INLINE void store(Where where, const Float2& v, LanePairs& values, std::size_t lane) {
    store(where, v.x, values.x, lane);
    store(where, v.y, values.y, lane);
}
HWY_INLINE void store(Where where, const Float3& v, LaneVectors& values, std::size_t lane) {
    store(where, v.x, values.x, lane);
    store(where, v.y, values.y, lane);
    store(where, v.z, values.z, lane);
}

// The lanes from `lane` on, as many as a register has.
HWY_INLINE Where where_of(LaneBits bits, std::size_t lane) {
    const std::uint32_t rest = bits >> lane;
    const std::uint8_t bytes[8]{static_cast<std::uint8_t>(rest),
                                static_cast<std::uint8_t>(rest >> 8U)};
    return lanes::LoadMaskBits(tag, bytes);
}
HWY_INLINE LaneBits bits_of(Where where, std::size_t lane) {
    std::uint8_t bytes[8]{};
    lanes::StoreMaskBits(tag, where.m, bytes);
    return (std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8U) << lane;
}
