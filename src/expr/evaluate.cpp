// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include "balcony/expr.hpp"

namespace balcony::expr {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

double input_value(const Graph& graph, InputId id, const Point& point) {
    switch (id.value()) {
        case inputs::x.value(): return point.x;
        case inputs::y.value(): return point.y;
        case inputs::t.value(): return point.time;
        default: break;
    }
    const std::string& name = graph.input_names()[id.value()];
    const auto given = std::find_if(point.inputs.begin(), point.inputs.end(),
                                    [&](const InputValue& input) { return input.name == name; });
    return given == point.inputs.end() ? no_value : given->value;
}

double evaluate_node(const Graph& graph, const Node& node, const Point& point,
                     const double* arguments) {
    switch (node.op) {
        case Op::constant: return node.value;
        case Op::input: return input_value(graph, InputId(node.detail), point);
        case Op::variable:
            return node.detail < point.variables.size() ? point.variables[node.detail] : no_value;
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
