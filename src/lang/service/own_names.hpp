// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The names that a text declares, with the parts of it where they are known.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lang/syntax/syntax.hpp"

namespace balcony::lang {

enum class OwnKind : std::uint8_t { camera, parameter, let, variable, function_parameter };

struct OwnName {
    OwnKind kind = OwnKind::let;
    Identifier name;
    Span scope;  ///< Where it is known; of a camera or a file's let everywhere.
    const DefinitionSyntax* definition = nullptr;  ///< The camera, or the one around it.
    const DefinitionParameter* parameter = nullptr;
    const LetSyntax* let = nullptr;
    Span declaration;  ///< The whole of it.
};

/// In the order of the text. They refer to the tree.
[[nodiscard]] std::vector<OwnName> own_names(const SyntaxTree& tree);

/// The innermost name that is known at an offset, among those of cameras or of values; null if
/// there is none.
[[nodiscard]] const OwnName* find_name(const std::vector<OwnName>& names, std::string_view name,
                                       std::size_t offset, bool of_camera);

}  // namespace balcony::lang
