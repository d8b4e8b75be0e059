// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <unordered_map>

#include "program/tape.hpp"

namespace balcony::program {

namespace {

using expr::Expr;
using expr::Graph;
using expr::Node;
using expr::NodeId;
using expr::Op;

std::size_t index(Rate rate) { return static_cast<std::size_t>(rate); }

// The size of a register of a rate, in doubles.
constexpr std::array<std::uint32_t, 4> register_doubles{register_alignment, max_tile_width,
                                                        max_tile_height, max_tile_width};
static_assert(max_points <= max_tile_width && max_points <= max_tile_height);

bool is_leaf(Op op) { return op == Op::constant || op == Op::input; }

// The nodes below the roots in depth-first order, arguments first, so that a value is used soon
// after it is computed and few registers are live at a time.
std::vector<NodeId> schedule(const Graph& graph, std::span<const Expr> roots) {
    struct Visit {
        NodeId id;
        std::size_t next_argument;
    };
    std::vector<NodeId> order;
    std::vector<bool> seen(graph.size(), false);
    std::vector<Visit> path;
    const auto enter = [&](NodeId id) {
        if (id.valid() && !seen[id.value()]) {
            seen[id.value()] = true;
            path.push_back({id, 0});
        }
    };
    for (const Expr& root : roots) {
        enter(root.id());
        while (!path.empty()) {
            Visit& visit = path.back();
            const Node& node = graph[visit.id];
            if (visit.next_argument < node.arguments.size()) {
                enter(node.arguments[visit.next_argument++]);
            } else {
                order.push_back(visit.id);
                path.pop_back();
            }
        }
    }
    return order;
}

// Registers of one rate; freed registers are reused to keep their number small.
class RegisterPool {
public:
    std::uint32_t take() {
        if (free_.empty()) {
            return count_++;
        }
        const std::uint32_t number = free_.back();
        free_.pop_back();
        return number;
    }
    void give_back(std::uint32_t number) { free_.push_back(number); }
    [[nodiscard]] std::uint32_t count() const { return count_; }

private:
    std::vector<std::uint32_t> free_;
    std::uint32_t count_ = 0;
};

class Compiler {
public:
    Compiler(std::span<const Expr> roots, const Interface& interface)
        : graph_(roots.front().graph()),
          roots_(roots),
          rates_(rates_of(graph_, interface)),
          order_(schedule(graph_, roots)),
          values_(graph_.size()) {
        tape_->interface = interface;
    }

    std::shared_ptr<const Tape> run() {
        find_last_uses();
        assign_registers();
        place_registers();
        emit();
        return tape_;
    }

private:
    static constexpr std::size_t never = ~std::size_t{0};

    struct Value {
        Rate rate = Rate::uniform;
        std::size_t last_use = 0;  ///< Position in order_; `never` if the register is never freed.
        std::uint32_t number = 0;  ///< Index among the registers of its rate.
        std::uint32_t uses = 0;    ///< Number of instructions and roots that use it.
        std::int32_t root = -1;    ///< The last root with this value.
        std::uint32_t replica =
            0;  ///< For a row value that pixel instructions read, counted from 1.
    };

    Value& value(NodeId id) { return values_[id.value()]; }

    Rate rate_of(NodeId id) const {
        const Rate rate = rates_(graph_.dependence(id));
        const bool for_points = tape_->interface.sampling == Sampling::points;
        return for_points && rate != Rate::uniform ? Rate::pixel : rate;
    }

    template <class Function>
    void for_arguments(NodeId id, Function function) {
        for (const NodeId argument : graph_[id].arguments) {
            if (argument.valid()) {
                function(argument);
            }
        }
    }

    // A value that is read at another rate or by a root, or is written by the runner, keeps its
    // register permanently; any other is dead after its last use.
    void find_last_uses() {
        for (std::size_t step = 0; step < order_.size(); ++step) {
            const NodeId id = order_[step];
            Value& made = value(id);
            made.rate = rate_of(id);
            made.last_use = is_leaf(graph_[id].op) ? never : step;
            for_arguments(id, [&](NodeId argument) {
                Value& read = value(argument);
                ++read.uses;
                if (read.rate != made.rate) {
                    read.last_use = never;
                } else if (read.last_use != never) {
                    read.last_use = step;
                }
            });
        }
        for (std::size_t i = 0; i < roots_.size(); ++i) {
            Value& root = value(roots_[i].id());
            root.last_use = never;
            root.root = static_cast<std::int32_t>(i);
            ++root.uses;
        }
    }

