// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "lang/reporter.hpp"
#include "lang/syntax/token.hpp"

namespace balcony::lang {

struct Tokens {
    std::vector<Token> tokens;   ///< The last one is the end.
    std::vector<Span> comments;  ///< With their // or /* */, in order.
    bool cut_short = false;      ///< What follows the tokens is no text or an unclosed comment.
};

/// Cuts a text into tokens. What is no text at all (other than UTF-8, zero bytes) is reported once
/// and gives no tokens but the end.
[[nodiscard]] Tokens tokenize(const std::shared_ptr<const SourceText>& source, Reporter& reporter);

}  // namespace balcony::lang
