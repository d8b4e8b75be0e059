// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/names/unused_names.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace balcony::lang {

bool mentions(const SyntaxTree& tree, Span part, std::string_view name) {
    return std::any_of(
        tree.expressions.begin(), tree.expressions.end(), [part, name](const Expression& node) {
            return (node.kind == ExpressionKind::name || node.kind == ExpressionKind::call) &&
                   node.name.text == name && part.begin <= node.span.begin &&
                   node.span.end <= part.end;
        });
}

std::string_view word_for(const LetSyntax& let) {
    return let.parameters.empty() ? "let" : "function";
}

void warn_of_unused(const SyntaxTree& tree, const Identifier& name, std::string_view what,
                    Reporter& reporter) {
    reporter.warning(tree.at(name.span), fmt::format("the {} '{}' is unused", what, name.text));
}

void warn_of_unused_parameters(const SyntaxTree& tree, const LetSyntax& let, Reporter& reporter) {
    for (const Identifier& parameter : let.parameters) {
        if (!mentions(tree, tree[let.value].span, parameter.text)) {
            warn_of_unused(tree, parameter, "parameter", reporter);
        }
    }
}

void warn_of_unused_in_loop(const SyntaxTree& tree, const Statement& loop, Reporter& reporter) {
    const auto warn = [&](const Identifier& name, std::string_view what) {
        if (!mentions(tree, loop.span, name.text)) {
            warn_of_unused(tree, name, what, reporter);
        }
    };
    warn(loop.loop().variable, "variable");
    for (const Statement& statement : loop.block) {
        if (statement.kind == StatementKind::let) {
            warn(statement.let().name, word_for(statement.let()));
            warn_of_unused_parameters(tree, statement.let(), reporter);
        } else if (statement.kind == StatementKind::loop) {
            warn_of_unused_in_loop(tree, statement, reporter);
        }
    }
}

}  // namespace balcony::lang
