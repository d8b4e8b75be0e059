// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/solve.hpp"

namespace balcony::solve {

/// What is wrong with a problem by itself: numbers, indices, how many marks a constraint has.
[[nodiscard]] Diagnostics problems_of(const Problem& problem);

}  // namespace balcony::solve