    // Every kernel reads a point of its arguments before it writes that point of its result, so a
    // result may take the register of an argument that dies with it. Leaves are filled in before
    // the first instruction runs, so their registers are allocated before any is freed.
    void assign_registers() {
        for (const NodeId id : order_) {
            if (is_leaf(graph_[id].op)) {
                value(id).number = pools_[index(value(id).rate)].take();
            }
        }
        for (std::size_t step = 0; step < order_.size(); ++step) {
            const NodeId id = order_[step];
            Value& made = value(id);
            for_arguments(id, [&](NodeId argument) {
                Value& read = value(argument);
                if (read.last_use == step) {
                    pools_[index(read.rate)].give_back(read.number);
                    read.last_use = never;  // an argument used twice is freed once
                }
                if (made.rate == Rate::pixel && read.rate == Rate::row && read.replica == 0) {
                    read.replica = ++replicas_;
                }
            });
            if (!is_leaf(graph_[id].op)) {
                made.number = pools_[index(made.rate)].take();
            }
        }
    }

    // Arranges the registers: first those that are read most often while pixels are computed.
    void place_registers() {
        std::uint32_t at = replicas_ * static_cast<std::uint32_t>(register_alignment);
        for (const Rate rate : {Rate::uniform, Rate::column, Rate::pixel, Rate::row}) {
            base_[index(rate)] = at;
            at += pools_[index(rate)].count() * register_doubles[index(rate)];
        }
        tape_->register_doubles = at;
    }

    std::uint32_t offset(NodeId id) {
        const Value& of = value(id);
        return base_[index(of.rate)] + of.number * register_doubles[index(of.rate)];
    }

    Operand operand(NodeId argument, Rate reader) {
        constexpr std::uint32_t varies = ~std::uint32_t{0};
        const Value& read = value(argument);
        if (read.rate == Rate::row && reader == Rate::pixel) {
            return {replica_offset(read), 0};
        }
        return {offset(argument), read.rate == Rate::uniform ? 0 : varies};
    }

    static std::uint32_t replica_offset(const Value& row_value) {
        return (row_value.replica - 1) * static_cast<std::uint32_t>(register_alignment);
    }

    void emit() {
        collect_tables();
        collect_natives();
        for (const NodeId id : order_) {
            const Node& node = graph_[id];
            if (node.op == Op::constant) {
                tape_->constants.push_back({offset(id), node.value});
            } else if (node.op == Op::input) {
                tape_->inputs.push_back(
                    {source(expr::InputId(node.detail)), value(id).rate, offset(id)});
            } else {
                tape_->sections[index(value(id).rate)].push_back(instruction(id));
            }
            if (value(id).replica != 0) {
                tape_->replications.push_back({offset(id), replica_offset(value(id))});
            }
        }
        for (const Expr& root : roots_) {
            tape_->roots.push_back(
                {value(root.id()).rate, offset(root.id()), made_in_place(root.id())});
        }
    }

    std::uint32_t source(expr::InputId id) const {
        if (id.value() < Tape::Input::first_declared) {
            return id.value();
        }
        const std::vector<Input>& declared = tape_->interface.inputs;
        const auto found = std::find_if(declared.begin(), declared.end(), [&](const Input& input) {
            return input.name == graph_.input_names()[id.value()];
        });
        assert(found != declared.end());
        return Tape::Input::first_declared + static_cast<std::uint32_t>(found - declared.begin());
    }

    // A pixel value that is one root and has no other use needs no register.
    bool made_in_place(NodeId id) {
        const Value& made = value(id);
        return made.rate == Rate::pixel && !is_leaf(graph_[id].op) && made.root >= 0 &&
               made.uses == 1;
    }

