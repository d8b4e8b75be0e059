// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What constraints on marks miss, as formulas of where these appear.

#include <span>
#include <vector>

#include "balcony/solve.hpp"
#include "solve/dual.hpp"

namespace balcony::solve {

/// A position in the picture with its derivatives.
struct DualPoint {
    Dual x, y;
};

/// What a constraint misses, in its unit, where its marks appear at these positions of a picture of
/// this size. Those of an outline are the outermost() ones.
[[nodiscard]] std::vector<Dual> sighting_misses(const Constraint& constraint,
                                                std::span<const DualPoint> at, const V2d& size);

}  // namespace balcony::solve
