// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The functions of Operation::range and Operation::chosen: interval arithmetic whose bounds hold
// for the values of every runner. A correctly rounded operation is monotonic where the exact one
// is, so its bounds are its values at the corners; those of the others are moved outward by what
// runners may differ. No argument may be NaN, except those of conditions and of select().

#include <cstddef>
#include <optional>

#include "balcony/operations.hpp"

namespace balcony::expr::ranges {

Range negated(const Range* a);
Range sum(const Range* a);
Range difference(const Range* a);
Range product(const Range* a);
Range quotient(const Range* a);
Range remainder(const Range* a);
Range smaller(const Range* a);
Range larger(const Range* a);
Range absolute(const Range* a);
Range sign(const Range* a);
Range floor(const Range* a);

Range square_root(const Range* a);
Range power(const Range* a);
Range exponential(const Range* a);
Range logarithm(const Range* a);

Range sine(const Range* a);
Range cosine(const Range* a);
Range arcsine(const Range* a);
Range arccosine(const Range* a);
Range arctangent(const Range* a);
Range arctangent2(const Range* a);
Range hyperbolic_sine(const Range* a);
Range hyperbolic_tangent(const Range* a);
Range inverse_hyperbolic_sine(const Range* a);

Range less(const Range* a);
Range less_equal(const Range* a);
Range equal(const Range* a);
Range logical_and(const Range* a);
Range logical_or(const Range* a);
Range logical_not(const Range* a);
Range is_finite(const Range* a);
Range selected(const Range* a);

std::optional<std::size_t> chosen_remainder(const Range* a);
std::optional<std::size_t> chosen_smaller(const Range* a);
std::optional<std::size_t> chosen_larger(const Range* a);
std::optional<std::size_t> chosen_branch(const Range* a);

}  // namespace balcony::expr::ranges
