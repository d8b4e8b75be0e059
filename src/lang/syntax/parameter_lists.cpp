// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The parameters of cameras and pictures, with their defaults and limits.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "lang/syntax/statement_parser.hpp"

namespace balcony::lang {

void StatementParser::parameters(DefinitionSyntax& camera) {
    const Span opening = tokens_.next().span;
    if (tokens_.accept(")")) {
        return;
    }
    do {
        if (!parameter(camera)) {
            skip_parameters(camera);
            return;
        }
    } while (tokens_.accept(","));
    if (!tokens_.expect_closing(")", opening)) {
        skip_parameters(camera);
    }
}

// fov = 60deg above 0 to 179deg
bool StatementParser::parameter(DefinitionSyntax& camera) {
    const auto name = new_name(
        fmt::format("a name for the {}'s parameter", camera.is_picture ? "picture" : "camera"));
    if (!name) {
        return false;
    }
    camera.parameters.push_back({.name = *name});
    if (!tokens_.peek().is("=")) {
        const Token& found = tokens_.peek();
        tokens_.expected(
            fmt::format("'=' and a default value for '{}'", name->text),
            found.is(":") ? fmt::format("write {} = ...", name->text)
            : found.kind == TokenKind::name && tokens_.peek(1).is("=")
                ? fmt::format("parameters have no types: write {} = ...", found.text)
                : "every parameter needs a default, so that a camera can be used without "
                  "arguments");
        return false;
    }
    tokens_.next();
    const auto value = expressions_.expression();
    if (!value) {
        return false;
    }
    camera.parameters.back().default_value = *value;
    return limits(camera.parameters.back());
}

bool StatementParser::limits(DefinitionParameter& parameter) {
    constexpr std::array<std::string_view, 12> others{"in",      "min",     "max",   "minimum",
                                                      "maximum", "between", "below", "under",
                                                      "over",    "from",    "above", "to"};
    const std::size_t begin = tokens_.peek().span.begin;
    const auto at = [this](std::string_view word) {
        return tokens_.peek().is_name(word) && !tokens_.peek(1).is("=");
    };
    const auto limit = [this](ExpressionId& read) {
        tokens_.next();
        const auto value = expressions_.expression();
        read = value.value_or(ExpressionId());
        return value.has_value();
    };
    parameter.excludes_minimum = at("above");
    if (((at("above") || at("from")) && !limit(parameter.minimum)) ||
        (at("to") && !limit(parameter.maximum))) {
        return false;
    }
    if (parameter.minimum.valid() || parameter.maximum.valid()) {
        parameter.limits = {begin, tokens_.previous().span.end};
    }
    if (std::none_of(others.begin(), others.end(), at)) {
        return true;
    }
    tokens_.expected("',' or ')'",
                     fmt::format("write limits behind the value: {0} = ... from 1 to 20, or above "
                                 "0 to 20 where 0 itself is excluded; one of both is enough",
                                 parameter.name.text));
    return false;
}

// Skips to the camera's opening brace. Parameters on the way are recorded, so that their uses are
// not errors.
void StatementParser::skip_parameters(DefinitionSyntax& camera) {
    camera.broken = true;
    int depth = 0;
    while (!tokens_.at_end() && !tokens_.peek().is("{") && !is_file_keyword(tokens_.peek()) &&
           keyword_at(tokens_.peek()) == nullptr) {
        const Token& token = tokens_.next();
        depth += token.is("(") ? 1 : token.is(")") ? -1 : 0;
        const bool is_new =
            std::none_of(camera.parameters.begin(), camera.parameters.end(),
                         [&](const auto& known) { return known.name.text == token.text; });
        if (depth == 0 && token.kind == TokenKind::name && tokens_.peek().is("=") && is_new) {
            camera.parameters.push_back({.name = {token.text, token.span}});
        }
    }
}

}  // namespace balcony::lang
