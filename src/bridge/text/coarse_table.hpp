// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "balcony/expr.hpp"

namespace balcony::bridge {

/// A table with fewer cells, for texts in single precision: the same function of one variable
/// within four units in the last place of its largest value, by cubic pieces; the table itself if
/// it cannot be coarser or has several variables. Outside its cells it extrapolates another
/// polynomial.
[[nodiscard]] std::shared_ptr<const expr::Table> coarse_table(
    const std::shared_ptr<const expr::Table>& table);

}  // namespace balcony::bridge
