// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What there is to say about words of the language.

#include <span>
#include <string>
#include <string_view>

#include "balcony/catalogue.hpp"
#include "lang/service/own_names.hpp"
#include "lang/syntax/statement_rows.hpp"

namespace balcony::lang {

/// "radius = 1: number, above 0"
[[nodiscard]] std::string parameter_text(const camera::StageParameter& parameter);
/// One line about a statement.
[[nodiscard]] std::string meaning_of(const StatementRow& row);
/// A parameter as it is declared: "fov = 60deg from 1deg to 179deg".
[[nodiscard]] std::string declaration_text(const SyntaxTree& tree,
                                           const DefinitionParameter& parameter);
/// How a name of a text is declared, without the statements of a camera.
[[nodiscard]] std::string signature_of(const SyntaxTree& tree, const OwnName& own);
/// camera wide(fov = 60deg), or camera wide = fisheye(fov = 200deg)
[[nodiscard]] std::string signature_of(const SyntaxTree& tree, const DefinitionSyntax& camera);
/// The first line of the comment that a text begins with.
[[nodiscard]] std::string_view first_line(std::string_view text);
/// "atan2(a, b)"
[[nodiscard]] std::string function_signature(std::string_view name);
/// One line about a function or a constant of the language; may be empty.
[[nodiscard]] std::string_view function_meaning(std::string_view name);

}  // namespace balcony::lang
