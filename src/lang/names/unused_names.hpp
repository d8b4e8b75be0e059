// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "lang/reporter.hpp"
#include "lang/syntax/syntax.hpp"

namespace balcony::lang {

/// "function" or "let".
[[nodiscard]] std::string_view word_for(const LetSyntax& let);

/// Warns about a name that has been defined in vain; `what` it is.
void warn_of_unused(const SyntaxTree& tree, const Identifier& name, std::string_view what,
                    Reporter& reporter);

/// Warns about parameters that the body of a function does not use.
void warn_of_unused_parameters(const SyntaxTree& tree, const LetSyntax& let, Reporter& reporter);

/// Warns about the variables and lets of a loop and those in it.
void warn_of_unused_in_loop(const SyntaxTree& tree, const Statement& loop, Reporter& reporter);

}  // namespace balcony::lang
