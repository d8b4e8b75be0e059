// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "balcony/expr.hpp"

namespace balcony::expr {

namespace {

// A formula and how tightly it binds, so that only needed parentheses are written.
struct Text {
    std::string text;
    Precedence binding = Precedence::atom;
};

std::string enclosed(const Text& operand, bool enclose) {
    return enclose ? "(" + operand.text + ")" : operand.text;
}

/// Writes the nodes below some expressions, arguments first.
class Printer {
public:
    explicit Printer(std::span<const Expr> expressions)
        : graph_(expressions.front().graph()),
          expressions_(expressions),
          uses_(graph_.size(), 0),
          sections_(graph_.size(), 0),
          is_root_(graph_.size(), false),
          names_(graph_.size()),
          texts_(graph_.size()) {}

    std::string run(std::span<const std::string> names, std::span<const NamedStep> steps) {
        std::vector<NodeId> nodes = reachable(graph_, expressions_);
        count_uses(nodes);
        assign(names, steps);
        std::stable_sort(nodes.begin(), nodes.end(), [this](NodeId a, NodeId b) {
            return sections_[a.value()] < sections_[b.value()];
        });
        // A long single formula is split as well, for readability.
        constexpr std::size_t longest = 160;
        std::vector<std::size_t> shared(steps.size() + 1, 0);
        std::string result;
        for (const NodeId id : nodes) {
            Text text = print_node(id);
            std::string& name = names_[id.value()];
            const std::size_t users = uses_[id.value()];
            if (!graph_.arguments(id).empty() && (users > 1 || text.text.size() > longest ||
                                                  (!name.empty() && !is_root_[id.value()]))) {
                const std::size_t section = sections_[id.value()];
                if (name.empty()) {
                    name = fmt::format("{}{}",
                                       section < steps.size() ? steps[section].name + "_" : "s",
                                       ++shared[section]);
                }
                result += fmt::format("{} = {}\n", name, text.text);
                text = {name};
            }
            texts_[id.value()] = std::move(text);
        }
        for (std::size_t i = 0; i < expressions_.size(); ++i) {
            const std::string& text = texts_[expressions_[i].id().value()].text;
            result += text == names[i] ? "" : fmt::format("{} = {}\n", names[i], text);
        }
        return result;
    }

private:
    // A node belongs to the first step whose values are made of it, or to none; so does what it is
    // made of, or to an earlier one. What an expression and a step give has the expression's name.
    void assign(std::span<const std::string> names, std::span<const NamedStep> steps) {
        std::fill(sections_.begin(), sections_.end(), steps.size());
        for (std::size_t i = steps.size(); i-- > 0;) {
            for (const NodeId id : reachable(graph_, steps[i].values)) {
                sections_[id.value()] = i;
            }
        }
        const auto name = [this](Expr value, const std::string& given) {
            std::string& own = names_[value.id().value()];
            own = own.empty() ? given : own;
        };
        for (std::size_t i = 0; i < expressions_.size(); ++i) {
            if (sections_[expressions_[i].id().value()] < steps.size()) {
                name(expressions_[i], names[i]);
                is_root_[expressions_[i].id().value()] = true;
            }
        }
        for (const NamedStep& step : steps) {
            for (std::size_t i = 0; i < step.values.size(); ++i) {
                name(step.values[i], fmt::format("{}_{}", step.name, step.value_names[i]));
            }
        }
    }

    void count_uses(std::span<const NodeId> nodes) {
        for (const NodeId id : nodes) {
            for (const NodeId argument : graph_.arguments(id)) {
                ++uses_[argument.value()];
            }
        }
        for (const Expr root : expressions_) {
            ++uses_[root.id().value()];
        }
    }

    [[nodiscard]] const Text& argument(NodeId id, std::size_t number) const {
        return texts_[graph_.arguments(id)[number].value()];
    }

    Text print_node(NodeId id) {
        const Node& node = graph_[id];
        const Operation& row = operation(node.op);
        switch (node.op) {
            case Op::constant:
                if (std::isnan(node.value)) {
                    return {"0 / 0", Precedence::product};
                }
                return {fmt::format("{}", node.value),
                        std::signbit(node.value) ? Precedence::prefix : Precedence::atom};
            case Op::input: return {graph_.input_names()[node.detail]};
            case Op::variable: return {fmt::format("v{}", node.detail)};
            case Op::call: return call(id, function_name(graph_.call_of(id)));
            case Op::result: {
                const std::string& text = argument(id, 0).text;
                const bool only = graph_.call_of(node.operands[0]).result_count() == 1;
                return {only ? text : fmt::format("{}[{}]", text, node.detail)};
            }
            default: return row.infix.empty() ? call(id, std::string(row.name)) : infix(id, row);
        }
    }

    [[nodiscard]] Text infix(NodeId id, const Operation& row) const {
        const Precedence binding = row.precedence;
        const Text& a = argument(id, 0);
        if (row.arity == 1) {
            return {std::string(row.infix) + enclosed(a, a.binding < Precedence::atom), binding};
        }
        // Only sums and products of commuting operands may omit the right parentheses.
        const Text& b = argument(id, 1);
        const bool associative = row.commutative && binding >= Precedence::sum;
        const bool enclose_b = associative ? b.binding < binding : b.binding <= binding;
        return {fmt::format("{} {} {}", enclosed(a, a.binding < binding), row.infix,
                            enclosed(b, enclose_b)),
                binding};
    }

    [[nodiscard]] Text call(NodeId id, const std::string& name) const {
        std::string text = name;
        for (std::size_t i = 0; i < graph_.arguments(id).size(); ++i) {
            text += (i == 0 ? "(" : ", ") + argument(id, i).text;
        }
        return {text + ")"};
    }

    // Different functions of one name are told apart by numbers.
    std::string function_name(const Call& call) {
        const std::string name = call.native ? std::string(call.native->name()) : "lookup";
        std::vector<const void*>& known = functions_[name];
        const auto place = std::find(known.begin(), known.end(), call.function());
        const auto number = place - known.begin();
        if (place == known.end()) {
            known.push_back(call.function());
        }
        return number == 0 ? name : fmt::format("{}_{}", name, number + 1);
    }

    const Graph& graph_;
    std::span<const Expr> expressions_;
    std::vector<std::uint32_t> uses_;
    std::vector<std::size_t> sections_;
    std::vector<bool> is_root_;
    std::vector<std::string> names_;
    std::vector<Text> texts_;
    std::map<std::string, std::vector<const void*>> functions_;
};

}  // namespace

std::string print(std::span<const Expr> expressions, std::span<const std::string> names,
                  std::span<const NamedStep> steps) {
    assert(expressions.size() == names.size());
    return expressions.empty() ? std::string() : Printer(expressions).run(names, steps);
}

std::string print(Expr expression) {
    const std::string name = "f";
    return print(std::span(&expression, 1), std::span(&name, 1));
}

}  // namespace balcony::expr
