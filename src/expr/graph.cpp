// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <bit>

#include "balcony/expr.hpp"
#include "expr/local_rules.hpp"

namespace balcony::expr {

GraphTooLarge::GraphTooLarge()
    : std::length_error("an expression graph of more than 4 million nodes") {}

// Constants are equal if their bits are, so that 0 and -0 are distinct and a NaN equals itself.
bool Node::operator==(const Node& other) const {
    return op == other.op && detail == other.detail && arguments == other.arguments &&
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
    for (const NodeId argument : node.arguments) {
        mix(argument.value());
    }
    return hash;
}

Expr Graph::intern(const Node& node) {
    if (nodes_.size() >= max_nodes) {
        throw GraphTooLarge();
    }
    const auto [known, is_new] = known_.try_emplace(node, NodeId(nodes_.size()));
    if (is_new) {
        nodes_.push_back(node);
        dependences_.push_back(dependence_of(node));
    }
    return {*this, known->second};
}

Dependence Graph::dependence_of(const Node& node) const {
    if (node.op == Op::input) {
        return Dependence::on(InputId(node.detail));
    }
    if (node.op == Op::variable) {
        return Dependence::on_variable();
    }
    Dependence all;
    for (const NodeId argument : node.arguments) {
        if (argument.valid()) {
            all = all | dependence(argument);
        }
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

namespace {

// The index of a shared value in a list; adds it if missing.
template <class Value>
std::size_t place_in(std::vector<std::shared_ptr<const Value>>& list,
                     std::shared_ptr<const Value> value) {
    const auto known = std::find(list.begin(), list.end(), value);
    const auto place = static_cast<std::size_t>(known - list.begin());
    if (known == list.end()) {
        list.push_back(std::move(value));
    }
    return place;
}

// If all arguments are constant, their values.
bool constants_of(std::span<const Expr> arguments, std::array<double, 3>& values) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (!arguments[i].is_constant()) {
            return false;
        }
        values[i] = arguments[i].node().value;
    }
    return true;
}

Op with_arguments(Op one, std::size_t count) {
    return static_cast<Op>(static_cast<std::size_t>(one) + count - 1);
}

}  // namespace

Expr Graph::lookup(std::shared_ptr<const Table> table, std::span<const Expr> at) {
    assert(!at.empty() && at.size() == table->axes.size());
    std::array<double, 3> values{};
    if (constants_of(at, values)) {
        return constant((*table)(std::span(values).first(at.size())));
    }
    Node node;
    node.op = with_arguments(Op::lookup, at.size());
    for (std::size_t i = 0; i < at.size(); ++i) {
        node.arguments[i] = at[i].id();
    }
    node.detail = TableId(place_in(tables_, std::move(table))).value();
    derivative_tables_.resize(tables_.size());
    return intern(node);
}

Expr Graph::lookup(std::shared_ptr<const Table> table, Expr x) {
    return lookup(std::move(table), std::span(&x, 1));
}

Expr Graph::native(std::shared_ptr<const Native> function, std::span<const Expr> at) {
    assert(!at.empty() && at.size() == function->arity() && at.size() <= 3);
    std::array<double, 3> values{};
    if (constants_of(at, values)) {
        const std::array<const double*, 3> arguments{&values[0], &values[1], &values[2]};
        double result = 0.0;
        function->evaluate(1, arguments.data(), &result);
        return constant(result);
    }
    Node node;
    node.op = with_arguments(Op::native, at.size());
    for (std::size_t i = 0; i < at.size(); ++i) {
        node.arguments[i] = at[i].id();
    }
    node.detail = NativeId(place_in(natives_, std::move(function))).value();
    return intern(node);
}

std::shared_ptr<const Table> Graph::derivative_table(TableId id, std::size_t axis) {
    std::shared_ptr<const Table>& made = derivative_tables_[id.value()][axis];
    if (!made) {
        made = std::make_shared<const Table>(tables_[id.value()]->derivative(axis));
    }
    return made;
}

Expr Graph::remake(const Graph& source, const Node& node, std::span<const Expr> arguments) {
    switch (node.op) {
        case Op::constant: return constant(node.value);
        case Op::input: return input(source.inputs_[node.detail]);
        case Op::variable: return variable(node.detail);
        default: break;
    }
    if (is_lookup(node.op)) {
        return lookup(source.table(TableId(node.detail)), arguments);
    }
    if (is_native(node.op)) {
        return native(source.native(NativeId(node.detail)), arguments);
    }
    return apply(node.op, arguments);
}

Expr Graph::apply(Op op, std::span<const Expr> arguments) {
    assert(operation(op).scalar != nullptr &&
           "leaves, look-ups and natives have functions of their own");
    assert(static_cast<int>(arguments.size()) == operation(op).arity);
    if (const Expr simpler = apply_local_rules(*this, op, arguments); simpler.valid()) {
        return simpler;
    }
    Node node;
    node.op = op;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        assert(&arguments[i].graph() == this);
        node.arguments[i] = arguments[i].id();
    }
    if (operation(op).commutative && node.arguments[1] < node.arguments[0]) {
        std::swap(node.arguments[0], node.arguments[1]);
    }
    return intern(node);
}

}  // namespace balcony::expr
