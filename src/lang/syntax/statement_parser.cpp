// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/syntax/statement_parser.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "balcony/catalogue.hpp"
#include "lang/syntax/meant_words.hpp"

namespace balcony::lang {

namespace {

// Globally reserved names.
constexpr std::array<std::string_view, 2> constants = {"pi", "t"};

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
    while (!tokens_.at_end() && !tokens_.peek().is("}") &&
           (!is_file_keyword(tokens_.peek()) || is_shown_camera(block)) && !reporter_.full()) {
        read_statement(block, read);
    }
    const bool hidden = tokens_.at_end() && tokens_.at_reported();
    if (!reporter_.full()) {
        const bool muted = tokens_.muted();
        tokens_.mute(muted || (!read.empty() && read.back().broken && !tokens_.at_new_line()));
        tokens_.expect_closing("}", opening);
        tokens_.mute(muted);
    }
    if (hidden || reporter_.full()) {
        Statement unread;
        unread.broken = true;
        read.push_back(std::move(unread));
    }
    return read;
}

// What stands behind a broken statement on its line is a piece of it, and a statement with such a
// piece behind it is broken.
void StatementParser::read_statement(Block block, std::vector<Statement>& read) {
    const bool muted = tokens_.muted();
    const bool goes_on = !read.empty() && !tokens_.at_new_line();
    tokens_.mute(muted || (goes_on && read.back().broken));
    Statement made = statement(block);
    tokens_.mute(muted);
    if (goes_on && made.kind == StatementKind::unknown) {
        read.back().broken = true;
    }
    read.push_back(std::move(made));
}

// camera NAME in a picture, instead of layer NAME.
bool StatementParser::is_shown_camera(Block block) const {
    return (block == Block::picture || block == Block::loop) && tokens_.peek().is_name("camera") &&
           tokens_.peek(1).kind == TokenKind::name && !tokens_.peek(2).is("{") &&
           !tokens_.peek(2).is("(");
}

Statement StatementParser::unmarked_let() {
    Statement made;
    made.kind = StatementKind::let;
    made.keyword = {tokens_.peek().span.begin, tokens_.peek().span.begin};
    made.broken = !let(made);
    if (made.broken) {
        skip_statement();
    }
    made.span = {made.keyword.begin, tokens_.previous().span.end};
    return made;
}

// ------------------------------------------------------------------------------- statement

Statement StatementParser::statement(Block block) {
    const Token& token = tokens_.peek();
    const StatementRow* row = find_statement(token, block);
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
        if (row->shape != Shape::call || names_stage(*row)) {
            tokens_.next();
        }
        made.broken = !body(*row, made);
    }
    if (made.broken) {
        skip_statement();
    }
    made.span = {made.keyword.begin, tokens_.previous().span.end};
    return made;
}

bool StatementParser::body(const StatementRow& row, Statement& made) {
    switch (row.shape) {
        case Shape::let: return let(made);
        case Shape::value: return value(made);
        case Shape::equation:
            return tokens_.expect("=", fmt::format("after '{}'", row.keyword),
                                  fmt::format("for example {} = t + 0.02*y", row.keyword)) &&
                   value(made);
        case Shape::word: return word(row, made);
        case Shape::ranges: return ranges(made);
        case Shape::nothing: return true;
        case Shape::corners: return corners(made);
        case Shape::optional_corners: return optional_corners(made);
        case Shape::shown:
            return tokens_.peek().is_name("objects") ? objects(row, made) : corners(made);
        case Shape::objects: return objects(row, made);
        case Shape::blend: return blend(row, made);
        case Shape::placements: return placements(row, made);
        case Shape::loop: return loop(made);
        case Shape::assignments: return assignments(made);
        case Shape::stage:
        case Shape::stages:
        case Shape::rule:
        case Shape::call: return stages(row, made);
        case Shape::path:
            if (tokens_.peek().is("{")) {
                made.block = this->block(Block::path);
                return true;
            }
            return stages(row, made);
        case Shape::layer: return layer(row, made);
        case Shape::morph: return morph(row, made);
    }
    return false;
}

// Reports that the expected part of a statement is missing.
void StatementParser::missing(std::string_view what) {
    const std::string_view before = tokens_.previous().text;
    tokens_.expected(what, before == "," ? "remove the ',' before it, or add the missing part"
                                         : fmt::format("write it after '{}'", before));
}

bool StatementParser::let(Statement& made) {
    LetSyntax read;
    if (const auto name = new_name("a name after 'let'")) {
        read.name = *name;
    } else {
        made.content = read;
        return false;
    }
    std::optional<ExpressionId> value;
    if ((!tokens_.peek().is("(") || function_parameters(read)) &&
        tokens_.expect("=", read.parameters.empty() ? "after the name" : "after the parameters",
                       "for example let width = 4, or let half(x) = x/2")) {
        value = value_on_line();
    }
    read.value = value.value_or(ExpressionId());
    made.content = std::move(read);
    return value.has_value();
}

