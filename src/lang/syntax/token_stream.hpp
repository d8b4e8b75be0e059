// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>

#include "lang/reporter.hpp"
#include "lang/syntax/lexer.hpp"

namespace balcony::lang {

/// The tokens that parsers read, with functions for their common messages.
class TokenStream {
public:
    TokenStream(std::shared_ptr<const SourceText> source, Tokens read, Reporter& reporter);

    [[nodiscard]] const Token& peek(std::size_t ahead = 0) const {
        return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
    }
    /// What follows the parenthesis that opens `ahead` and closes somewhere; the end if it does
    /// not.
    [[nodiscard]] const Token& behind_parentheses(std::size_t ahead) const;
    [[nodiscard]] const Token& previous() const { return tokens_[at_ == 0 ? 0 : at_ - 1]; }
    /// Whether the next token is, or is preceded by, text that the lexer has reported.
    [[nodiscard]] bool at_reported() const {
        return peek().kind == TokenKind::stray || (cut_short_ && at_end());
    }
    /// Whether a line break precedes the next token.
    [[nodiscard]] bool at_new_line() const {
        const std::size_t begin = previous().span.end;
        return source_->text().substr(begin, peek().span.begin - begin).find('\n') !=
               std::string_view::npos;
    }
    [[nodiscard]] bool at_end() const { return peek().kind == TokenKind::end; }
    const Token& next() {
        const Token& token = peek();
        at_ += at_ + 1 < tokens_.size() ? 1 : 0;
        return token;
    }
    /// Skips a symbol if it is the next token.
    bool accept(std::string_view symbol) {
        const bool found = peek().is(symbol);
        if (found) {
            next();
        }
        return found;
    }

    /// Errors are not said while this is set: they follow from one that has been.
    void mute(bool muted) { muted_ = muted; }
    [[nodiscard]] bool muted() const { return muted_; }
    void error(Span span, std::string message, std::string remedy = {}) const;
    /// Reports what is expected instead of the next token, unless the lexer has already
    /// reported an error there.
    void expected(std::string_view what, std::string remedy = {}) const;
    /// Skips a symbol or reports that it is missing.
    bool expect(std::string_view symbol, std::string_view where, std::string remedy);
    /// Skips a closing bracket or reports that it is missing, with the opening bracket.
    bool expect_closing(std::string_view symbol, Span opening);

    [[nodiscard]] SourceSpan at(Span span) const { return {source_, span.begin, span.end}; }
    [[nodiscard]] std::string found() const;

private:
    [[nodiscard]] bool at_unit() const { return peek().is_name("deg") || peek().is_name("rad"); }
    [[nodiscard]] std::string closing_remedy(std::string_view symbol) const;

    std::shared_ptr<const SourceText> source_;
    std::vector<Token> tokens_;
    std::vector<std::size_t> closings_;  ///< Of the parentheses, by the tokens that open them.
    bool cut_short_;
    Reporter* reporter_;
    std::size_t at_ = 0;
    bool muted_ = false;
};

}  // namespace balcony::lang
