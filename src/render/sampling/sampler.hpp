// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Random numbers that do not depend on the order of requests.

#include <cstddef>
#include <cstdint>

#include <Imath/ImathVec.h>

namespace balcony::render {

/// The numbers of one sample of one pixel, by dimension. They depend only on pixel, pass
/// and dimension.
///
/// Over the passes of a pixel, each dimension and each pair is an Owen-scrambled Sobol' sequence:
/// of any 2^k passes from a multiple of 2^k on, one lies in each of 2^k equal parts of [0, 1), and
/// likewise for the elementary rectangles of a pair. Dimensions are shuffled independently: Burley,
/// "Practical Hash-based Owen Scrambling" (JCGT 2020).
class Sampler {
public:
    Sampler(std::size_t pixel_x, std::size_t pixel_y, std::size_t pass)
        : pixel_x_(static_cast<std::uint32_t>(pixel_x)),
          pixel_y_(static_cast<std::uint32_t>(pixel_y)),
          pass_(static_cast<std::uint32_t>(pass)) {}

    /// The next dimension, or the next two, which are stratified together; from [0, 1).
    [[nodiscard]] float next();
    [[nodiscard]] Imath::V2f next_pair();

private:
    [[nodiscard]] std::uint32_t next_seed();

    std::uint32_t pixel_x_;
    std::uint32_t pixel_y_;
    std::uint32_t pass_;
    std::uint32_t dimension_ = 0;
};

}  // namespace balcony::render
