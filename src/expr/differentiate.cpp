// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <queue>

#include "balcony/expr.hpp"
#include "expr/reachable.hpp"

namespace balcony::expr {

namespace {

// The nodes of expressions if there are at most so many: in time that depends on their number
// alone, as many small expressions in a large graph need.
std::optional<std::vector<NodeId>> few_reachable(const Graph& graph,
                                                 std::span<const Expr> expressions,
                                                 std::size_t maximum) {
    std::priority_queue<NodeId> waiting;
    for (const Expr root : expressions) {
        waiting.push(root.id());
    }
    std::vector<NodeId> nodes;
    while (!waiting.empty()) {
        const NodeId id = waiting.top();
        waiting.pop();
        if (!nodes.empty() && nodes.back() == id) {
            continue;
        }
        if (nodes.size() == maximum) {
            return std::nullopt;
        }
        nodes.push_back(id);
        for (const NodeId argument : graph.arguments(id)) {
            waiting.push(argument);
        }
    }
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
}

}  // namespace

std::vector<NodeId> reachable(const Graph& graph, std::span<const Expr> expressions) {
    if (auto few = few_reachable(graph, expressions, graph.size() / few_of_a_graph)) {
        return std::move(*few);
    }
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
        for (const NodeId argument : graph.arguments(NodeId(i))) {
            marked[argument.value()] = true;
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
    std::vector<Expr> arguments;
    std::vector<Expr> argument_slopes;
    for (const NodeId id : nodes) {
        const Expr self(graph, id);
        const auto derivative = operation(self.op()).derivative;
        if (derivative == nullptr) {
            continue;
        }
        arguments.clear();
        argument_slopes.clear();
        bool changes = false;
        // A result changes with the arguments of its call.
        for (const NodeId argument :
             graph.arguments(self.op() == Op::result ? graph.arguments(id)[0] : id)) {
            arguments.emplace_back(graph, argument);
            argument_slopes.push_back(slopes[argument.value()]);
            changes = changes || !argument_slopes.back().is_constant(0.0);
        }
        if (changes) {
            slopes[id.value()] = derivative(self, arguments, argument_slopes);
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
