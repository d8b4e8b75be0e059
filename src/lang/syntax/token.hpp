// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string_view>

namespace balcony::lang {

/// Bytes [begin, end) of the current source.
struct Span {
    std::size_t begin = 0;
    std::size_t end = 0;
};

enum class TokenKind : std::uint8_t {
    end,
    name,
    number,
    text,    ///< A file name in double quotes.
    symbol,  ///< An operator, a bracket, ...
    stray,   ///< Invalid text that the lexer has reported.
};

enum class NumberUnit : std::uint8_t { none, degrees, radians };

/// The value of a number in degrees is this many times the number.
inline constexpr double radians_per_degree = std::numbers::pi / 180.0;

struct Token {
    TokenKind kind = TokenKind::end;
    Span span;
    std::string_view text;  ///< The source text; for a text token, the part inside the quotes.
    double value = 0.0;     ///< The value of a number, without its unit.
    NumberUnit unit = NumberUnit::none;

    [[nodiscard]] bool is(std::string_view symbol) const {
        return kind == TokenKind::symbol && text == symbol;
    }
    [[nodiscard]] bool is_name(std::string_view name) const {
        return kind == TokenKind::name && text == name;
    }
};

}  // namespace balcony::lang
