// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What the parser of statements reports of words that open no statement here.

#include <fmt/format.h>

#include "lang/syntax/meant_words.hpp"
#include "lang/syntax/statement_parser.hpp"

namespace balcony::lang {

StatementKind StatementParser::unknown_statement(Block block) {
    const Token& token = tokens_.peek();
    const std::vector<std::string> known = keywords_for(block);
    if (token.is(")") || token.is("]")) {
        tokens_.error(token.span, fmt::format("this '{}' has no opening bracket", token.text),
                      "remove it, or add the opening bracket");
        return StatementKind::unknown;
    }
    if (token.is(",")) {
        tokens_.error(token.span, "unexpected ','",
                      "a ',' separates the ranges of map and the stages of warp, "
                      "move and arrange");
        return StatementKind::unknown;
    }
    const bool is_unit = token.is_name("deg") || token.is_name("rad");
    if (token.kind != TokenKind::name || is_unit) {
        tokens_.expected(fmt::format("a statement ({})", one_of(known)),
                         "write the arguments of a stage in parentheses, for example sphere(1)");
        return StatementKind::unknown;
    }
    if (is_shown_camera(block)) {
        tokens_.error(token.span, "a camera is not defined in a picture",
                      fmt::format("write layer {} to show it", tokens_.peek(1).text));
        return StatementKind::layer;
    }
    tokens_.error(token.span, fmt::format("unknown statement '{}'", token.text),
                  statement_remedy(token.text, block, catalogue_));
    const auto nearest = nearest_name(token.text, known);
    for (const StatementRow& row : statement_rows()) {
        if (nearest && row.keyword == *nearest) {
            return row.kind;
        }
    }
    return StatementKind::unknown;
}

void StatementParser::misplaced_statement(const StatementRow& row, Block block) {
    if (block == Block::path || block == Block::layer) {
        tokens_.error(tokens_.peek().span,
                      fmt::format("'{}' is not allowed in a block of {}", row.keyword,
                                  block == Block::path ? "eye or toward" : "a layer"),
                      fmt::format("move it out of the block, which may contain {}",
                                  one_of(keywords_for(block))));
    } else if (block == Block::picture || block == Block::loop) {
        tokens_.error(tokens_.peek().span,
                      fmt::format("'{}' is allowed in the block of a layer only", row.keyword),
                      fmt::format("write layer NAME {{ {} ... }}", row.keyword));
    } else {
        tokens_.error(tokens_.peek().span,
                      fmt::format("'{}' is allowed in a block of eye or toward only", row.keyword),
                      "write eye { object sphere(1) }, or shorter: eye sphere(1)");
    }
}

// Skips to the next statement or the brace that ends this block.
void StatementParser::skip_statement() {
    int braces = 0;
    while (!tokens_.at_end() && !is_file_keyword(tokens_.peek())) {
        const Token& token = tokens_.peek();
        if (braces == 0 && (token.is("}") || keyword_at(token) != nullptr)) {
            return;
        }
        braces += token.is("{") ? 1 : token.is("}") ? -1 : 0;
        tokens_.next();
    }
}

}  // namespace balcony::lang
