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

}  // namespace

void Call::evaluate(std::size_t count, const double* const* at, double* const* results) const {
    if (native) {
        native->evaluate(count, at, results);
        return;
    }
    std::array<double, Table::max_axes> point{};
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < arguments.size(); ++k) {
            point[k] = at[k][i];
        }
        results[0][i] = (*table)(std::span(point).first(arguments.size()));
    }
}

BatchEvaluator::BatchEvaluator(std::span<const Expr> expressions)
    : expressions_(expressions.begin(), expressions.end()) {
    if (expressions.empty()) {
        return;
    }
    const Graph& graph = expressions.front().graph();
    nodes_ = reachable(graph, expressions);
    places_.resize(graph.size());
    for (const NodeId id : nodes_) {
        const Node& node = graph[id];
        if (node.op == Op::result) {
            places_[id.value()] = places_[node.operands[0].value()] + node.detail;
            continue;
        }
        if (node.op == Op::input || node.op == Op::variable) {
            leaves_.push_back(id);
        }
        places_[id.value()] = place_count_;
        place_count_ += node.op == Op::call ? graph.call_of(id).result_count() : 1;
    }
}

std::vector<double> BatchEvaluator::operator()(std::size_t count, const FillLeaf& fill) const {
    std::vector<double> values(place_count_ * count);
    const auto run_of = [&](std::size_t place) { return values.data() + place * count; };
    std::vector<const double*> arguments;
    std::vector<double*> results;
    for (const NodeId id : nodes_) {
        const Graph& graph = expressions_.front().graph();
        const Node& node = graph[id];
        double* run = run_of(places_[id.value()]);
        arguments.clear();
        for (const NodeId argument : graph.arguments(id)) {
            arguments.push_back(run_of(places_[argument.value()]));
        }
        if (node.op == Op::constant) {
            std::fill_n(run, count, node.value);
        } else if (arguments.empty()) {
            fill(node, {run, count});
        } else if (node.op == Op::call) {
            const Call& call = graph.call_of(id);
            results.clear();
            for (std::size_t r = 0; r < call.result_count(); ++r) {
                results.push_back(run + r * count);
            }
            call.evaluate(count, arguments.data(), results.data());
        } else if (node.op != Op::result) {
            const auto scalar = operation(node.op).scalar;
            std::array<double, Node::max_operands> at{};
            for (std::size_t i = 0; i < count; ++i) {
                for (std::size_t k = 0; k < arguments.size(); ++k) {
                    at[k] = arguments[k][i];
                }
                run[i] = scalar(at.data());
            }
        }
    }
    std::vector<double> made;
    made.reserve(expressions_.size() * count);
    for (const Expr expression : expressions_) {
        const double* run = run_of(places_[expression.id().value()]);
        made.insert(made.end(), run, run + count);
    }
    return made;
}

std::vector<double> evaluate(std::span<const Expr> expressions, const Point& point) {
    return BatchEvaluator(expressions)(1, [&](const Node& leaf, std::span<double> value) {
        if (leaf.op == Op::input) {
            value[0] = input_value(expressions.front().graph(), InputId(leaf.detail), point);
        } else {
            value[0] =
                leaf.detail < point.variables.size() ? point.variables[leaf.detail] : no_value;
        }
    });
}

}  // namespace balcony::expr
