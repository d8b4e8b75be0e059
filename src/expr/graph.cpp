// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <bit>

#include "balcony/expr.hpp"
#include "expr/local_rules.hpp"

namespace balcony::expr {

namespace {

std::uint8_t leaf_dependency(Op op) {
    switch (op) {
        case Op::picture_x: return depends::on_x;
        case Op::picture_y: return depends::on_y;
        case Op::time: return depends::on_time;
        case Op::variable: return depends::on_variable;
        default: return 0;
    }
}

}  // namespace

// Constants are the same if their bits are, so that 0 and -0 stay apart and a NaN equals itself.
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

Expr Graph::intern(Node node) {
    node.depends = leaf_dependency(node.op);
    for (const NodeId argument : node.arguments) {
        if (argument.valid()) {
            node.depends |= nodes_[argument.value()].depends;
        }
    }
    const auto [known, is_new] = known_.try_emplace(node, NodeId(nodes_.size()));
    if (is_new) {
        nodes_.push_back(node);
    }
    return {*this, known->second};
}

Expr Graph::constant(double value) {
    Node node;
    node.value = value;
    return intern(node);
}

Expr Graph::picture_x() {
    Node node;
    node.op = Op::picture_x;
    return intern(node);
}

Expr Graph::picture_y() {
    Node node;
    node.op = Op::picture_y;
    return intern(node);
}

Expr Graph::time() {
    Node node;
    node.op = Op::time;
    return intern(node);
}

Expr Graph::variable(std::uint32_t number) {
    variables_ = std::max(variables_, number + 1);
    Node node;
    node.op = Op::variable;
    node.detail = number;
    return intern(node);
}

Expr Graph::fresh_variable() { return variable(variables_); }

Expr Graph::lookup(std::shared_ptr<const Table> table, Expr x) {
    if (x.is_constant()) {
        return constant((*table)(x.node().value));
    }
    TableId id(tables_.size());
    for (std::size_t i = 0; i < tables_.size(); ++i) {
        if (tables_[i] == table) {
            id = TableId(i);
        }
    }
    if (id.value() == tables_.size()) {
        tables_.push_back(std::move(table));
        derivative_tables_.emplace_back();
    }
    Node node;
    node.op = Op::lookup;
    node.arguments[0] = x.id();
    node.detail = id.value();
    return intern(node);
}

std::shared_ptr<const Table> Graph::derivative_table(TableId id) {
    std::shared_ptr<const Table>& made = derivative_tables_[id.value()];
    if (!made) {
        made = std::make_shared<const Table>(tables_[id.value()]->derivative());
    }
    return made;
}

Expr Graph::apply(Op op, std::span<const Expr> arguments) {
    assert(operation(op).scalar != nullptr && "leaves and look-ups have functions of their own");
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