// (x, y) of let ratio(x, y) = x/y
bool StatementParser::function_parameters(LetSyntax& function) {
    const Span opening = tokens_.next().span;
    if (tokens_.peek().is(")")) {
        tokens_.expected(
            fmt::format("a parameter of '{}'", function.name.text),
            fmt::format("without parameters it is a value: let {} = ...", function.name.text));
        return false;
    }
    do {
        const auto name =
            new_name(fmt::format("the name of a parameter of '{}'", function.name.text));
        if (!name) {
            return false;
        }
        function.parameters.push_back(*name);
        if (tokens_.peek().is("=")) {
            tokens_.error(tokens_.peek().span, "the parameters of a function have no defaults",
                          fmt::format("write let {}({}) = ...", function.name.text, name->text));
            return false;
        }
    } while (tokens_.accept(","));
    return tokens_.expect_closing(")", opening);
}

// A value that does not start with the next statement.
std::optional<ExpressionId> StatementParser::value_on_line() {
    const bool next_statement = tokens_.at_new_line() && (keyword_at(tokens_.peek()) != nullptr ||
                                                          is_file_keyword(tokens_.peek()));
    if (next_statement) {
        missing("a value");
        return std::nullopt;
    }
    return expressions_.expression();
}

bool StatementParser::value(Statement& made) {
    const auto read = value_on_line();
    if (!read) {
        return false;
    }
    made.content = *read;
    if (tokens_.peek().is(":") || tokens_.peek().is_name("x")) {
        tokens_.expected("one number", "write a ratio as a quotient: aspect 16/9");
        return false;
    }
    return true;
}

bool StatementParser::word(const StatementRow& row, Statement& made) {
    const Token& token = tokens_.peek();
    if (token.kind != TokenKind::name || keyword_at(token) != nullptr) {
        missing(row.expected);
        return false;
    }
    made.content = Identifier{token.text, token.span};
    tokens_.next();
    return true;
}

bool StatementParser::ranges(Statement& made) {
    std::vector<MapRange> read;
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
                            "for example map u = -1 .. 1, v = square")) {
            return false;
        }
        if (tokens_.peek().is_name("square") && !tokens_.peek(1).is("..")) {
            tokens_.next();
        } else if (!ends_of(range)) {
            return false;
        }
        range.span = {coordinate.span.begin, tokens_.previous().span.end};
        read.push_back(range);
    } while (tokens_.accept(",") || next_range());
    made.content = std::move(read);
    return true;
}

// A range after another without a comma, which is reported.
bool StatementParser::next_range() {
    const Token& token = tokens_.peek();
    const bool follows = (token.is_name("u") || token.is_name("v")) && tokens_.peek(1).is("=");
    if (follows) {
        tokens_.expected("',' between the ranges of map", "write map u = -1 .. 1, v = -1 .. 1");
    }
    return follows;
}