    Instruction instruction(NodeId id) {
        const Node& node = graph_[id];
        Instruction made;
        made.op = node.op;
        made.result = offset(id);
        made.root = made_in_place(id) ? value(id).root : -1;
        for (std::size_t i = 0; i < node.arguments.size(); ++i) {
            if (node.arguments[i].valid()) {
                made.arguments[i] = operand(node.arguments[i], value(id).rate);
            }
        }
        made.scalar = expr::operation(node.op).scalar;
        if (expr::is_lookup(node.op)) {
            made.table = &tape_->table_views[table_numbers_.at(node.detail)];
        } else if (expr::is_native(node.op)) {
            made.native = &tape_->native_calls[native_numbers_.at(node.detail)];
        }
        return made;
    }

    void collect_tables() {
        for (const NodeId id : order_) {
            const Node& node = graph_[id];
            if (!expr::is_lookup(node.op) ||
                !table_numbers_.emplace(node.detail, tape_->tables.size()).second) {
                continue;
            }
            const std::shared_ptr<const expr::Table>& table =
                graph_.table(expr::TableId(node.detail));
            tape_->tables.push_back(table);
            tape_->table_views.push_back(view_of(*table));
        }
    }

    static TableView view_of(const expr::Table& table) {
        TableView view;
        view.coefficients = table.coefficients.data();
        std::size_t power_stride = 1;
        for (std::size_t i = table.axes.size(); i-- > 0;) {
            const expr::Table::Axis& axis = table.axes[i];
            const auto count = static_cast<double>(axis.cells);
            view.axes[i] = {axis.first,   count / (axis.last - axis.first),
                            count - 1.0,  0.0,
                            power_stride, axis.degree};
            power_stride *= axis.degree + 1;
        }
        auto cell_stride = static_cast<double>(power_stride);
        for (std::size_t i = table.axes.size(); i-- > 0;) {
            view.axes[i].cell_stride = cell_stride;
            cell_stride *= static_cast<double>(table.axes[i].cells);
        }
        return view;
    }

    void collect_natives() {
        const auto evaluate = [](const void* function, std::size_t count,
                                 const double* const* arguments, double* results) {
            static_cast<const expr::Native*>(function)->evaluate(count, arguments, results);
        };
        for (const NodeId id : order_) {
            const Node& node = graph_[id];
            if (!expr::is_native(node.op) ||
                !native_numbers_.emplace(node.detail, tape_->natives.size()).second) {
                continue;
            }
            const std::shared_ptr<const expr::Native>& native =
                graph_.native(expr::NativeId(node.detail));
            tape_->natives.push_back(native);
            tape_->native_calls.push_back({native.get(), evaluate, native->arity()});
        }
    }

    const Graph& graph_;
    std::span<const Expr> roots_;
    expr::Rates rates_;
    std::vector<NodeId> order_;
    std::vector<Value> values_;  ///< Indexed by NodeId.
    std::array<RegisterPool, 4> pools_;
    std::array<std::uint32_t, 4> base_{};
    std::uint32_t replicas_ = 0;
    std::unordered_map<std::uint32_t, std::size_t> table_numbers_;
    std::unordered_map<std::uint32_t, std::size_t> native_numbers_;
    std::shared_ptr<Tape> tape_ = std::make_shared<Tape>();
};

}  // namespace

expr::Rates rates_of(const Graph& graph, const Interface& interface) {
    expr::Rates rates;
    const std::span<const std::string> names = graph.input_names();
    for (std::size_t i = Tape::Input::first_declared; i < names.size(); ++i) {
        for (const Input& input : interface.inputs) {
            if (input.name == names[i]) {
                rates.declare(expr::InputId(i), input.rate);
            }
        }
    }
    return rates;
}

std::shared_ptr<const Tape> compile(std::span<const Expr> roots, const Interface& interface) {
    if (roots.empty()) {
        const auto tape = std::make_shared<Tape>();
        tape->interface = interface;
        return tape;
    }
    assert(std::all_of(roots.begin(), roots.end(), [&](const Expr& root) {
        return root.valid() && &root.graph() == &roots.front().graph();
    }));
    return Compiler(roots, interface).run();
}

}  // namespace balcony::program
