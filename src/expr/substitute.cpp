// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/expr.hpp"

namespace balcony::expr {

std::vector<Expr> substitute(Graph& target, std::span<const Expr> expressions,
                             std::span<const Substitution> substitutions) {
    if (expressions.empty()) {
        return {};
    }
    const Graph& source = expressions.front().graph();
    std::vector<Expr> made(source.size());
    for (const Substitution& substitution : substitutions) {
        assert(&substitution.leaf.graph() == &source);
        assert(&substitution.replacement.graph() == &target);
        made[substitution.leaf.id().value()] = substitution.replacement;
    }
    std::vector<Expr> arguments;
    for (const NodeId id : reachable(source, expressions)) {
        if (made[id.value()].valid()) {
            continue;
        }
        // A copy, because building in the same graph may move its nodes.
        const Node node = source[id];
        arguments.clear();
        for (const NodeId argument : source.arguments(id)) {
            arguments.push_back(made[argument.value()]);
        }
        made[id.value()] = target.remake(source, node, arguments);
    }
    std::vector<Expr> result;
    result.reserve(expressions.size());
    for (const Expr root : expressions) {
        result.push_back(made[root.id().value()]);
    }
    return result;
}

}  // namespace balcony::expr
