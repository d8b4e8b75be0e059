// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "lang/scope.hpp"

namespace balcony::lang {

/// The value of an expression, with what is wrong reported: a failed one if anything is.
[[nodiscard]] Value evaluate(const SyntaxTree& tree, ExpressionId id, Scope& scope,
                             expr::Graph& graph, Reporter& reporter);

}  // namespace balcony::lang
