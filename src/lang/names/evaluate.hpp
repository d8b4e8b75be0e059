// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "lang/names/scope.hpp"

namespace balcony::lang {

/// The number that an expression stands for, with what is wrong reported: a failed value if
/// anything is.
[[nodiscard]] Value evaluate(const SyntaxTree& tree, ExpressionId id, Scope& scope,
                             expr::Graph& graph, Reporter& reporter);

/// The same of a tuple or a list, written or named; nothing if the expression is neither. A name
/// whose value has failed may have been either.
[[nodiscard]] std::optional<Value> evaluate_compound(const SyntaxTree& tree, ExpressionId id,
                                                     Scope& scope, expr::Graph& graph,
                                                     Reporter& reporter);

/// The same of any expression that a name may stand for.
[[nodiscard]] Value evaluate_any(const SyntaxTree& tree, ExpressionId id, Scope& scope,
                                 expr::Graph& graph, Reporter& reporter);

}  // namespace balcony::lang
