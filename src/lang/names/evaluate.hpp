// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "lang/names/scope.hpp"

namespace balcony::lang {

/// The number of an expression. Mistakes are reported; the value has then failed.
[[nodiscard]] Value evaluate(const SyntaxTree& tree, ExpressionId id, Scope& scope,
                             const Context& context);

/// The value of a tuple or a list: literal, named, an element of a list, or the result of a
/// function; nothing if the expression is neither. One that has failed may be either.
[[nodiscard]] std::optional<Value> evaluate_compound(const SyntaxTree& tree, ExpressionId id,
                                                     Scope& scope, const Context& context);

/// The value of any expression that can be named.
[[nodiscard]] Value evaluate_any(const SyntaxTree& tree, ExpressionId id, Scope& scope,
                                 const Context& context);

}  // namespace balcony::lang
