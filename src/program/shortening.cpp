// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "program/shortening.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include "program/tape.hpp"

namespace balcony::program {

namespace {

using expr::Expr;
using expr::Graph;
using expr::Node;
using expr::NodeId;
using expr::Op;
using expr::Range;

// What a smaller tile takes is less than what deciding about it does.
constexpr std::size_t fewest_points = 64;

// The formulas of a larger program would take more memory than its tape.
constexpr std::size_t most_nodes = std::size_t{1} << 16U;

// A picture whose tiles decide in more ways is run as a whole in the rest of them.
constexpr std::size_t most_tapes = 32;

Range range_between(double first, double last) {
    return {std::min(first, last), std::max(first, last), std::isnan(first) || std::isnan(last)};
}

Range range_of_values(std::span<const double> values) {
    Range range{values.front(), values.front(), false};
    for (const double value : values) {
        range.least = std::min(range.least, value);
        range.most = std::max(range.most, value);
        range.may_be_nan = range.may_be_nan || std::isnan(value);
    }
    return range;
}

// The expressions in another graph, node by node, but for some that another one stands for.
template <class Replaced>
std::vector<Expr> copied(Graph& target, std::span<const Expr> roots, const Replaced& replaced) {
    const Graph& source = roots.front().graph();
    std::vector<Expr> made(source.size());
    std::vector<Expr> arguments;
    for (const NodeId id : expr::reachable(source, roots)) {
        arguments.clear();
        for (const NodeId argument : source.arguments(id)) {
            arguments.push_back(made[argument.value()]);
        }
        const Expr other = replaced(id, arguments);
        made[id.value()] = other.valid() ? other : target.copy(source, source[id], arguments);
    }
    std::vector<Expr> copies;
    for (const Expr root : roots) {
        copies.push_back(made[root.id().value()]);
    }
    return copies;
}

}  // namespace

bool Shortening::may_branch(NodeId id, const expr::Rates& rates) const {
    const expr::Operation& row = expr::operation(graph_[id].op);
    return (row.condition || row.chosen != nullptr) &&
           rates(graph_.dependence(id)) != Rate::uniform;
}

std::shared_ptr<const Shortening> Shortening::make(std::span<const Expr> roots,
                                                   const Interface& interface,
                                                   std::size_t instructions) {
    const auto chooses = [&](NodeId id) {
        return expr::operation(roots.front().graph()[id].op).chosen != nullptr;
    };
    const std::vector<NodeId> reached = expr::reachable(roots.front().graph(), roots);
    if (reached.size() > most_nodes || std::none_of(reached.begin(), reached.end(), chooses)) {
        return nullptr;
    }
    std::shared_ptr<Shortening> made(new Shortening(interface, instructions));
    Graph& graph = made->graph_;
    made->roots_ = copied(graph, roots, [](NodeId, std::span<const Expr>) { return Expr(); });
    const expr::Rates rates = rates_of(graph, interface);
    std::vector<Expr> branches;
    for (const NodeId id : expr::reachable(graph, made->roots_)) {
        if (made->may_branch(id, rates)) {
            made->branches_.push_back(id);
            branches.emplace_back(graph, id);
        }
    }
    if (branches.empty()) {
        return nullptr;
    }
    std::vector<std::uint32_t> places(graph.size());
    for (const NodeId id : expr::reachable(graph, branches)) {
        places[id.value()] = static_cast<std::uint32_t>(made->steps_.size());
        Step& step = made->steps_.emplace_back(Step{&graph[id], {}, made->may_branch(id, rates)});
        if (graph[id].op != Op::call && graph[id].op != Op::result) {
            std::transform(graph[id].operands.begin(),
                           graph[id].operands.begin() + expr::operation(graph[id].op).arity,
                           step.arguments.begin(),
                           [&](NodeId argument) { return places[argument.value()]; });
        }
    }
    return made;
}

Range Shortening::leaf_range(const Node& leaf, const Tile& tile) const {
    if (leaf.op == Op::constant) {
        return range_between(leaf.value, leaf.value);
    }
    switch (leaf.detail) {
        case Tape::Input::x: return range_between(tile.column(0), tile.column(tile.width - 1));
        case Tape::Input::y: return range_between(tile.row(0), tile.row(tile.height - 1));
        case Tape::Input::time: return range_between(tile.time, tile.time);
        default: break;
    }
    const auto& declared = interface_.inputs;
    const auto found = std::find_if(declared.begin(), declared.end(), [&](const Input& input) {
        return input.name == graph_.input_names()[leaf.detail];
    });
    return found->rate == Rate::pixel
               ? Range{}
               : range_of_values(tile.inputs[static_cast<std::size_t>(found - declared.begin())]);
}

Shortening::Decision Shortening::decision(Op op, const Range& range, const Range* arguments) {
    if (expr::operation(op).condition) {
        if (range.least != range.most) {
            return Decision::open;
        }
        return range.most > 0.0 ? Decision::always : Decision::never;
    }
    constexpr std::array choices{Decision::argument_0, Decision::argument_1, Decision::argument_2};
    const std::optional<std::size_t> chosen = expr::chosen_argument(op, arguments);
    return chosen ? choices[*chosen] : Decision::open;
}

std::vector<Shortening::Decision> Shortening::decide(const Tile& tile) const {
    std::vector<Range> ranges;
    ranges.reserve(steps_.size());
    std::vector<Decision> decisions;
    decisions.reserve(branches_.size());
    std::array<Range, Node::max_operands> arguments;
    for (const Step& step : steps_) {
        const Op op = step.node->op;
        if (op == Op::constant || op == Op::input) {
            ranges.push_back(leaf_range(*step.node, tile));
            continue;
        }
        // Those that a step does not have are those of the first step.
        std::transform(step.arguments.begin(), step.arguments.end(), arguments.begin(),
                       [&](std::uint32_t argument) { return ranges[argument]; });
        const bool is_square = op == Op::multiply && step.arguments[0] == step.arguments[1];
        ranges.push_back(is_square ? expr::range_of_square(arguments[0])
                                   : expr::range_of(op, arguments.data()));
        if (step.branches) {
            decisions.push_back(decision(op, ranges.back(), arguments.data()));
        }
    }
    return decisions;
}

const Shortening::Shortened* Shortening::find(const std::vector<Decision>& decisions) const {
    const auto found = std::find_if(made_.begin(), made_.end(), [&](const Shortened& one) {
        return one.decisions == decisions;
    });
    return found == made_.end() ? nullptr : &*found;
}

std::shared_ptr<const Tape> Shortening::shortened(const std::vector<Decision>& decisions) const {
    Graph graph;
    std::size_t next = 0;
    const auto replaced = [&](NodeId id, std::span<const Expr> arguments) {
        if (next == branches_.size() || branches_[next] != id) {
            return Expr();
        }
        switch (decisions[next++]) {
            case Decision::open: break;
            case Decision::argument_0: return arguments[0];
            case Decision::argument_1: return arguments[1];
            case Decision::argument_2: return arguments[2];
            case Decision::never: return graph.constant(0.0);
            case Decision::always: return graph.constant(1.0);
        }
        return Expr();
    };
    const std::vector<Expr> roots = copied(graph, roots_, replaced);
    std::shared_ptr<const Tape> tape = compile(roots, interface_);
    return tape->section(Rate::pixel).size() < instructions_ ? tape : nullptr;
}

std::shared_ptr<const Tape> Shortening::tape_for(const Tile& tile) const {
    if (tile.width * tile.height < fewest_points) {
        return nullptr;
    }
    const std::vector<Decision> decisions = decide(tile);
    if (std::count(decisions.begin(), decisions.end(), Decision::open) ==
        static_cast<std::ptrdiff_t>(decisions.size())) {
        return nullptr;
    }
    {
        const std::shared_lock lock(mutex_);
        if (const Shortened* found = find(decisions)) {
            return found->tape;
        }
        if (made_.size() >= most_tapes) {
            return nullptr;
        }
    }
    std::shared_ptr<const Tape> tape = shortened(decisions);
    const std::unique_lock lock(mutex_);
    if (find(decisions) == nullptr && made_.size() < most_tapes) {
        made_.push_back({decisions, tape});
    }
    return tape;
}

}  // namespace balcony::program
