// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "lang/reporter.hpp"
#include "lang/syntax/token.hpp"

namespace balcony::lang {

struct Tokens {
    std::vector<Token> tokens;   ///< The last token marks the end.
    std::vector<Span> comments;  ///< With their // or /* */, in order.
    bool cut_short = false;  ///< The tokens are followed by invalid bytes or an unclosed comment.
};

/// Splits a text into tokens. Bytes that are not text (invalid UTF-8, zero bytes) are reported once
/// and give only the end token.
[[nodiscard]] Tokens tokenize(const std::shared_ptr<const SourceText>& source, Reporter& reporter);

}  // namespace balcony::lang
