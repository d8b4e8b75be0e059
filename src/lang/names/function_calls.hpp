// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "lang/names/scope.hpp"

namespace balcony::lang {

/// What a call in an expression calls; one of these.
struct Callee {
    const camera::FormulaFunction* offered = nullptr;  ///< Of the stage around a formula.
    Definition* let = nullptr;                         ///< A function that a file defines.
    const Function* built_in = nullptr;
    /// One whose arguments are not all numbers: keys or grey.
    Value (*special)(const SyntaxTree& tree, const Expression& call, Scope& scope,
                     const Context& context) = nullptr;
};

/// Finds the function of a name. A function of a file hides a built-in one. All members are null if
/// there is none.
[[nodiscard]] Callee find_callee(std::string_view name, Scope& scope);

/// Whether a node calls a function that a file defines.
[[nodiscard]] bool calls_let(const Expression& node, Scope& scope);
/// Whether a node calls count.
[[nodiscard]] bool calls_count(const Expression& node, Scope& scope);

/// Whether a node calls a special function.
[[nodiscard]] bool calls_special(const Expression& node, Scope& scope);

/// Checks that the function of a call exists and takes its arguments. Returns false after an error,
/// which is reported.
[[nodiscard]] bool check_call(const SyntaxTree& tree, const Expression& call, Scope& scope,
                              const Context& context);

/// How a function of the language is called: atan2(a, b).
[[nodiscard]] std::string call_of(std::string_view name, std::size_t arity);
/// How a function is called: ratio(x, y).
[[nodiscard]] std::string signature(const LetFunction& function);

/// Checks a function that is to be defined: its parameters, and what of its body does not depend on
/// them. Returns false after an error in the parameters, which is reported as all others are.
[[nodiscard]] bool check_function(const LetFunction& function, const Context& context);

}  // namespace balcony::lang
