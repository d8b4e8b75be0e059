// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "balcony/expr.hpp"

namespace balcony::expr {

/// A simpler form of an operation on these arguments, using only
/// the arguments' own arguments; an invalid node if no rule applies.
[[nodiscard]] Expr apply_local_rules(Graph& graph, Op op, std::span<const Expr> arguments);

}  // namespace balcony::expr
