// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/token_stream.hpp"

#include <fmt/format.h>

namespace balcony::lang {

std::string TokenStream::found() const {
    constexpr std::size_t longest_shown = 40;
    const Token& token = peek();
    if (token.kind == TokenKind::end) {
        return "the text ends here";
    }
    if (token.kind == TokenKind::text) {
        return "found a text in quotation marks";
    }
    const bool long_text = token.text.size() > longest_shown;
    return fmt::format("found '{}{}'", token.text.substr(0, longest_shown), long_text ? "..." : "");
}

void TokenStream::error(Span span, std::string message, std::string remedy) const {
    reporter_->error(at(span), std::move(message), std::move(remedy));
}

void TokenStream::expected(std::string_view what, std::string remedy) const {
    if (!at_reported()) {
        error(peek().span, fmt::format("expected {}, but {}", what, found()), std::move(remedy));
    }
}

bool TokenStream::expect(std::string_view symbol, std::string_view where) {
    if (accept(symbol)) {
        return true;
    }
    expected(fmt::format("'{}' {}", symbol, where));
    return false;
}

bool TokenStream::expect_closing(std::string_view symbol, Span opening) {
    if (accept(symbol)) {
        return true;
    }
    if (!at_reported()) {
        const char* or_comma = symbol == "}" ? "" : "',' or ";
        Diagnostic diagnostic = balcony::error(
            fmt::format("expected {}'{}', but {}", or_comma, symbol, found()), at(peek().span));
        const char* bracket = symbol == "}" ? "{" : symbol == "]" ? "[" : "(";
        diagnostic.notes.push_back(
            {at(opening), fmt::format("this is the '{}' to close", bracket)});
        reporter_->add(std::move(diagnostic));
    }
    return false;
}

}  // namespace balcony::lang
