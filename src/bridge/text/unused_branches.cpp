// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/text/unused_branches.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace balcony::bridge {

namespace {

using expr::Graph;
using expr::NodeId;

constexpr std::array harmless_operands{
    HarmlessOperand{Op::divide, 1, 1.0},
    HarmlessOperand{Op::modulo, 1, 1.0},
    HarmlessOperand{Op::square_root, 0, 1.0},
    HarmlessOperand{Op::power, 0, 1.0},
    HarmlessOperand{Op::exponential, 0, 0.0},
    HarmlessOperand{Op::logarithm, 0, 1.0},
    HarmlessOperand{Op::arcsine, 0, 0.0},
    HarmlessOperand{Op::arccosine, 0, 0.0},
    HarmlessOperand{Op::arctangent2, 1, 1.0},
    HarmlessOperand{Op::hyperbolic_sine, 0, 0.0},
    HarmlessOperand{Op::hyperbolic_cosine, 0, 0.0},
    HarmlessOperand{Op::inverse_hyperbolic_cosine, 0, 2.0},
    HarmlessOperand{Op::inverse_hyperbolic_tangent, 0, 0.0},
};

/// Where the value of a node is used for a number: nowhere, under any of some conditions, or
/// everywhere.
class Use {
public:
    void add_everywhere() {
        everywhere_ = true;
        conditions_.clear();
    }
    void add(Expr condition) {
        const auto is = [condition](bool (*test)(Expr, Expr)) {
            return [condition, test](Expr known) { return test(known, condition); };
        };
        if (everywhere_ || any_of(is([](Expr a, Expr b) { return a.same(b); }))) {
            return;
        }
        if (any_of(is(are_opposite))) {
            add_everywhere();
            return;
        }
        conditions_.push_back(condition);
        if (conditions_.size() > most_conditions) {
            conditions_ = {condition_of(conditions_)};
        }
    }
    /// Uses of something else, where a condition holds.
    void add(const Use& other, std::optional<Expr> condition) {
        if (other.everywhere_ && !condition) {
            add_everywhere();
        } else if (other.everywhere_) {
            add(*condition);
        }
        for (const Expr known : other.conditions_) {
            add(condition && !known.same(*condition) ? known && *condition : known);
        }
    }

    [[nodiscard]] bool everywhere() const { return everywhere_; }
    [[nodiscard]] bool nowhere() const { return !everywhere_ && conditions_.empty(); }
    /// Nothing if it is used everywhere or nowhere.
    [[nodiscard]] std::optional<Expr> condition() const {
        return conditions_.empty() ? std::nullopt : std::optional(condition_of(conditions_));
    }

private:
    static constexpr std::size_t most_conditions = 8;

    template <typename Test>
    [[nodiscard]] bool any_of(const Test& test) const {
        return std::any_of(conditions_.begin(), conditions_.end(), test);
    }
    static bool are_opposite(Expr a, Expr b) {
        return (a.op() == Op::logical_not && a.argument(0).same(b)) ||
               (b.op() == Op::logical_not && b.argument(0).same(a));
    }
    static Expr condition_of(const std::vector<Expr>& conditions) {
        Expr any = conditions.front();
        for (const Expr condition : conditions) {
            any = any.same(condition) ? any : any || condition;
        }
        return any;
    }

    bool everywhere_ = false;
    std::vector<Expr> conditions_;
};

class Guard {
public:
    explicit Guard(CameraFormulas& formulas)
        : formulas_(formulas),
          graph_(*formulas.graph),
          nodes_(expr::reachable(graph_, formulas.roots)),
          uses_(graph_.size()),
          guarded_(graph_.size()) {}

    void run() {
        for (std::size_t i = 0; i < formulas_.roots.size(); ++i) {
            if (i != formulas_.condition) {
                uses_[formulas_.roots[i].id().value()].add_everywhere();
            }
        }
        for (auto id = nodes_.rbegin(); id != nodes_.rend(); ++id) {
            pass_on(*id);
        }
        for (const NodeId id : nodes_) {
            guarded_[id.value()] = guarded(id);
        }
        for (std::size_t i = 0; i < formulas_.roots.size(); ++i) {
            Expr& root = formulas_.roots[i];
            root = i == formulas_.condition ? with_guarded_numbers(root) : replacement(root);
        }
        for (StageFormulas& stage : formulas_.stages) {
            for (Expr& value : stage.values) {
                value = replacement(value);
            }
        }
    }

private:
    [[nodiscard]] Expr at(NodeId id) const { return {graph_, id}; }

    [[nodiscard]] Expr replacement(Expr old) const {
        const bool known = old.id().value() < guarded_.size();
        return known && guarded_[old.id().value()].valid() ? guarded_[old.id().value()] : old;
    }

