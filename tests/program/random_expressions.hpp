// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <vector>

#include "balcony/expr.hpp"

namespace balcony::program {

using Random = std::mt19937_64;

/// Expressions over random operations, look-ups and natives, all or only those that every runner
/// computes exactly.
std::vector<expr::Expr> random_expressions(expr::Graph& graph, Random& random, std::size_t nodes,
                                           std::size_t roots, bool only_exact);

}  // namespace balcony::program
