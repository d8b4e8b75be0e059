// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Statements of several parts: assignments, loops, morphs.

#include <fmt/format.h>

#include "lang/syntax/statement_parser.hpp"

namespace balcony::lang {

// radius = 2*scene_radius, (px, py, pz) = scene_inside
bool StatementParser::assignments(Statement& made) {
    std::vector<Assignment> read;
    do {
        Assignment one;
        if (!assigned_names(one) ||
            !tokens_.expect("=", "after what is fitted", "for example fit radius = scene_radius")) {
            return false;
        }
        const auto value = expressions_.expression();
        if (!value) {
            return false;
        }
        one.value = *value;
        read.push_back(std::move(one));
    } while (tokens_.accept(","));
    made.content = std::move(read);
    return true;
}

// px or (px, py, pz)
bool StatementParser::assigned_names(Assignment& assignment) {
    const Span opening = tokens_.peek().span;
    assignment.is_tuple = tokens_.accept("(");
    do {
        const Token& token = tokens_.peek();
        if (token.kind != TokenKind::name || keyword_at(token) != nullptr) {
            tokens_.expected("a parameter of the camera or the picture",
                             "for example fit radius = scene_radius, (px, py, pz) = scene_inside");
            return false;
        }
        assignment.names.push_back({token.text, token.span});
        tokens_.next();
    } while (assignment.is_tuple && tokens_.accept(","));
    return !assignment.is_tuple || tokens_.expect_closing(")", opening);
}

// for i in 0 .. 6 { layers }
bool StatementParser::loop(Statement& made) {
    constexpr std::size_t deepest_loops = 8;
    const auto name = new_name("a name after 'for'");
    if (!name) {
        return false;
    }
    if (!tokens_.peek().is_name("in")) {
        tokens_.expected(fmt::format("'in' after '{}'", name->text),
                         fmt::format("write for {} in 0 .. 6 {{ ... }}", name->text));
        return false;
    }
    tokens_.next();
    LoopSyntax read{*name, {}, {}};
    const auto first = expressions_.expression();
    if (!first) {
        return false;
    }
    read.first = *first;
    if (tokens_.accept("..")) {
        const auto last = expressions_.expression();
        if (!last) {
            return false;
        }
        read.last = *last;
    }
    made.content = read;
    if (!tokens_.peek().is("{")) {
        tokens_.expected("'{' and the layers to repeat",
                         fmt::format("write for {} in 0 .. 6 {{ layer ... }}", name->text));
        return false;
    }
    if (loops_ == deepest_loops) {
        tokens_.error(made.keyword,
                      fmt::format("loops are nested more than {} levels deep", deepest_loops),
                      "compute several indices from one: floor(i/4) and mod(i, 4)");
        return false;
    }
    ++loops_;
    made.block = block(Block::loop);
    --loops_;
    return true;
}

// pinhole .. fisheye, amount = t/4
bool StatementParser::morph(const StatementRow& row, Statement& made) {
    const auto camera = [&]() -> std::optional<ExpressionId> {
        if (tokens_.peek().kind != TokenKind::name) {
            tokens_.expected(row.expected, "run 'balcony list cameras' for the built-in ones");
            return std::nullopt;
        }
        return stage(row);
    };
    const std::size_t first_node = expressions_.next();
    const auto first = camera();
    if (!first || !tokens_.expect("..", "between the two cameras of a morph",
                                  "for example morph pinhole .. fisheye, amount = t/4")) {
        return false;
    }
    const auto second = camera();
    if (!second) {
        return false;
    }
    std::vector<Argument> arguments{{std::nullopt, *first}, {std::nullopt, *second}};
    while (tokens_.accept(",")) {
        const Token& name = tokens_.peek();
        if (name.kind != TokenKind::name || !tokens_.peek(1).is("=")) {
            tokens_.expected("an argument of the morph",
                             "for example morph pinhole .. fisheye, amount = t/4");
            return false;
        }
        const Identifier named{name.text, name.span};
        tokens_.next();
        tokens_.next();
        const auto value = expressions_.expression();
        if (!value) {
            return false;
        }
        arguments.push_back({named, *value});
    }
    const Identifier keyword{row.keyword, {made.keyword.begin, tokens_.previous().span.end}};
    made.content = std::vector{expressions_.add_call(keyword, std::move(arguments), first_node)};
    return true;
}

}  // namespace balcony::lang