template <class Range>
bool StatementParser::ends_of(Range& range) {
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

// The next token may start a corner: (0.7, 0.1), or the name of a point.
bool StatementParser::expect_corner() {
    const Token& token = tokens_.peek();
    if (token.is("(") || (token.kind == TokenKind::name && !opens_next_statement())) {
        return true;
    }
    tokens_.expected("a corner, such as (0.7, 0.1)",
                     "write the top left and the bottom right corner as fractions of the "
                     "picture: (0.7, 0.1) .. (0.95, 0.5)");
    // Prevents parsing the rest as another statement.
    if (token.is_name("place")) {
        tokens_.next();
    }
    return false;
}

bool StatementParser::corners(Statement& made) {
    if (!expect_corner()) {
        return false;
    }
    Corners read;
    const std::size_t begin = tokens_.peek().span.begin;
    if (!ends_of(read)) {
        return false;
    }
    read.span = {begin, tokens_.previous().span.end};
    made.content = read;
    return true;
}

bool StatementParser::optional_corners(Statement& made) {
    const Token& token = tokens_.peek();
    const bool omitted = keyword_at(token) != nullptr || token.is("}") || tokens_.at_end() ||
                         (tokens_.at_new_line() && !token.is("("));
    return omitted || corners(made);
}

// objects("vase*", "table")
bool StatementParser::objects(const StatementRow& row, Statement& made) {
    if (!tokens_.peek().is_name("objects") || !tokens_.peek(1).is("(")) {
        tokens_.expected(row.expected, "write names in quotation marks: objects(\"vase*\")");
        return false;
    }
    return stages(row, made);
}

// multiply, or by depth
bool StatementParser::blend(const StatementRow& row, Statement& made) {
    const bool by = tokens_.peek().is_name("by");
    if (by) {
        tokens_.next();
    }
    return by ? stages(row, made) : word(row, made);
}

bool StatementParser::placements(const StatementRow& row, Statement& made) {
    std::vector<ExpressionId> read;
    do {
        const auto one = placement(row);
        if (!one) {
            return false;
        }
        read.push_back(*one);
    } while (tokens_.accept(","));
    made.content = std::move(read);
    return true;
}

// Corners become a call of the stage that places: place((0.7, 0.1), (0.95, 0.5)).
std::optional<ExpressionId> StatementParser::placement(const StatementRow& row) {
    const Token& token = tokens_.peek();
    const Token& after = tokens_.peek(1);
    const bool is_stage = token.kind == TokenKind::name && !after.is("..") && !after.is("[") &&
                          catalogue_.find(*row.stage_kind, token.text) != nullptr;
    if (is_stage) {
        return stage(row);
    }
    if (!expect_corner()) {
        return std::nullopt;
    }
    Corners corners;
    const std::size_t begin = token.span.begin;
    const std::size_t first = expressions_.next();
    if (!ends_of(corners)) {
        return std::nullopt;
    }
    return expressions_.add_call({row.keyword, {begin, tokens_.previous().span.end}},
                                 {{std::nullopt, corners.first}, {std::nullopt, corners.last}},
                                 first);
}

bool StatementParser::layer(const StatementRow& row, Statement& made) {
    if (!stages(row, made)) {
        return false;
    }
    if (tokens_.peek().is("{")) {
        made.block = block(Block::layer);
    }
    return true;
}

bool StatementParser::stages(const StatementRow& row, Statement& made) {
    std::vector<ExpressionId> read;
    do {
        const auto one = stage(row);
        if (!one) {
            return false;
        }
        if (takes_bare_number(row, tokens_.previous().text)) {
            return false;
        }
        read.push_back(*one);
    } while (row.shape == Shape::stages && tokens_.accept(","));
    made.content = std::move(read);
    return true;
}

// sphere 1 instead of sphere(1), which is reported.
bool StatementParser::takes_bare_number(const StatementRow& row, std::string_view stage) {
    const Token& token = tokens_.peek();
    if (token.kind != TokenKind::number || tokens_.at_new_line() || row.shape == Shape::layer) {
        return false;
    }
    tokens_.expected("'('",
                     fmt::format("write arguments in parentheses: {}({})", stage, token.text));
    return true;
}

// A formula in brackets where a stage is expected: what to write instead, with its text.
std::optional<std::string> StatementParser::bare_formula_remedy(const StatementRow& row) const {
    const bool is_rule = row.stage_kind == camera::StageKind::direction_rule;
    const bool is_object = row.stage_kind == camera::StageKind::object_generator;
    const Token& opening = tokens_.peek();
    if (!(is_rule || is_object) || !(opening.is("(") || opening.is("["))) {
        return std::nullopt;
    }
    bool depends = false;
    std::size_t ahead = 0;
    for (int depth = 0; depth > 0 || ahead == 0; ++ahead) {
        const Token& token = tokens_.peek(ahead);
        if (token.kind == TokenKind::end) {
            return std::nullopt;
        }
        depends = depends || token.is_name("u") || token.is_name("v");
        depth += token.is("(") || token.is("[") ? 1 : token.is(")") || token.is("]") ? -1 : 0;
    }
    const char* const begin = opening.text.data() + 1;
    const std::string_view inner(
        begin, static_cast<std::size_t>(tokens_.peek(ahead - 1).text.data() - begin));
    return instead_of_formula(*row.stage_kind, inner, depends);
}

std::optional<ExpressionId> StatementParser::stage(const StatementRow& row) {
    if (row.shape != Shape::call && opens_next_statement()) {
        missing(row.expected);
        return std::nullopt;
    }
    if (const std::optional<std::string> remedy = bare_formula_remedy(row)) {
        tokens_.expected(row.expected, *remedy);
        return std::nullopt;
    }
    if (tokens_.peek().is("(") && row.stage_kind) {
        const bool is_rule = row.shape == Shape::rule;
        tokens_.expected(row.expected, is_rule ? "write along((0, 0, 1)) for a fixed direction"
                                       : row.stage_kind == camera::StageKind::object_generator
                                           ? "write point(0, 0, 1) for a point"
                                           : "write the name of a stage before its arguments");
        return std::nullopt;
    }
    return row.shape == Shape::rule ? expressions_.stage_with_words(row.expected)
                                    : expressions_.stage(row.expected);
}

// lens table("dgauss.dat"): a stage with a name other than the keyword.
bool StatementParser::names_stage(const StatementRow& row) const {
    const Token& name = tokens_.peek(1);
    return row.stage_kind && name.kind == TokenKind::name && keyword_at(name) == nullptr &&
           tokens_.peek(2).is("(");
}

// A stage with the name of a keyword needs parentheses.
bool StatementParser::opens_next_statement() const {
    return keyword_at(tokens_.peek()) != nullptr && !tokens_.peek(1).is("(");
}

}  // namespace balcony::lang
