// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <bit>

#include "balcony/expr.hpp"
#include "expr/local_rules.hpp"

namespace balcony::expr {

GraphTooLarge::GraphTooLarge() : std::length_error("an expression graph with too many nodes") {}

GraphStopped::GraphStopped() : std::runtime_error("interrupted") {}

// Constants are equal if their bits are, so that 0 and -0 are distinct and a NaN equals itself.
bool Node::operator==(const Node& other) const {
    return op == other.op && detail == other.detail && operands == other.operands &&
           std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(other.value);
}

std::size_t Graph::Hash::operator()(const Node& node) const {
    constexpr std::uint64_t odd_multiplier = 0x9e3779b97f4a7c15ULL;
    std::uint64_t hash = static_cast<std::uint64_t>(node.op) | std::uint64_t{node.detail} << 8U;
    const auto mix = [&hash](std::uint64_t value) {
        hash = (hash ^ value) * odd_multiplier;
        hash ^= hash >> 32U;
    };
    mix(std::bit_cast<std::uint64_t>(node.value));
    for (const NodeId operand : node.operands) {
        mix(operand.value());
    }
    return hash;
}

Expr Graph::intern(const Node& node) {
    if (nodes_.size() >= most_) {
        throw GraphTooLarge();
    }
    if (stop_.stop_requested()) {
        throw GraphStopped();
    }
    const auto [known, is_new] = known_.try_emplace(node, NodeId(nodes_.size()));
    if (is_new) {
        nodes_.push_back(node);
        dependences_.push_back(dependence_of(known->second));
    }
    return {*this, known->second};
}

std::span<const NodeId> Graph::arguments(NodeId id) const {
    const Node& node = (*this)[id];
    if (node.op == Op::call) {
        return calls_[node.detail].arguments;
    }
    return std::span(node.operands).first(static_cast<std::size_t>(operation(node.op).arity));
}

Dependence Graph::dependence_of(NodeId id) const {
    const Node& node = (*this)[id];
    if (node.op == Op::input) {
        return Dependence::on(InputId(node.detail));
    }
    if (node.op == Op::variable) {
        return Dependence::on_variable();
    }
    Dependence all;
    for (const NodeId argument : arguments(id)) {
        all = all | dependence(argument);
    }
    return all;
}

Expr Graph::constant(double value) {
    Node node;
    node.value = value;
    return intern(node);
}

Expr Graph::input(InputId id) {
    Node node;
    node.op = Op::input;
    node.detail = id.value();
    return intern(node);
}

Expr Graph::input(std::string_view name) {
    const auto known = std::find(inputs_.begin(), inputs_.end(), name);
    const InputId id(static_cast<std::size_t>(known - inputs_.begin()));
    if (known == inputs_.end()) {
        inputs_.emplace_back(name);
    }
    return input(id);
}

Expr Graph::picture_x() { return input(inputs::x); }
Expr Graph::picture_y() { return input(inputs::y); }
Expr Graph::time() { return input(inputs::t); }

Expr Graph::variable(std::uint32_t number) {
    variables_ = std::max(variables_, number + 1);
    Node node;
    node.op = Op::variable;
    node.detail = number;
    return intern(node);
}

Expr Graph::fresh_variable() { return variable(variables_); }

Expr Graph::call_node(Call call, std::span<const Expr> at) {
    assert(!at.empty());
    for (const Expr argument : at) {
        assert(&argument.graph() == this);
        call.arguments.push_back(argument.id());
    }
    const auto [known, is_new] =
        known_calls_.try_emplace(std::pair(call.function(), call.arguments), CallId(calls_.size()));
    if (is_new) {
        calls_.push_back(std::move(call));
    }
    Node node;
    node.op = Op::call;
    node.detail = known->second.value();
    return intern(node);
}

Expr Graph::result_of(NodeId id, std::size_t number) {
    const std::span<const NodeId> given = arguments(id);
    const auto is_constant = [this](NodeId argument) {
        return (*this)[argument].op == Op::constant;
    };
    if (std::all_of(given.begin(), given.end(), is_constant)) {
        std::vector<const double*> values;
        for (const NodeId argument : given) {
            values.push_back(&(*this)[argument].value);
        }
        std::vector<double> made(call_of(id).result_count());
        std::vector<double*> results;
        for (double& result : made) {
            results.push_back(&result);
        }
        call_of(id).evaluate(1, values.data(), results.data());
        return constant(made[number]);
    }
    Node node;
    node.op = Op::result;
    node.operands[0] = id;
    node.detail = static_cast<std::uint32_t>(number);
    return intern(node);
}

std::vector<Expr> Graph::call(std::shared_ptr<const Native> function, std::span<const Expr> at) {
    assert(at.size() == function->argument_count());
    const std::size_t count = function->result_count();
    const Expr made = call_node({nullptr, std::move(function), {}}, at);
    std::vector<Expr> results;
    for (std::size_t i = 0; i < count; ++i) {
        results.push_back(result_of(made.id(), i));
    }
    return results;
}

Expr Graph::lookup(std::shared_ptr<const Table> table, std::span<const Expr> at) {
    assert(at.size() == table->axes.size());
    return result_of(call_node({std::move(table), nullptr, {}}, at).id(), 0);
}

Expr Graph::lookup(std::shared_ptr<const Table> table, Expr x) {
    return lookup(std::move(table), std::span(&x, 1));
}

std::shared_ptr<const Table> Graph::derivative_table(const std::shared_ptr<const Table>& table,
                                                     std::size_t axis) {
    std::shared_ptr<const Table>& made = derivative_tables_[{table, axis}];
    if (!made) {
        made = std::make_shared<const Table>(table->derivative(axis));
    }
    return made;
}

Expr Graph::remake(const Graph& source, const Node& node, std::span<const Expr> arguments) {
    if (node.op == Op::result) {
        return result_of(arguments[0].id(), node.detail);
    }
    return operation(node.op).scalar != nullptr ? apply(node.op, arguments)
                                                : copy(source, node, arguments);
}

Expr Graph::copy(const Graph& source, const Node& node, std::span<const Expr> arguments) {
    switch (node.op) {
        case Op::constant: return constant(node.value);
        case Op::input: return input(source.inputs_[node.detail]);
        case Op::variable: return variable(node.detail);
        case Op::call: {
            const Call& call = source.calls_[node.detail];
            return call_node({call.table, call.native, {}}, arguments);
        }
        default: break;
    }
    Node made = node;
    std::transform(arguments.begin(), arguments.end(), made.operands.begin(),
                   [](Expr argument) { return argument.id(); });
    return intern(made);
}

Expr Graph::apply(Op op, std::span<const Expr> arguments) {
    assert(operation(op).scalar != nullptr &&
           "leaves, calls and their results have functions of their own");
    assert(static_cast<int>(arguments.size()) == operation(op).arity);
    if (const Expr simpler = apply_local_rules(*this, op, arguments); simpler.valid()) {
        return simpler;
    }
    Node node;
    node.op = op;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        assert(&arguments[i].graph() == this);
        node.operands[i] = arguments[i].id();
    }
    if (operation(op).commutative && node.operands[1] < node.operands[0]) {
        std::swap(node.operands[0], node.operands[1]);
    }
    return intern(node);
}

}  // namespace balcony::expr
