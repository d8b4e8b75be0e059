// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What constraints on the shape of the picture at one point miss, as formulas of a ray's footprint.

#include <vector>

#include "balcony/camera.hpp"
#include "balcony/solve.hpp"

namespace balcony::solve {

/// Whether two constraints without marks miss the same, if at other positions.
[[nodiscard]] inline bool have_same_formulas(const Constraint& a, const Constraint& b) {
    return a.kind == b.kind && a.value == b.value && a.distance == b.distance;
}

/// What a constraint without marks misses, in its unit: numbers that should be 0.
[[nodiscard]] std::vector<camera::Expr> shape_misses(const Constraint& constraint,
                                                     const camera::RayExpressions& ray);

}  // namespace balcony::solve
