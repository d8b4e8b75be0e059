// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Solutions of problems without mistakes.

#include <stop_token>

#include "solve/camera_rays.hpp"

namespace balcony::solve {

/// A problem with what solving adds to it: where searches for marks begin, and the marks of
/// outlines.
[[nodiscard]] Problem with_solving(Problem problem);

/// The solution of a problem, as it was given and with what solving adds to it.
[[nodiscard]] Result<Solution> solution_of(const CameraRays& rays, const Problem& given,
                                           const Problem& problem, const V2d& size,
                                           const Options& options, const std::stop_token& stop);

}  // namespace balcony::solve
