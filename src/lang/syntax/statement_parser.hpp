// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "lang/reporter.hpp"
#include "lang/syntax/expression_parser.hpp"
#include "lang/syntax/statement_rows.hpp"
#include "lang/syntax/token_stream.hpp"

namespace balcony::lang {

/// Parses parameters and statements of cameras and pictures. One with an error is reported and
/// marked as broken; parsing continues with the next.
class StatementParser {
public:
    StatementParser(TokenStream& tokens, ExpressionParser& expressions,
                    const camera::Catalogue& catalogue, Reporter& reporter)
        : tokens_(tokens), expressions_(expressions), catalogue_(catalogue), reporter_(reporter) {}

    /// Selects the keywords of pictures or of cameras for the following statements.
    void enter(bool in_picture) { in_picture_ = in_picture; }
    [[nodiscard]] const StatementRow* keyword_at(const Token& token) const {
        return find_statement(token, in_picture_ ? Block::picture : Block::camera);
    }
    /// Parses a name to be defined. A reserved name is reported and returned anyway.
    [[nodiscard]] std::optional<Identifier> new_name(std::string_view what);
    [[nodiscard]] Statement statement(Block block);
    /// A let without its keyword, which has been reported.
    [[nodiscard]] Statement unmarked_let();
    /// The parameters of a camera or a picture, in parentheses. After an error it is broken.
    void parameters(DefinitionSyntax& camera);
    /// { statements }
    [[nodiscard]] std::vector<Statement> block(Block block);

private:
    [[nodiscard]] bool parameter(DefinitionSyntax& camera);
    [[nodiscard]] bool limits(DefinitionParameter& parameter);
    void skip_parameters(DefinitionSyntax& camera);
    [[nodiscard]] StatementKind unknown_statement(Block block);
    void misplaced_statement(const StatementRow& row, Block block);
    void skip_statement();
    [[nodiscard]] bool body(const StatementRow& row, Statement& made);
    void missing(std::string_view what);
    [[nodiscard]] bool let(Statement& made);
    [[nodiscard]] bool function_parameters(LetSyntax& function);
    [[nodiscard]] std::optional<ExpressionId> value_on_line();
    [[nodiscard]] bool value(Statement& made);
    [[nodiscard]] bool word(const StatementRow& row, Statement& made);
    [[nodiscard]] bool ranges(Statement& made);
    [[nodiscard]] bool next_range();
    template <class Range>
    [[nodiscard]] bool ends_of(Range& range);
    [[nodiscard]] bool corners(Statement& made);
    [[nodiscard]] bool optional_corners(Statement& made);
    [[nodiscard]] bool objects(const StatementRow& row, Statement& made);
    [[nodiscard]] bool blend(const StatementRow& row, Statement& made);
    [[nodiscard]] bool placements(const StatementRow& row, Statement& made);
    [[nodiscard]] std::optional<ExpressionId> placement(const StatementRow& row);
    [[nodiscard]] bool assignments(Statement& made);
    [[nodiscard]] bool assigned_names(Assignment& assignment);
    [[nodiscard]] bool expect_corner();
    [[nodiscard]] bool loop(Statement& made);
    void read_statement(Block block, std::vector<Statement>& read);
    [[nodiscard]] bool is_shown_camera(Block block) const;
    [[nodiscard]] bool takes_bare_number(const StatementRow& row, std::string_view stage);
    [[nodiscard]] bool stages(const StatementRow& row, Statement& made);
    [[nodiscard]] std::optional<std::string> bare_formula_remedy(const StatementRow& row) const;
    [[nodiscard]] std::optional<ExpressionId> stage(const StatementRow& row);
    [[nodiscard]] bool names_stage(const StatementRow& row) const;
    [[nodiscard]] bool morph(const StatementRow& row, Statement& made);
    [[nodiscard]] bool layer(const StatementRow& row, Statement& made);
    [[nodiscard]] bool opens_next_statement() const;

    TokenStream& tokens_;
    ExpressionParser& expressions_;
    const camera::Catalogue& catalogue_;
    Reporter& reporter_;
    bool in_picture_ = false;
    std::size_t loops_ = 0;  // How many loops enclose the current statement.
};

}  // namespace balcony::lang
