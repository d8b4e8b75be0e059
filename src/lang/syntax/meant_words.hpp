// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is meant by words that are not in the language, but in other programs.

#include <optional>
#include <string>
#include <string_view>

#include "balcony/catalogue.hpp"
#include "lang/syntax/statement_rows.hpp"

namespace balcony::lang {

/// A remedy for a word that opens no statement in a block.
[[nodiscard]] std::string statement_remedy(std::string_view word, Block block,
                                           const camera::Catalogue& catalogue);
/// A remedy for a word that opens no definition.
[[nodiscard]] std::string item_remedy(std::string_view word);
/// What to write for a word in the place of a stage; nothing if it has no known meaning.
[[nodiscard]] std::optional<std::string> stage_remedy(camera::StageKind kind,
                                                      std::string_view word);

/// What to write instead of a bare formula, such as (cos(u), sin(u), v), for an object or a
/// direction rule. `numbers` is its text without the brackets, and `depends` whether it has u or v.
[[nodiscard]] std::string instead_of_formula(camera::StageKind kind, std::string_view numbers,
                                             bool depends);

}  // namespace balcony::lang
