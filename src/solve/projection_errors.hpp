// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "solve/system.hpp"

namespace balcony::solve {

/// Solution::errors, of unknowns with this spread.
[[nodiscard]] std::vector<std::optional<double>> projection_errors(
    const CameraRays& rays, const Problem& problem, const V2d& size,
    const Eigen::VectorXd& unknowns, const Spread& spread, const ErrorGrid& grid);

}  // namespace balcony::solve
