// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// One row for each kind of statement. The parser, the layout, explanations and messages are derived
// from the rows.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/catalogue.hpp"
#include "lang/syntax/syntax.hpp"

namespace balcony::lang {

/// What statements stand in.
enum class Block : std::uint8_t {
    camera = 1,
    path = 2,  ///< eye { ... } and toward { ... }
    picture = 4,
    layer = 8,
    loop = 16,  ///< for i in 0 .. 6 { ... }
};

/// The syntax after the keyword, which determines the content of a statement.
enum class Shape : std::uint8_t {
    let,       ///< name = expression
    value,     ///< An expression.
    equation,  ///< = expression
    word,      ///< One word.
    nothing,   ///< The keyword says it all.
    ranges,    ///< u = first .. last, v = square
    corners,   ///< (a, b) .. (c, d)
    shown,     ///< Corners, or a call of objects: show objects("vase*").
    objects,   ///< A call of objects.
    blend,     ///< One word, or what it is done by: by depth.
    optional_corners,
    placements,   ///< Corners and stages with commas between them; corners are the stage `place`.
    stage,        ///< A stage.
    stages,       ///< Stages with commas between them.
    rule,         ///< A stage, or its name with words behind it: normal outward.
    path,         ///< A stage, or a block.
    layer,        ///< The name of a camera or a picture, with or without a block.
    loop,         ///< name in first .. last, or name in list, and a block.
    assignments,  ///< name = value, (name, name) = value
    morph,        ///< Two cameras and named arguments: A .. B, amount = 1/2.
    call,         ///< The keyword itself is what is called: frame(0.01).
};

struct StatementRow {
    StatementKind kind = StatementKind::unknown;
    std::string_view keyword{};
    std::uint8_t blocks = 0;  ///< Where it may stand: a set of Blocks.
    Shape shape = Shape::value;
    bool once = true;  ///< There is one at most in a block.
    /// When it happens to a point of the picture or to a layer; of one phase as written. None if it
    /// is no step of that way.
    std::optional<int> phase{};
    std::optional<camera::StageKind> stage_kind{};  ///< What stands in it.
    std::string_view expected{};                    ///< What is missing if nothing follows.
    std::string_view meaning{};  ///< One line for people, where no stage in it says what it does.

    [[nodiscard]] constexpr bool stands_in(Block block) const {
        return (blocks & static_cast<std::uint8_t>(block)) != 0;
    }
};

[[nodiscard]] std::span<const StatementRow> statement_rows();
/// Null for an unknown statement.
[[nodiscard]] const StatementRow* row_of(StatementKind kind);
/// The row of a token that opens a statement in a camera and its paths, or in a picture and its
/// layers; null if it does not. If a keyword has several rows, it is the one of the block.
[[nodiscard]] const StatementRow* find_statement(const Token& token, Block block);
/// Whether a token is import, camera or picture.
[[nodiscard]] bool is_file_keyword(const Token& token);
[[nodiscard]] std::vector<std::string> keywords_for(Block block);
/// How a statement is written; empty for an unknown one.
[[nodiscard]] std::string_view keyword(StatementKind kind);
/// The statements that stages of a kind belong to.
[[nodiscard]] std::vector<std::string> statements_for(camera::StageKind kind);

}  // namespace balcony::lang
