// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The vocabulary of formulas (*.inl) for one float: Float, Int, Where, Float2 and Float3, and their
// functions. registers.inl has the same vocabulary for the lanes of a register, so that a formula
// is written once, and gives the same bits in both. Nothing is fused: a product is rounded before
// it is added.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <Imath/ImathVec.h>

namespace balcony::render {

using Float = float;
using Int = std::int32_t;
using Index = std::size_t;  ///< Of an entry of a table.
using Where = bool;
using Float2 = Imath::V2f;
using Float3 = Imath::V3f;

[[nodiscard]] inline float square(float a) { return a * a; }
[[nodiscard]] inline float root(float a) { return std::sqrt(a); }
[[nodiscard]] inline float larger(float a, float b) { return std::max(a, b); }
[[nodiscard]] inline float smaller(float a, float b) { return std::min(a, b); }
[[nodiscard]] inline float clamped(float a, float low, float high) {
    return std::clamp(a, low, high);
}
[[nodiscard]] inline float absolute(float a) { return std::abs(a); }
/// The largest whole number that is not above; of numbers that an Int can have.
[[nodiscard]] inline float floored(float a) {
    const auto truncated = static_cast<float>(static_cast<std::int32_t>(a));
    return truncated > a ? truncated - 1.0F : truncated;
}
[[nodiscard]] inline float sign_of(float a) { return std::copysign(1.0F, a); }
/// Between two numbers.
[[nodiscard]] inline float mix(float a, float b, float fraction) { return a + fraction * (b - a); }

[[nodiscard]] inline float select(bool where, float a, float b) { return where ? a : b; }
[[nodiscard]] inline float or_zero(bool where, float a) { return where ? a : 0.0F; }
[[nodiscard]] inline float negated_if(bool where, float a) { return where ? -a : a; }
[[nodiscard]] inline bool both(bool a, bool b) { return a && b; }
/// Whether it holds for a lane.
[[nodiscard]] inline bool any(bool where) { return where; }
[[nodiscard]] inline bool is_finite(float a) { return std::isfinite(a); }

[[nodiscard]] inline std::int32_t larger(std::int32_t a, std::int32_t b) { return std::max(a, b); }
[[nodiscard]] inline std::int32_t smaller(std::int32_t a, std::int32_t b) { return std::min(a, b); }
[[nodiscard]] inline std::int32_t select(bool where, std::int32_t a, std::int32_t b) {
    return where ? a : b;
}
/// Towards zero.
[[nodiscard]] inline std::int32_t truncated(float a) { return static_cast<std::int32_t>(a); }
[[nodiscard]] inline std::size_t as_index(std::int32_t a) { return static_cast<std::size_t>(a); }
[[nodiscard]] inline float as_float(std::int32_t a) { return static_cast<float>(a); }
[[nodiscard]] inline bool has_bit(std::int32_t a, std::int32_t bit) { return (a & bit) != 0; }
/// A positive number is two to the power of its exponent, times 1 + its fraction.
[[nodiscard]] inline std::int32_t exponent_of(float a) {
    return (std::bit_cast<std::int32_t>(a) >> 23) - 127;
}
[[nodiscard]] inline float fraction_of(float a) {
    return std::bit_cast<float>((std::bit_cast<std::int32_t>(a) & 0x007fffff) | 0x3f800000) - 1.0F;
}

[[nodiscard]] inline float dot(const Imath::V2f& a, const Imath::V2f& b) { return a.dot(b); }
[[nodiscard]] inline Imath::V2f select(bool where, const Imath::V2f& a, const Imath::V2f& b) {
    return where ? a : b;
}
[[nodiscard]] inline Imath::V2f or_zero(bool where, const Imath::V2f& a) {
    return where ? a : Imath::V2f(0.0F);
}
[[nodiscard]] inline float dot(const Imath::V3f& a, const Imath::V3f& b) { return a.dot(b); }
[[nodiscard]] inline Imath::V3f cross(const Imath::V3f& a, const Imath::V3f& b) {
    return a.cross(b);
}
[[nodiscard]] inline Imath::V3f unit(const Imath::V3f& a) { return a.normalized(); }
[[nodiscard]] inline Imath::V3f select(bool where, const Imath::V3f& a, const Imath::V3f& b) {
    return where ? a : b;
}
[[nodiscard]] inline Imath::V3f or_zero(bool where, const Imath::V3f& a) {
    return where ? a : Imath::V3f(0.0F);
}

}  // namespace balcony::render

/// Before each function of a formula; registers.inl has it inlined, as its instruction set needs.
#define BALCONY_FORMULA inline
