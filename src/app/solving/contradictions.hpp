// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/solve.hpp"

namespace balcony::app {

/// Pairs of constraints on the same marks or position that no camera can fulfil both.
[[nodiscard]] Diagnostics contradictions_of(const solve::Problem& problem);

}  // namespace balcony::app
