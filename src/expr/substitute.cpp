// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include "balcony/expr.hpp"
#include "expr/reachable.hpp"

namespace balcony::expr {

std::vector<Expr> substitute(Graph& target, std::span<const Expr> expressions,
                             std::span<const Substitution> substitutions) {
    if (expressions.empty()) {
        return {};
    }
    const Graph& source = expressions.front().graph();
    const std::vector<NodeId> nodes = reachable(source, expressions);
    // By the numbers of the nodes, or by their order if they are few.
    const bool few = nodes.size() <= source.size() / few_of_a_graph;
    std::vector<Expr> made(few ? nodes.size() : source.size());
    const auto place_of = [&](NodeId id) {
        return few ? static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), id) -
                                              nodes.begin())
                   : std::size_t{id.value()};
    };
    for (const Substitution& substitution : substitutions) {
        assert(&substitution.leaf.graph() == &source);
        assert(&substitution.replacement.graph() == &target);
        const NodeId leaf = substitution.leaf.id();
        if (!few || std::binary_search(nodes.begin(), nodes.end(), leaf)) {
            made[place_of(leaf)] = substitution.replacement;
        }
    }
    std::vector<Expr> arguments;
    for (const NodeId id : nodes) {
        Expr& copy = made[place_of(id)];
        if (copy.valid()) {
            continue;
        }
        // A copy, because building in the same graph may move its nodes.
        const Node node = source[id];
        arguments.clear();
        for (const NodeId argument : source.arguments(id)) {
            arguments.push_back(made[place_of(argument)]);
        }
        copy = target.remake(source, node, arguments);
    }
    std::vector<Expr> result;
    result.reserve(expressions.size());
    for (const Expr root : expressions) {
        result.push_back(made[place_of(root.id())]);
    }
    return result;
}

}  // namespace balcony::expr
