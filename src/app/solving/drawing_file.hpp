// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/solving.hpp"

namespace balcony::app {

/// What is known to be wrong with the drawing that a request asks for.
[[nodiscard]] Diagnostics check_drawing_of(const SolveRequest& request);

/// Writes it, if one is asked for.
[[nodiscard]] Diagnostics write_drawing_of(const SolveReport& report, const SolveRequest& request);

/// The same of the map of the uncertainty of projections.
[[nodiscard]] Diagnostics check_uncertainty_of(const SolveRequest& request);
[[nodiscard]] Diagnostics write_uncertainty_of(const SolveReport& report,
                                               const SolveRequest& request);

}  // namespace balcony::app
