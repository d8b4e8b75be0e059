// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which pixels need more samples.
//
// Pixels are judged when a tile has n = 2^k samples, since the sequences of the sampler are even
// then. Let I be the mean of a pixel's samples, and A that of their first half. The halves are
// independent renders, so the expected square of I - A is the variance of I (the error estimate of
// Dammertz et al., "A Hierarchical Automatic Stopping Condition for Monte Carlo Global
// Illumination", 2010). Since a single pixel may be lucky, the squares are averaged over the
// pixels around it. The error is relative to sqrt(I W), where W is the radiance shown as white:
// the eye, and every display, shows the same error better in the dark.

#include <cstdint>
#include <vector>

#include "balcony/film.hpp"
#include "balcony/render.hpp"

namespace balcony::render {

/// The number of samples at which pixels are first judged: the next power of two.
[[nodiscard]] std::uint32_t first_judgement(const SamplingSettings& settings);

/// The radiance shown as white: the median of lit pixels is shown as middle grey, 0.18.
[[nodiscard]] double white_of(const Film& film);

/// Marks the points of a region that need another sample; outside the film's window, all. Depends
/// only on the samples of the tile, so that it does not matter when a render is interrupted.
/// Returns whether any pixel of the window does.
bool find_active(const Film& film, std::size_t tile, const Region& region,
                 const SamplingSettings& settings, std::vector<std::uint8_t>& active);

}  // namespace balcony::render
