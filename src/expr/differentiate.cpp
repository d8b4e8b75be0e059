// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include "balcony/expr.hpp"

namespace balcony::expr {

std::vector<NodeId> reachable(const Graph& graph, std::span<const Expr> expressions) {
    std::vector<bool> marked(graph.size(), false);
    std::size_t highest = 0;
    for (const Expr root : expressions) {
        marked[root.id().value()] = true;
        highest = std::max<std::size_t>(highest, root.id().value() + 1);
    }
    std::size_t count = 0;
    for (std::size_t i = highest; i-- > 0;) {
        if (!marked[i]) {
            continue;
        }
        ++count;
        for (const NodeId argument : graph[NodeId(i)].arguments) {
            if (argument.valid()) {
                marked[argument.value()] = true;
            }
        }
    }
    std::vector<NodeId> nodes;
    nodes.reserve(count);
    for (std::size_t i = 0; i < highest; ++i) {
        if (marked[i]) {
            nodes.emplace_back(i);
        }
    }
    return nodes;
}

// Forward mode: one pass from the leaf up computes the derivative of every node.
std::vector<Expr> differentiate(std::span<const Expr> expressions, Expr leaf) {
    assert(operation(leaf.op()).arity == 0 && !leaf.is_constant());
    Graph& graph = leaf.graph();
    assert(std::all_of(expressions.begin(), expressions.end(),
                       [&](Expr root) { return &root.graph() == &graph; }));
    const Expr zero = graph.constant(0.0);
    const std::vector<NodeId> nodes = reachable(graph, expressions);
    std::vector<Expr> slopes(graph.size(), zero);
    slopes[leaf.id().value()] = graph.constant(1.0);
    for (const NodeId id : nodes) {
        const Expr self(graph, id);
        const Operation& rule = operation(self.op());
        if (rule.arity == 0 || rule.derivative == nullptr) {
            continue;
        }
        std::array<Expr, 3> arguments;
        std::array<Expr, 3> argument_slopes;
        bool changes = false;
        const auto arity = static_cast<std::size_t>(rule.arity);
        for (std::size_t i = 0; i < arity; ++i) {
            arguments[i] = self.argument(i);
            argument_slopes[i] = slopes[arguments[i].id().value()];
            changes = changes || !argument_slopes[i].is_constant(0.0);
        }
        if (changes) {
            slopes[id.value()] = rule.derivative(self, std::span(arguments).first(arity),
                                                 std::span(argument_slopes).first(arity));
        }
    }
    std::vector<Expr> result;
    result.reserve(expressions.size());
    for (const Expr root : expressions) {
        result.push_back(slopes[root.id().value()]);
    }
    return result;
}

Expr differentiate(Expr expression, Expr leaf) {
    return differentiate(std::span(&expression, 1), leaf).front();
}

}  // namespace balcony::expr