    // A condition whose numbers are the guarded ones where these are the same, so that they are
    // computed once.
    [[nodiscard]] Expr with_guarded_numbers(Expr condition) const {
        std::vector<Expr> made(uses_.size());
        for (const NodeId id : expr::reachable(graph_, std::span(&condition, 1))) {
            std::vector<Expr> operands;
            for (const NodeId operand : graph_.arguments(id)) {
                operands.push_back(made[operand.value()]);
            }
            made[id.value()] =
                uses_[id.value()].everywhere() ? replacement(at(id)) : with_operands(id, operands);
        }
        return made[condition.id().value()];
    }

    [[nodiscard]] Expr with_operands(NodeId id, const std::vector<Expr>& operands) const {
        const std::span<const NodeId> arguments = graph_.arguments(id);
        const bool same =
            std::equal(operands.begin(), operands.end(), arguments.begin(),
                       [](Expr operand, NodeId argument) { return operand.id() == argument; });
        const expr::Node node = graph_[id];
        return same ? at(id) : graph_.remake(graph_, node, operands);
    }

    [[nodiscard]] std::vector<Expr> operands_of(NodeId id) const {
        std::vector<Expr> operands;
        for (const NodeId operand : graph_.arguments(id)) {
            operands.push_back(at(operand));
        }
        return operands;
    }

    /// Where a minimum or a maximum is its second operand.
    [[nodiscard]] static std::optional<Expr> is_second(Op op, const std::vector<Expr>& operands) {
        return op == Op::minimum   ? std::optional(operands[1] < operands[0])
               : op == Op::maximum ? std::optional(operands[0] < operands[1])
                                   : std::nullopt;
    }

    // Uses of a node are uses of its operands, except of those that only decide.
    void pass_on(NodeId id) {
        const Use use = uses_[id.value()];
        const Op op = graph_[id].op;
        if (use.nowhere() || decides(op)) {
            return;
        }
        const std::vector<Expr> operands = operands_of(id);
        if (op == Op::select) {
            add(operands[1], use, operands[0]);
            add(operands[2], use, !operands[0]);
        } else if (const auto second = is_second(op, operands)) {
            add(operands[0], use, !*second);
            add(operands[1], use, *second);
        } else {
            for (const Expr operand : operands) {
                add(operand, use, std::nullopt);
            }
        }
    }

    // Conditions and steps have no derivative.
    [[nodiscard]] static bool decides(Op op) {
        return expr::operation(op).condition || op == Op::floor || op == Op::sign;
    }

    void add(Expr operand, const Use& use, std::optional<Expr> condition) {
        uses_[operand.id().value()].add(use, condition);
    }

    // The node with its operands guarded; what only decides stays as it is, since guards depend on
    // it.
    [[nodiscard]] Expr guarded(NodeId id) {
        const Use& use = uses_[id.value()];
        const Op op = graph_[id].op;
        if (use.nowhere() || decides(op)) {
            return at(id);
        }
        const std::vector<Expr> given = operands_of(id);
        std::vector<Expr> operands;
        for (std::size_t i = 0; i < given.size(); ++i) {
            const bool decides = op == Op::select && i == 0;
            operands.push_back(decides ? given[i] : guarded_[given[i].id().value()]);
        }
        const HarmlessOperand* harmless = harmless_operand(graph_, id);
        if (const auto condition = use.condition(); harmless != nullptr && condition) {
            Expr& operand = operands[harmless->operand];
            operand = select(*condition, operand, graph_.constant(harmless->number));
        }
        const Expr made = with_operands(id, operands);
        // Guarded operands must not decide which of them is the smaller one.
        const auto second = made.same(at(id)) ? std::nullopt : is_second(op, given);
        return second ? select(*second, operands[1], operands[0]) : made;
    }

    CameraFormulas& formulas_;
    Graph& graph_;
    const std::vector<NodeId> nodes_;
    std::vector<Use> uses_;      ///< By node.
    std::vector<Expr> guarded_;  ///< By node.
};

}  // namespace

const HarmlessOperand* harmless_operand(const Graph& graph, NodeId id) {
    const auto found =
        std::find_if(harmless_operands.begin(), harmless_operands.end(),
                     [&](const HarmlessOperand& row) { return row.op == graph[id].op; });
    return found != harmless_operands.end() &&
                   graph[graph.arguments(id)[found->operand]].op != Op::constant
               ? &*found
               : nullptr;
}

Result<CameraFormulas> with_guarded_branches(CameraFormulas formulas, std::string_view camera) {
    try {
        Guard(formulas).run();
        return formulas;
    } catch (const expr::GraphTooLarge&) {
        return too_large_error(camera);
    }
}

}  // namespace balcony::bridge
