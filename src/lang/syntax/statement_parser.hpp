// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "lang/reporter.hpp"
#include "lang/syntax/expression_parser.hpp"
#include "lang/syntax/keywords.hpp"
#include "lang/syntax/token_stream.hpp"

namespace balcony::lang {

/// Parses statements of cameras and pictures. One with an error is reported and marked as broken;
/// parsing continues with the next.
class StatementParser {
public:
    StatementParser(TokenStream& tokens, ExpressionParser& expressions, Reporter& reporter)
        : tokens_(tokens), expressions_(expressions), reporter_(reporter) {}

    /// Selects the keywords of pictures or of cameras for the following statements.
    void enter(bool in_picture) { in_picture_ = in_picture; }
    [[nodiscard]] const Keyword* keyword_at(const Token& token) const {
        return find_keyword(token, in_picture_);
    }
    /// Parses a name to be defined. A reserved name is reported and returned anyway.
    [[nodiscard]] std::optional<Identifier> new_name(std::string_view what);
    [[nodiscard]] Statement statement(Block block);
    /// { statements }
    [[nodiscard]] std::vector<Statement> block(Block block);

private:
    [[nodiscard]] StatementKind unknown_statement(Block block);
    void misplaced_statement(const Keyword& row, Block block);
    void skip_statement();
    [[nodiscard]] bool body(Statement& made);
    void missing(std::string_view what);
    [[nodiscard]] bool value(Statement& made);
    [[nodiscard]] bool let(Statement& made);
    [[nodiscard]] bool word(Statement& made, std::string_view what);
    [[nodiscard]] bool map(Statement& made);
    [[nodiscard]] bool range_value(MapRange& range);
    [[nodiscard]] bool corners(Statement& made);
    [[nodiscard]] bool frame(Statement& made);
    [[nodiscard]] bool layer(Statement& made);
    [[nodiscard]] bool stages(Statement& made, std::string_view what, bool several);
    [[nodiscard]] bool look(Statement& made, std::string_view what);
    [[nodiscard]] bool opens_next_statement() const;

    TokenStream& tokens_;
    ExpressionParser& expressions_;
    Reporter& reporter_;
    bool in_picture_ = false;
};

}  // namespace balcony::lang
