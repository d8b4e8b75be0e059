// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/catalogue.hpp"
#include "lang/syntax/syntax.hpp"

namespace balcony::lang {

/// Blocks that contain statements.
enum class Block : std::uint8_t {
    camera = 1,
    path = 2,  ///< eye { ... } and toward { ... }
    picture = 4,
    layer = 8,
};

/// A word that starts a statement, and the Blocks in which it is allowed.
struct Keyword {
    StatementKind kind;
    std::string_view text;
    std::uint8_t blocks;
    std::string_view meaning{};  ///< A description, if no stage in the statement provides one.

    [[nodiscard]] constexpr bool stands_in(Block block) const {
        return (blocks & static_cast<std::uint8_t>(block)) != 0;
    }
};

[[nodiscard]] std::span<const Keyword> keywords();
/// The row of a token that starts a statement in a camera and its paths, or in a picture and its
/// layers; null for other tokens.
[[nodiscard]] const Keyword* find_keyword(const Token& token, bool in_picture);
/// Whether a token is import, camera or picture.
[[nodiscard]] bool is_file_keyword(const Token& token);
[[nodiscard]] std::vector<std::string> keywords_for(Block block);
/// The keyword of a statement; empty for an unknown one.
[[nodiscard]] std::string_view keyword(StatementKind kind);
/// The meaning in the keyword's row.
[[nodiscard]] std::string_view meaning_of(StatementKind kind);
/// The statements that take stages of a kind.
[[nodiscard]] std::vector<std::string> statements_for(camera::StageKind kind);

}  // namespace balcony::lang
