// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/syntax/statement_parser.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "balcony/catalogue.hpp"

namespace balcony::lang {

namespace {

// Globally reserved names.
constexpr std::array<std::string_view, 2> constants = {"pi", "t"};

// Suggests a fix for a word that starts no statement: a range, a stage, or a misspelled keyword.
std::string statement_suggestion(std::string_view word, const std::vector<std::string>& known) {
    const auto opens = [&known](const std::string& statement) {
        return std::find(known.begin(), known.end(), statement) != known.end();
    };
    if ((word == "u" || word == "v") && opens("map")) {
        return "write both ranges in one map, separated by ',': map u = -1 .. 1, v = -1 .. 1";
    }
    std::vector<std::string> with_statement;
    for (const camera::StageEntry& row : camera::catalogue()) {
        for (const std::string& statement : statements_for(row.kind)) {
            if (row.name == word && opens(statement)) {
                with_statement.push_back(fmt::format("{} {}", statement, word));
            }
        }
    }
    return with_statement.empty() ? suggestion(word, known, "the statements are")
                                  : fmt::format("write {}", one_of(with_statement));
}

}  // namespace

std::optional<Identifier> StatementParser::new_name(std::string_view what) {
    const Token& token = tokens_.peek();
    const bool constant =
        std::find(constants.begin(), constants.end(), token.text) != constants.end();
    const bool opens_statement = keyword_at(token) != nullptr || is_file_keyword(token);
    const Token& after = tokens_.peek(1);
    const bool meant_as_name = after.is("=") || after.is("{") || after.is("(");
    if (token.kind != TokenKind::name || (opens_statement && !meant_as_name)) {
        tokens_.expected(what, "names consist of letters, digits and _, and start with a letter");
        return std::nullopt;
    }
    if (constant || opens_statement) {
        tokens_.error(token.span,
                      fmt::format("'{}' is reserved: it {}", token.text,
                                  token.text == "t"    ? "is time"
                                  : token.text == "pi" ? "is the number 3.14159..."
                                                       : "starts a statement"),
                      "choose another name");
    }
    tokens_.next();
    return Identifier{token.text, token.span};
}

std::vector<Statement> StatementParser::block(Block block) {
    const Span opening = tokens_.next().span;
    std::vector<Statement> read;
    while (!tokens_.at_end() && !tokens_.peek().is("}") && !is_file_keyword(tokens_.peek()) &&
           !reporter_.full()) {
        read.push_back(statement(block));
    }
    const bool hidden = tokens_.at_end() && tokens_.at_reported();
    if (!reporter_.full()) {
        tokens_.expect_closing("}", opening);
    }
    if (hidden || reporter_.full()) {
        Statement unread;
        unread.broken = true;
        read.push_back(std::move(unread));
    }
    return read;
}

// ------------------------------------------------------------------------------- statement

Statement StatementParser::statement(Block block) {
    const Token& token = tokens_.peek();
    const Keyword* row = keyword_at(token);
    Statement made;
    made.keyword = token.span;
    if (row == nullptr || !row->stands_in(block)) {
        made.kind = row != nullptr ? row->kind : unknown_statement(block);
        if (row != nullptr) {
            misplaced_statement(*row, block);
        }
        made.broken = true;
        tokens_.next();
    } else {
        made.kind = row->kind;
        // The keyword of a frame is the name of its call.
        if (made.kind != StatementKind::frame) {
            tokens_.next();
        }
        made.broken = !body(made);
    }
    if (made.broken) {
        skip_statement();
    }
    made.span = {made.keyword.begin, tokens_.previous().span.end};
    return made;
}

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
    if (token.kind != TokenKind::name) {
        tokens_.expected(fmt::format("a statement ({})", one_of(known)),
                         "write the arguments of a stage in parentheses, for example sphere(1)");
        return StatementKind::unknown;
    }
    tokens_.error(token.span, fmt::format("unknown statement '{}'", token.text),
                  statement_suggestion(token.text, known));
    const auto nearest = nearest_name(token.text, known);
    for (const Keyword& row : keywords()) {
        if (nearest && row.text == *nearest) {
            return row.kind;
        }
    }
    return StatementKind::unknown;
}

