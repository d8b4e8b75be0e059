// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "balcony/expr.hpp"

namespace balcony::expr {

/// What an operation on these arguments can be written as more simply, looking no further than
/// the arguments' own arguments; no node if nothing applies.
[[nodiscard]] Expr apply_local_rules(Graph& graph, Op op, std::span<const Expr> arguments);

}  // namespace balcony::expr
