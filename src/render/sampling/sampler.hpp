// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Random numbers that do not depend on the order of requests.
//
// The samples of a pair of dimensions are a digital net over passes and pixels at once, so that the
// error of a picture is blue noise: neighbouring pixels err in opposite directions. Let p(z) be the
// polynomial over the field of two elements whose coefficients are the bits of the pass, m_j(z)
// those of the pixel's place on Morton's curve, two bits each, the most significant ones first,
// and q = z^2 + z + 1. The digits of the two coordinates are the lowest coefficients of
//
//     f = p q^16 + sum of m_j q^j
//
// in powers of z and in powers of z + 1. The remainders of a polynomial of degree below n modulo
// powers of different primes are independent as long as the degrees of the moduli add up to n at
// most. Therefore, of any 2^k passes from a multiple of 2^k on and any aligned square of 4^j
// pixels, one sample lies in each elementary rectangle of area 2^-(k + 2j). For one number of
// samples, such an order of the pixels is that of Ahmed and Wonka, "Screen-Space Blue-Noise
// Diffusion of Monte Carlo Sampling Error via Hierarchical Ordering of Pixels" (2020); the
// construction, that of Niederreiter's sequences (1988), makes it progressive.

#include <array>
#include <cstddef>
#include <cstdint>

#include <Imath/ImathVec.h>

#include "render/sampling/digits.hpp"

namespace balcony::render {

/// What the samplers of all pixels share in one pass.
class PassNumbers {
public:
    PassNumbers(std::size_t pass, std::uint32_t seed);

    /// Of one pair of dimensions: the shuffled pass and the seeds of scrambles, which differ from
    /// pair to pair, so that the pairs are independent of each other.
    struct Pair {
        std::uint32_t pass = 0;
        std::uint32_t pixel_seed = 0;
        std::uint32_t x_seed = 0;
        std::uint32_t y_seed = 0;
    };
    [[nodiscard]] std::uint32_t pass() const { return pass_; }
    [[nodiscard]] Pair pair(std::uint32_t index) const {
        return index < first_pairs_.size() ? first_pairs_[index] : make_pair(index);
    }

private:
    [[nodiscard]] Pair make_pair(std::uint32_t index) const;

    std::uint32_t pass_;
    std::uint32_t seed_;
    std::array<Pair, 128> first_pairs_;
};

/// The coefficients of f up to z^31: q^16 = z^32 + z^16 + 1. Those above matter only in powers of
/// z + 1.
[[nodiscard]] inline std::uint32_t low_part(const PassNumbers::Pair& pair, std::uint32_t pixel) {
    return pair.pass ^ pair.pass << 16 ^ from_powers_of_q(scrambled(pixel, pair.pixel_seed));
}

/// The numbers of a pair of dimensions, from [0, 1), at a pixel: its place on Morton's curve,
/// reversed.
[[nodiscard]] inline float first_number(const PassNumbers::Pair& pair, std::uint32_t pixel) {
    return unit_float(reversed(scrambled(low_part(pair, pixel), pair.x_seed)));
}
[[nodiscard]] inline float second_number(const PassNumbers::Pair& pair, std::uint32_t pixel) {
    const std::uint32_t high = pair.pass ^ pair.pass >> 16;
    const std::uint32_t digits = in_powers_of_z_plus_1(low_part(pair, pixel) ^ high);
    return unit_float(reversed(scrambled(digits, pair.y_seed)));
}

/// The numbers of one sample of one pixel, by dimension. They depend only on the seed, pixel, pass
/// and dimension.
///
/// Over the passes of a pixel, each dimension and each pair is an Owen-scrambled (0, 2)-sequence:
/// of any 2^k passes from a multiple of 2^k on, one lies in each of 2^k equal parts of [0, 1), and
/// likewise for the elementary rectangles of a pair. Dimensions are shuffled independently, as in
/// Burley, "Practical Hash-based Owen Scrambling" (JCGT 2020).
class Sampler {
public:
    /// The numbers of the pass must outlive the sampler. Pixels 65536 apart have the same numbers.
    Sampler(std::size_t pixel_x, std::size_t pixel_y, const PassNumbers& pass)
        : pass_(&pass),
          pixel_(reversed(
              morton(static_cast<std::uint32_t>(pixel_x), static_cast<std::uint32_t>(pixel_y)))) {}

    [[nodiscard]] std::uint32_t pass() const { return pass_->pass(); }
    /// The next dimension, or the next two, which are stratified together; from [0, 1).
    [[nodiscard]] float next() { return first_number(pass_->pair(next_++), pixel_); }
    [[nodiscard]] Imath::V2f next_pair() {
        const PassNumbers::Pair pair = pass_->pair(next_++);
        return {first_number(pair, pixel_), second_number(pair, pixel_)};
    }

    /// Goes on with other numbers than those of a path that began with this sampler.
    void branch() { next_ += 1024; }

private:
    friend class SampleBlock;
    friend class SampleReader;

    const PassNumbers* pass_;
    std::uint32_t pixel_;
    std::uint32_t next_ = 0;
};

}  // namespace balcony::render
