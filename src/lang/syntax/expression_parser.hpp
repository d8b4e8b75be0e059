// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "lang/syntax/syntax.hpp"
#include "lang/syntax/token_stream.hpp"

namespace balcony::lang {

/// Parses expressions and stage calls into a tree's list of nodes. An error is reported once and
/// ends the parsing; the caller finds the position to continue.
class ExpressionParser {
public:
    ExpressionParser(TokenStream& tokens, std::vector<Expression>& nodes)
        : tokens_(tokens), nodes_(nodes) {}

    /// Any expression, from a number to a condition.
    [[nodiscard]] std::optional<ExpressionId> expression();
    /// name, name(arguments) or name(parameters) = [results].
    [[nodiscard]] std::optional<ExpressionId> stage(std::string_view what);
    /// The same, or name word word, all on one line.
    [[nodiscard]] std::optional<ExpressionId> stage_with_words(std::string_view what);

    /// Adds the call of a stage that is written in another way. Its arguments and their parts are
    /// the nodes from `first` on, which was next() before they were read.
    [[nodiscard]] ExpressionId add_call(const Identifier& name, std::vector<Argument> arguments,
                                        std::size_t first);
    [[nodiscard]] std::size_t next() const { return nodes_.size(); }

private:
    [[nodiscard]] std::optional<ExpressionId> binary(int min_precedence);
    [[nodiscard]] std::optional<ExpressionId> unary();
    [[nodiscard]] std::optional<ExpressionId> power();
    [[nodiscard]] std::optional<ExpressionId> primary();
    [[nodiscard]] std::optional<ExpressionId> element();
    [[nodiscard]] std::string missing_value_remedy() const;
    [[nodiscard]] std::optional<ExpressionId> parenthesised();
    [[nodiscard]] std::optional<ExpressionId> list();
    [[nodiscard]] std::optional<ExpressionId> name_or_call();
    [[nodiscard]] std::optional<ExpressionId> formula(Expression call);
    [[nodiscard]] std::optional<std::vector<Argument>> arguments(Span opening);
    [[nodiscard]] bool at_word() const;
    ExpressionId add_name(const Token& name, ExpressionKind kind = ExpressionKind::name);
    ExpressionId add(Expression node, std::size_t first);
    std::optional<ExpressionId> add_operation(const Token& symbol, std::size_t first,
                                              std::vector<ExpressionId> operands);
    [[nodiscard]] bool too_deep();

    TokenStream& tokens_;
    std::vector<Expression>& nodes_;
    int depth_ = 0;
};

}  // namespace balcony::lang
