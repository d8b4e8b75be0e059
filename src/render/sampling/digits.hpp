// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Arithmetic on binary digits, for the sampler. A number from [0, 1) is kept with its first digit
// in the lowest bit, so that the hash and the polynomials need no reversal.

#include <cstdint>

namespace balcony::render {

/// The finaliser of MurmurHash3: every bit of the result depends on every bit of x.
[[nodiscard]] constexpr std::uint32_t mixed(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x85ebca6bU;
    x ^= x >> 13;
    x *= 0xc2b2ae35U;
    x ^= x >> 16;
    return x;
}

[[nodiscard]] constexpr std::uint32_t reversed(std::uint32_t x) {
    x = ((x & 0x55555555U) << 1) | ((x >> 1) & 0x55555555U);
    x = ((x & 0x33333333U) << 2) | ((x >> 2) & 0x33333333U);
    x = ((x & 0x0f0f0f0fU) << 4) | ((x >> 4) & 0x0f0f0f0fU);
    x = ((x & 0x00ff00ffU) << 8) | ((x >> 8) & 0x00ff00ffU);
    return x << 16 | x >> 16;
}

/// The number from [0, 1) with these digits, the first in the highest bit: the 24 bits of a float.
[[nodiscard]] constexpr float unit_float(std::uint32_t bits) {
    return static_cast<float>(static_cast<std::int32_t>(bits >> 8)) * 0x1p-24F;
}

/// Owen's nested uniform scrambling: a hash of the lower bits flips each bit (Laine and Karras,
/// "Stratified Sampling for Stochastic Transparency", 2011, in Burley's form).
[[nodiscard]] constexpr std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    x ^= x * 0x8d22f6e6U;
    return x;
}

/// The pixel's place along Morton's curve, from the lower 16 bits of x and y.
[[nodiscard]] constexpr std::uint32_t morton(std::uint32_t x, std::uint32_t y) {
    const auto spread = [](std::uint32_t v) {
        v &= 0x0000ffffU;
        v = (v | v << 8) & 0x00ff00ffU;
        v = (v | v << 4) & 0x0f0f0f0fU;
        v = (v | v << 2) & 0x33333333U;
        return (v | v << 1) & 0x55555555U;
    };
    return spread(x) | spread(y) << 1;
}

// Polynomials over the field of two elements: bit i is the coefficient of z^i.

/// The sum of d_j(z) q^j, where q = z^2 + z + 1 and d_j has the bits 2j and 2j + 1. Neighbouring
/// sums are joined by q^n = z^2n + z^n + 1, which is true where n is a power of two.
[[nodiscard]] constexpr std::uint32_t from_powers_of_q(std::uint32_t digits) {
    std::uint32_t upper = digits & 0xccccccccU;
    digits ^= upper >> 2 ^ upper >> 1;
    upper = digits & 0xf0f0f0f0U;
    digits ^= upper >> 4 ^ upper >> 2;
    upper = digits & 0xff00ff00U;
    digits ^= upper >> 8 ^ upper >> 4;
    upper = digits & 0xffff0000U;
    return digits ^ upper >> 16 ^ upper >> 8;
}

/// The coefficients in powers of z + 1: the product with Pascal's triangle modulo 2. Halves are
/// joined by z^n = (z + 1)^n + 1, which is true where n is a power of two.
[[nodiscard]] constexpr std::uint32_t in_powers_of_z_plus_1(std::uint32_t f) {
    f ^= (f & 0xaaaaaaaaU) >> 1;
    f ^= (f & 0xccccccccU) >> 2;
    f ^= (f & 0xf0f0f0f0U) >> 4;
    f ^= (f & 0xff00ff00U) >> 8;
    return f ^ f >> 16;
}

}  // namespace balcony::render
