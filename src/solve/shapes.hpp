// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What constraints on the shape of the picture at one point miss, as formulas of a ray's footprint.

#include <vector>

#include "balcony/camera.hpp"
#include "balcony/solve.hpp"

namespace balcony::solve {

/// What a constraint without marks misses, in its unit: numbers that should be 0.
[[nodiscard]] std::vector<camera::Expr> shape_misses(const Constraint& constraint,
                                                     const camera::RayExpressions& ray);

}  // namespace balcony::solve
