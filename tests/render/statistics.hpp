// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pearson's chi-square test.

#include <span>

namespace balcony::render::test {

/// The probability that counts differ from what is expected at least as much as these do, if they
/// are drawn from it. Cells that expect fewer than five are taken together. Expected values add up
/// to the number of draws.
[[nodiscard]] double chi_square_probability(std::span<const double> counts,
                                            std::span<const double> expected);

/// Tests draw from fixed seeds, so each passes or fails for good; a right one would have failed
/// with this probability.
inline constexpr double significance = 1e-4;

}  // namespace balcony::render::test
