// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "lang/names/scope.hpp"

namespace balcony::lang {

/// A value between keyframes: a number, or a tuple if the keys have several numbers. Mistakes are
/// reported; the value has then failed.
[[nodiscard]] Value evaluate_keys(const SyntaxTree& tree, const Expression& call, Scope& scope,
                                  const Context& context);

}  // namespace balcony::lang
