// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>

#include "balcony/solving.hpp"

namespace balcony::app {

/// Warnings of the constraints that are missed by far. If all can be met but a few, these are the
/// ones that contradict the others; otherwise, the worst come first. `make` is what it was solved
/// with.
[[nodiscard]] Diagnostics warn_of_misses(const SolveReport& report, const solve::CameraMaker& make,
                                         const std::stop_token& stop);

}  // namespace balcony::app
