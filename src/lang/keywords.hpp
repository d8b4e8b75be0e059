// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lang/syntax.hpp"

namespace balcony::lang {

/// A word that opens a statement, and where it may stand.
struct Keyword {
    StatementKind kind;
    std::string_view text;
    bool in_path;    ///< In eye { ... } and toward { ... }.
    bool in_camera;  ///< In a camera itself.
};

[[nodiscard]] std::span<const Keyword> keywords();
/// The row of a token; null if it is no such word.
[[nodiscard]] const Keyword* find_keyword(const Token& token);
/// Whether a token is import or camera.
[[nodiscard]] bool is_file_keyword(const Token& token);
[[nodiscard]] std::vector<std::string> keywords_for(bool in_path);
/// How a statement is written; empty for an unknown one.
[[nodiscard]] std::string_view keyword(StatementKind kind);

}  // namespace balcony::lang
