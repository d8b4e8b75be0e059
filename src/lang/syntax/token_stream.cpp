// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/syntax/token_stream.hpp"

#include <fmt/format.h>

namespace balcony::lang {

namespace {

constexpr std::string_view unit_remedy = "append the unit to its number: 30deg, 0.5rad";

}  // namespace

TokenStream::TokenStream(std::shared_ptr<const SourceText> source, Tokens read, Reporter& reporter)
    : source_(std::move(source)),
      tokens_(std::move(read.tokens)),
      closings_(tokens_.size(), tokens_.size()),
      cut_short_(read.cut_short),
      reporter_(&reporter) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
        if (tokens_[i].is("(")) {
            open.push_back(i);
        } else if (tokens_[i].is(")") && !open.empty()) {
            closings_[open.back()] = i;
            open.pop_back();
        }
    }
}

const Token& TokenStream::behind_parentheses(std::size_t ahead) const {
    const std::size_t opening = std::min(at_ + ahead, tokens_.size() - 1);
    return tokens_[std::min(closings_[opening] + 1, tokens_.size() - 1)];
}

std::string TokenStream::found() const {
    constexpr std::size_t max_shown = 40;
    const Token& token = peek();
    if (token.kind == TokenKind::end) {
        return "the text ends here";
    }
    if (token.kind == TokenKind::text) {
        return "found a text in quotation marks";
    }
    const bool long_text = token.text.size() > max_shown;
    return fmt::format("found '{}{}'", token.text.substr(0, max_shown), long_text ? "..." : "");
}

void TokenStream::error(Span span, std::string message, std::string remedy) const {
    if (!muted_) {
        reporter_->error(at(span), std::move(message), std::move(remedy));
    }
}

void TokenStream::expected(std::string_view what, std::string remedy) const {
    if (!at_reported()) {
        error(peek().span, fmt::format("expected {}, but {}", what, found()),
              at_unit() ? std::string(unit_remedy) : std::move(remedy));
    }
}

bool TokenStream::expect(std::string_view symbol, std::string_view where, std::string remedy) {
    if (accept(symbol)) {
        return true;
    }
    expected(fmt::format("'{}' {}", symbol, where), std::move(remedy));
    return false;
}

// A suggested fix for a missing closing bracket.
std::string TokenStream::closing_remedy(std::string_view symbol) const {
    const Token& token = peek();
    if (at_unit()) {
        return std::string(unit_remedy);
    }
    if (token.is(":") || token.is("=")) {
        return "write name = value, for example radius = 1";
    }
    if (token.is(")") || token.is("]") || token.is("}")) {
        return fmt::format("write '{}' here, or add the opening bracket of '{}' before it", symbol,
                           token.text);
    }
    const bool next_value = token.kind == TokenKind::name || token.kind == TokenKind::number;
    if (symbol != "}" && next_value && !at_new_line()) {
        return "use ',' between arguments, '*' between factors, and parentheses around the "
               "argument of a function: sin(u)";
    }
    return fmt::format("add '{}' {}", symbol, at_end() ? "at the end" : "before this");
}

bool TokenStream::expect_closing(std::string_view symbol, Span opening) {
    if (accept(symbol)) {
        return true;
    }
    if (!at_reported() && !muted_) {
        const char* or_comma = symbol == "}" ? "" : "',' or ";
        Diagnostic diagnostic =
            balcony::error(fmt::format("expected {}'{}', but {}", or_comma, symbol, found()),
                           at(peek().span), closing_remedy(symbol));
        const char* bracket = symbol == "}" ? "{" : symbol == "]" ? "[" : "(";
        diagnostic.notes.push_back({at(opening), fmt::format("the unmatched '{}'", bracket)});
        reporter_->add(std::move(diagnostic));
    }
    return false;
}

}  // namespace balcony::lang