void StatementParser::misplaced_statement(const Keyword& row, Block block) {
    if (block == Block::path || block == Block::layer) {
        tokens_.error(tokens_.peek().span,
                      fmt::format("'{}' is not allowed in a block of {}", row.text,
                                  block == Block::path ? "eye or toward" : "a layer"),
                      fmt::format("move it out of the block, which may contain {}",
                                  one_of(keywords_for(block))));
    } else if (block == Block::picture) {
        tokens_.error(tokens_.peek().span,
                      fmt::format("'{}' is allowed in the block of a layer only", row.text),
                      fmt::format("write layer NAME {{ {} ... }}", row.text));
    } else {
        tokens_.error(tokens_.peek().span,
                      fmt::format("'{}' is allowed in a block of eye or toward only", row.text),
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

bool StatementParser::body(Statement& made) {
    switch (made.kind) {
        case StatementKind::let: return let(made);
        case StatementKind::aspect: return value(made);
        case StatementKind::axes: return word(made, "'z_up' or 'y_up' after 'axes'");
        case StatementKind::map: return map(made);
        case StatementKind::eye:
        case StatementKind::toward:
            if (tokens_.peek().is("{")) {
                made.block = this->block(Block::path);
                return true;
            }
            return stages(made, "an object, such as sphere(1)", false);
        case StatementKind::object: return stages(made, "an object, such as sphere(1)", false);
        case StatementKind::warp:
            return stages(made, "a parameter transformer, such as rotate(10deg)", true);
        case StatementKind::move:
            return stages(made, "an object transformer, such as translate(0, 0, 1)", true);
        case StatementKind::look: return look(made, "a direction rule, such as normal");
        case StatementKind::arrange:
            return stages(made, "a picture arranger, such as rotate(8deg)", true);
        case StatementKind::place:
        case StatementKind::leader: return corners(made);
        case StatementKind::clip: return stages(made, "a clip shape, such as ellipse", false);
        case StatementKind::soft:
        case StatementKind::alpha: return value(made);
        case StatementKind::blend: return word(made, "a blend mode, such as multiply");
        case StatementKind::frame: return frame(made);
        case StatementKind::layer: return layer(made);
        case StatementKind::unknown: break;
    }
    return false;
}

// Reports that the expected part of a statement is missing.
void StatementParser::missing(std::string_view what) {
    const std::string_view before = tokens_.previous().text;
    tokens_.expected(what, before == "," ? "remove the ',' before it, or add the missing part"
                                         : fmt::format("write it after '{}'", before));
}

bool StatementParser::value(Statement& made) {
    const auto read = expressions_.expression();
    if (read) {
        made.value = *read;
    }
    return read.has_value();
}

bool StatementParser::let(Statement& made) {
    const auto name = new_name("a name after 'let'");
    if (!name) {
        return false;
    }
    made.name = *name;
    return tokens_.expect("=", "after the name", "for example let width = 4") && value(made);
}

bool StatementParser::word(Statement& made, std::string_view what) {
    const Token& token = tokens_.peek();
    if (token.kind != TokenKind::name || keyword_at(token) != nullptr) {
        missing(what);
        return false;
    }
    made.name = {token.text, token.span};
    tokens_.next();
    return true;
}

bool StatementParser::map(Statement& made) {
    do {
        const Token& coordinate = tokens_.peek();
        if (coordinate.kind != TokenKind::name || keyword_at(coordinate) != nullptr) {
            tokens_.expected("'u' or 'v'", "for example map u = -1 .. 1, v = square");
            return false;
        }
        MapRange range;
        range.coordinate = {coordinate.text, coordinate.span};
        tokens_.next();
        if (!tokens_.expect("=", fmt::format("after '{}'", coordinate.text),
                            "for example map u = -1 .. 1, v = square") ||
            !range_value(range)) {
            return false;
        }
        range.span = {coordinate.span.begin, tokens_.previous().span.end};
        made.ranges.push_back(range);
    } while (tokens_.accept(","));
    return true;
}

bool StatementParser::range_value(MapRange& range) {
    if (tokens_.peek().is_name("square") && !tokens_.peek(1).is("..")) {
        tokens_.next();
        return true;
    }
    if (tokens_.peek().is("[")) {
        tokens_.expected("a range", "a range is written -1 .. 1");
        return false;
    }
    const auto first = expressions_.expression();
    if (!first ||
        !tokens_.expect("..", "between the two ends of the range", "a range is written -1 .. 1")) {
        return false;
    }
    const auto last = expressions_.expression();
    if (!last) {
        return false;
    }
    range.first = *first;
    range.last = *last;
    return true;
}

// (a, b) .. (c, d)
bool StatementParser::corners(Statement& made) {
    if (!tokens_.peek().is("(")) {
        tokens_.expected("a corner, such as (0.7, 0.1)",
                         "write the top left and the bottom right corner as fractions of the "
                         "picture: (0.7, 0.1) .. (0.95, 0.5)");
        // Prevents parsing the rest as another statement.
        if (tokens_.peek().is_name("place")) {
            tokens_.next();
        }
        return false;
    }
    MapRange range;
    const std::size_t begin = tokens_.peek().span.begin;
    if (!range_value(range)) {
        return false;
    }
    range.span = {begin, tokens_.previous().span.end};
    made.ranges.push_back(range);
    return true;
}

bool StatementParser::frame(Statement& made) {
    const auto call = expressions_.stage("a frame");
    if (call) {
        made.stages.push_back(*call);
    }
    return call.has_value();
}

bool StatementParser::layer(Statement& made) {
    if (!stages(made, "the name of a camera or a picture", false)) {
        return false;
    }
    if (tokens_.peek().is("{")) {
        made.block = block(Block::layer);
    }
    return true;
}

bool StatementParser::stages(Statement& made, std::string_view what, bool several) {
    do {
        if (opens_next_statement()) {
            missing(what);
            return false;
        }
        const auto stage = expressions_.stage(what);
        if (!stage) {
            return false;
        }
        made.stages.push_back(*stage);
    } while (several && tokens_.accept(","));
    return true;
}

bool StatementParser::look(Statement& made, std::string_view what) {
    if (opens_next_statement()) {
        missing(what);
        return false;
    }
    const auto rule = expressions_.stage_with_words(what);
    if (rule) {
        made.stages.push_back(*rule);
    }
    return rule.has_value();
}

// A stage with the name of a keyword needs parentheses.
bool StatementParser::opens_next_statement() const {
    return keyword_at(tokens_.peek()) != nullptr && !tokens_.peek(1).is("(");
}

}  // namespace balcony::lang
