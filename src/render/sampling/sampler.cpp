// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/sampling/sampler.hpp"

namespace balcony::render {

namespace {

// The finaliser of MurmurHash3: every bit of the result depends on every bit of x.
std::uint32_t mixed(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x85ebca6bU;
    x ^= x >> 13;
    x *= 0xc2b2ae35U;
    x ^= x >> 16;
    return x;
}

std::uint32_t combined(std::uint32_t seed, std::uint32_t value) {
    return mixed(seed ^ (value + 0x9e3779b9U + (seed << 6) + (seed >> 2)));
}

std::uint32_t reversed(std::uint32_t x) {
    x = ((x & 0x55555555U) << 1) | ((x >> 1) & 0x55555555U);
    x = ((x & 0x33333333U) << 2) | ((x >> 2) & 0x33333333U);
    x = ((x & 0x0f0f0f0fU) << 4) | ((x >> 4) & 0x0f0f0f0fU);
    x = ((x & 0x00ff00ffU) << 8) | ((x >> 8) & 0x00ff00ffU);
    return (x << 16) | (x >> 16);
}

// Owen's nested uniform scrambling: each bit is flipped by a hash of the bits above it (Laine and
// Karras 2011, in Burley's form).
std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    x = reversed(x);
    x += seed;
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    x ^= x * 0x8d22f6e6U;
    return reversed(x);
}

// The second dimension of Sobol's sequence, whose matrix is Pascal's triangle modulo 2; the first
// is reversed().
std::uint32_t sobol_second(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t column = 0x80000000U; index != 0; index >>= 1, column ^= column >> 1) {
        if ((index & 1U) != 0) {
            result ^= column;
        }
    }
    return result;
}

// The 24 bits of a float below 1.
float unit_float(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24F; }

}  // namespace

std::uint32_t Sampler::next_seed() {
    return combined(combined(mixed(pixel_x_), pixel_y_), dimension_++);
}

float Sampler::next() { return next_pair().x; }

Imath::V2f Sampler::next_pair() {
    const std::uint32_t seed = next_seed();
    const std::uint32_t index = scrambled(pass_, seed);
    return {unit_float(scrambled(reversed(index), combined(seed, 1))),
            unit_float(scrambled(sobol_second(index), combined(seed, 2)))};
}

}  // namespace balcony::render
