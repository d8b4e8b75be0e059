// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/format.h>

#include "balcony/expr.hpp"

namespace balcony::expr {

namespace {

// The precedence of a text, so that only necessary parentheses are written.
enum class Binding : std::uint8_t {
    disjunction,
    conjunction,
    comparison,
    sum,
    product,
    prefix,
    atom
};

struct Text {
    std::string text;
    Binding binding = Binding::atom;
};

Binding binding_of(Op op) {
    switch (op) {
        case Op::logical_or: return Binding::disjunction;
        case Op::logical_and: return Binding::conjunction;
        case Op::less:
        case Op::less_equal:
        case Op::equal: return Binding::comparison;
        case Op::add:
        case Op::subtract: return Binding::sum;
        case Op::multiply:
        case Op::divide: return Binding::product;
        default: return Binding::prefix;
    }
}

std::string enclosed(const Text& operand, bool enclose) {
    return enclose ? "(" + operand.text + ")" : operand.text;
}

Text print_node(const Graph& graph, const Node& node, std::span<const Text> arguments) {
    const Operation& row = operation(node.op);
    if (node.op == Op::constant) {
        return {fmt::format("{}", node.value),
                std::signbit(node.value) ? Binding::prefix : Binding::atom};
    }
    if (node.op == Op::variable) {
        return {fmt::format("v{}", node.detail)};
    }
    if (node.op == Op::input) {
        return {graph.input_names()[node.detail]};
    }
    if (!row.infix.empty() && row.arity == 1) {
        return {
            std::string(row.infix) + enclosed(arguments[0], arguments[0].binding < Binding::atom),
            Binding::prefix};
    }
    if (!row.infix.empty()) {
        const Binding binding = binding_of(node.op);
        // Only sums and products of commuting operands may omit the right parentheses.
        const bool associative = row.commutative && binding >= Binding::sum;
        return {fmt::format("{} {} {}", enclosed(arguments[0], arguments[0].binding < binding),
                            row.infix,
                            enclosed(arguments[1], associative ? arguments[1].binding < binding
                                                               : arguments[1].binding <= binding)),
                binding};
    }
    std::string call = is_lookup(node.op)   ? fmt::format("lookup_{}", node.detail)
                       : is_native(node.op) ? fmt::format("native_{}", node.detail)
                                            : std::string(row.name);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        call += (i == 0 ? "(" : ", ") + arguments[i].text;
    }
    return {call + ")"};
}

}  // namespace

std::string print(std::span<const Expr> expressions, std::span<const std::string> names) {
    assert(expressions.size() == names.size());
    if (expressions.empty()) {
        return {};
    }
    const Graph& graph = expressions.front().graph();
    const std::vector<NodeId> nodes = reachable(graph, expressions);
    std::vector<std::uint32_t> uses(graph.size(), 0);
    for (const NodeId id : nodes) {
        for (const NodeId argument : graph[id].arguments) {
            if (argument.valid()) {
                ++uses[argument.value()];
            }
        }
    }
    for (const Expr root : expressions) {
        ++uses[root.id().value()];
    }
    // A long single formula is split as well, for readability.
    constexpr std::size_t longest = 160;
    std::vector<Text> texts(graph.size());
    std::string result;
    std::size_t named = 0;
    for (const NodeId id : nodes) {
        const Node& node = graph[id];
        std::array<Text, 3> arguments;
        const auto arity = static_cast<std::size_t>(operation(node.op).arity);
        for (std::size_t i = 0; i < arity; ++i) {
            arguments[i] = texts[node.arguments[i].value()];
        }
        Text text = print_node(graph, node, std::span(arguments).first(arity));
        if (arity > 0 && (uses[id.value()] > 1 || text.text.size() > longest)) {
            const std::string name = fmt::format("s{}", ++named);
            result += fmt::format("{} = {}\n", name, text.text);
            text = {name};
        }
        texts[id.value()] = std::move(text);
    }
    for (std::size_t i = 0; i < expressions.size(); ++i) {
        result += fmt::format("{} = {}\n", names[i], texts[expressions[i].id().value()].text);
    }
    return result;
}

std::string print(Expr expression) {
    const std::string name = "f";
    return print(std::span(&expression, 1), std::span(&name, 1));
}

}  // namespace balcony::expr
