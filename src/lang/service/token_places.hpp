// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The brackets and statements around each token of a text. Unlike the syntax tree, they are known
// of a text that is being written, too: one with unclosed brackets or unfinished statements.

#include <cstddef>
#include <optional>
#include <vector>

#include "lang/syntax/lexer.hpp"
#include "lang/syntax/statement_rows.hpp"

namespace balcony::lang {

class TokenPlaces {
public:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /// Indices of tokens; none where there is no such token.
    struct Around {
        std::size_t opening = none;    ///< Opens the innermost bracket.
        std::size_t statement = none;  ///< Begins the innermost statement or item.
    };

    explicit TokenPlaces(const std::shared_ptr<const SourceText>& source);

    [[nodiscard]] const std::vector<Token>& tokens() const { return tokens_.tokens; }
    [[nodiscard]] const Token& operator[](std::size_t i) const { return tokens_.tokens[i]; }
    [[nodiscard]] const Tokens& read() const { return tokens_; }

    /// Around the token itself.
    [[nodiscard]] Around at(std::size_t i) const { return at_[i]; }
    /// Between token i - 1 and what follows it.
    [[nodiscard]] Around before(std::size_t i) const { return i == 0 ? Around{} : after_[i - 1]; }
    /// The token that closes what token i opens; none if it stays open.
    [[nodiscard]] std::size_t closing(std::size_t i) const { return closing_[i]; }
    /// What the brace of token i opens; nothing if that is not known.
    [[nodiscard]] std::optional<Block> block(std::size_t i) const { return blocks_[i]; }
    /// The statements that enclose a place, from the inside.
    [[nodiscard]] std::optional<Block> block_around(Around place) const;
    /// Of the token that begins a statement; null for an item.
    [[nodiscard]] const StatementRow* row(std::size_t i) const { return rows_[i]; }
    /// The first token that ends behind an offset; the end token if there is none.
    [[nodiscard]] std::size_t first_behind(std::size_t offset) const;
    [[nodiscard]] bool at_new_line(std::size_t i) const;

private:
    struct Frame {
        std::size_t opening = none;
        bool is_brace = true;  ///< The file, too.
        std::optional<Block> block{};
        std::size_t statement = none;
    };
    void visit(std::size_t i, std::vector<Frame>& frames);
    [[nodiscard]] bool begins_item(std::size_t i) const;
    [[nodiscard]] const StatementRow* begun_by(std::size_t i, Block block) const;
    [[nodiscard]] std::optional<Block> opened_by(std::size_t i, const Frame& around) const;
    static Around around(const std::vector<Frame>& frames);

    std::shared_ptr<const SourceText> source_;
    Tokens tokens_;
    std::vector<Around> at_, after_;
    std::vector<std::size_t> closing_;
    std::vector<std::optional<Block>> blocks_;
    std::vector<const StatementRow*> rows_;
};

}  // namespace balcony::lang
