// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/expr.hpp"

namespace balcony::expr {

namespace {

double evaluate_node(const Graph& graph, const Node& node, const Point& point,
                     const double* arguments) {
    switch (node.op) {
        case Op::constant: return node.value;
        case Op::picture_x: return point.x;
        case Op::picture_y: return point.y;
        case Op::time: return point.time;
        case Op::variable:
            assert(node.detail < point.variables.size());
            return point.variables[node.detail];
        default: break;
    }
    if (is_lookup(node.op)) {
        const Table& table = *graph.table(TableId(node.detail));
        return table(std::span(arguments, table.axes.size()));
    }
    if (is_native(node.op)) {
        const std::array<const double*, 3> batch{arguments, arguments + 1, arguments + 2};
        double result = 0.0;
        graph.native(NativeId(node.detail))->evaluate(1, batch.data(), &result);
        return result;
    }
    return operation(node.op).scalar(arguments);
}

}  // namespace

std::vector<double> evaluate(std::span<const Expr> expressions, const Point& point) {
    std::vector<double> result;
    if (expressions.empty()) {
        return result;
    }
    const Graph& graph = expressions.front().graph();
    std::vector<double> values(graph.size());
    for (const NodeId id : reachable(graph, expressions)) {
        const Node& node = graph[id];
        std::array<double, 3> arguments{};
        for (std::size_t i = 0; i < 3; ++i) {
            if (node.arguments[i].valid()) {
                arguments[i] = values[node.arguments[i].value()];
            }
        }
        values[id.value()] = evaluate_node(graph, node, point, arguments.data());
    }
    for (const Expr root : expressions) {
        result.push_back(values[root.id().value()]);
    }
    return result;
}

}  // namespace balcony::expr
