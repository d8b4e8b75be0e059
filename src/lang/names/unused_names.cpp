// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/names/unused_names.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace balcony::lang {

namespace {

// The values and functions that expressions in a part of a file name. A node is behind its operands
// and what precedes it in the text, so that nodes are sorted by their ends.
std::set<std::string_view> names_in(const SyntaxTree& tree, Span part) {
    const auto first = std::partition_point(
        tree.expressions.begin(), tree.expressions.end(),
        [part](const Expression& node) { return node.span.end <= part.begin; });
    std::set<std::string_view> names;
    for (auto node = first; node != tree.expressions.end() && node->span.end <= part.end; ++node) {
        if (node->kind == ExpressionKind::name || node->kind == ExpressionKind::call) {
            names.insert(node->name.text);
        }
    }
    return names;
}

}  // namespace

std::string_view word_for(const LetSyntax& let) {
    return let.parameters.empty() ? "let" : "function";
}

void warn_of_unused(const SyntaxTree& tree, const Identifier& name, std::string_view what,
                    Reporter& reporter) {
    reporter.warning(tree.at(name.span), fmt::format("the {} '{}' is unused", what, name.text));
}

void warn_of_unused_parameters(const SyntaxTree& tree, const LetSyntax& let, Reporter& reporter) {
    if (let.parameters.empty()) {
        return;
    }
    const std::set<std::string_view> names = names_in(tree, tree[let.value].span);
    for (const Identifier& parameter : let.parameters) {
        if (!names.contains(parameter.text)) {
            warn_of_unused(tree, parameter, "parameter", reporter);
        }
    }
}

void warn_of_unused_in_loop(const SyntaxTree& tree, const Statement& loop, Reporter& reporter) {
    const std::set<std::string_view> names = names_in(tree, loop.span);
    const auto warn = [&](const Identifier& name, std::string_view what) {
        if (!names.contains(name.text)) {
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
