// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "lang/names/scope.hpp"

namespace balcony::lang {

/// The grey value of an image at a point. Mistakes are reported; the value has then failed.
[[nodiscard]] Value evaluate_grey(const SyntaxTree& tree, const Expression& call, Scope& scope,
                                  const Context& context);

}  // namespace balcony::lang
