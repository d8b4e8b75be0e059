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
        if (!seen[id.value()]) {
            seen[id.value()] = true;
            path.push_back({id, 0});
        }
    };
    for (const Expr& root : roots) {
        enter(root.id());
        while (!path.empty()) {
            Visit& visit = path.back();
            const std::span<const NodeId> arguments = graph.arguments(visit.id);
            if (visit.next_argument < arguments.size()) {
                enter(arguments[visit.next_argument++]);
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

    std::shared_ptr<Tape> run() {
        for (const auto phase :
             {&Compiler::find_results, &Compiler::find_last_uses, &Compiler::assign_registers,
              &Compiler::place_registers, &Compiler::emit}) {
            if (graph_.stop().stop_requested()) {
                throw expr::GraphStopped();
            }
            (this->*phase)();
        }
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

    // What the instruction of a node reads. A result of a call has none: it stands where the call
    // puts it.
    [[nodiscard]] std::span<const NodeId> read_by(NodeId id) const {
        return graph_[id].op == Op::result ? std::span<const NodeId>() : graph_.arguments(id);
    }

    [[nodiscard]] bool is_native(NodeId id) const {
        return graph_[id].op == Op::call && graph_.call_of(id).native;
    }

    [[nodiscard]] bool is_lookup(NodeId id) const {
        return graph_[id].op == Op::call && graph_.call_of(id).table;
    }

    // Which nodes are the results of each call; none where nothing reads a result.
    void find_results() {
        for (const NodeId id : order_) {
            if (graph_[id].op == Op::result) {
                const NodeId call = graph_.arguments(id)[0];
                std::vector<NodeId>& results = results_[call.value()];
                results.resize(graph_.call_of(call).result_count());
                results[graph_[id].detail] = id;
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
            for (const NodeId argument : read_by(id)) {
                Value& read = value(argument);
                ++read.uses;
                if (read.rate != made.rate) {
                    read.last_use = never;
                } else if (read.last_use != never) {
                    read.last_use = step;
                }
            }
        }
        for (std::size_t i = 0; i < roots_.size(); ++i) {
            Value& root = value(roots_[i].id());
            root.last_use = never;
            root.root = static_cast<std::int32_t>(i);
            ++root.uses;
        }
    }

    // Every kernel reads a point of its arguments before it writes that point of its result, so a
    // result may take the register of an argument that dies with it; natives promise nothing like
    // it. Leaves are filled in before the first instruction runs, so their registers are allocated
    // before any is freed.
    void assign_registers() {
        for (const NodeId id : order_) {
            if (is_leaf(graph_[id].op)) {
                value(id).number = pools_[index(value(id).rate)].take();
            }
        }
        for (std::size_t step = 0; step < order_.size(); ++step) {
            const NodeId id = order_[step];
            if (is_native(id)) {
                take_for_results(id);
            }
            const Rate rate = value(id).rate;
            for (const NodeId argument : read_by(id)) {
                Value& read = value(argument);
                if (read.last_use == step) {
                    pools_[index(read.rate)].give_back(read.number);
                    read.last_use = never;  // an argument used twice is freed once
                }
                if (rate == Rate::pixel && read.rate == Rate::row && read.replica == 0) {
                    read.replica = ++replicas_;
                }
            }
            if (is_lookup(id)) {
                take_for_results(id);
            } else if (expr::operation(graph_[id].op).scalar != nullptr) {
                value(id).number = pools_[index(rate)].take();
            }
        }
    }

    // A result that nothing reads has a register while its call runs.
    void take_for_results(NodeId call) {
        RegisterPool& pool = pools_[index(value(call).rate)];
        std::vector<std::uint32_t>& numbers = call_registers_[call.value()];
        for (const NodeId result : results_[call.value()]) {
            numbers.push_back(pool.take());
            if (result.valid()) {
                value(result).number = numbers.back();
            }
        }
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (!results_[call.value()][i].valid()) {
                pool.give_back(numbers[i]);
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
        tape_->repeated = at;
        for (const NodeId id : order_) {
            if (is_native(id)) {
                const auto count = static_cast<std::uint32_t>(graph_.arguments(id).size());
                at = std::max(at,
                              tape_->repeated + count * static_cast<std::uint32_t>(max_tile_width));
            }
        }
        tape_->register_doubles = at;
    }

    std::uint32_t offset(NodeId id) { return offset(value(id).rate, value(id).number); }

    [[nodiscard]] std::uint32_t offset(Rate rate, std::uint32_t number) const {
        return base_[index(rate)] + number * register_doubles[index(rate)];
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
        for (const NodeId id : order_) {
            const Node& node = graph_[id];
            if (node.op == Op::constant) {
                tape_->constants.push_back({offset(id), node.value});
            } else if (node.op == Op::input) {
                tape_->inputs.push_back(
                    {source(expr::InputId(node.detail)), value(id).rate, offset(id)});
            } else if (node.op != Op::result) {
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

    // A pixel value that is one root and has no other use needs no register, unless it is a result
    // of a native.
    bool made_in_place(NodeId id) {
        const Value& made = value(id);
        const bool of_native = graph_[id].op == Op::result && is_native(graph_.arguments(id)[0]);
        return made.rate == Rate::pixel && !is_leaf(graph_[id].op) && !of_native &&
               made.root >= 0 && made.uses == 1;
    }

    Instruction instruction(NodeId id) {
        const Op op = graph_[id].op;
        Instruction made;
        made.op = op;
        if (is_native(id)) {
            made.native = native_call(id);
            return made;
        }
        // The one result of a look-up is what its call makes.
        const NodeId result = op == Op::call ? results_[id.value()].front() : id;
        made.result = offset(result);
        made.root = made_in_place(result) ? value(result).root : -1;
        const std::span<const NodeId> arguments = graph_.arguments(id);
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            made.arguments[i] = operand(arguments[i], value(id).rate);
        }
        made.scalar = expr::operation(op).scalar;
        if (op == Op::call) {
            made.table = table_view(graph_.call_of(id).table);
        }
        return made;
    }

    const NativeCall* native_call(NodeId id) {
        NativeCall& made = tape_->native_calls.emplace_back();
        made.function = graph_.call_of(id).native;
        for (const NodeId argument : graph_.arguments(id)) {
            made.arguments.push_back(operand(argument, value(id).rate));
        }
        for (const std::uint32_t number : call_registers_[id.value()]) {
            made.results.push_back(offset(value(id).rate, number));
        }
        return &made;
    }

    const TableView* table_view(const std::shared_ptr<const expr::Table>& table) {
        const auto [known, is_new] = table_numbers_.emplace(table.get(), tape_->tables.size());
        if (is_new) {
            tape_->tables.push_back(table);
            tape_->table_views.push_back(view_of(*table));
            tape_->table_views.back().number = known->second;
        }
        return &tape_->table_views[known->second];
    }

    static TableView view_of(const expr::Table& table) {
        TableView view;
        view.axis_count = table.axes.size();
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

    const Graph& graph_;
    std::span<const Expr> roots_;
    expr::Rates rates_;
    std::vector<NodeId> order_;
    std::vector<Value> values_;  ///< Indexed by NodeId.
    std::array<RegisterPool, 4> pools_;
    std::array<std::uint32_t, 4> base_{};
    std::uint32_t replicas_ = 0;
    std::unordered_map<std::uint32_t, std::vector<NodeId>> results_;  ///< By call node.
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> call_registers_;
    std::unordered_map<const expr::Table*, std::size_t> table_numbers_;
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

std::shared_ptr<Tape> compile(std::span<const Expr> roots, const Interface& interface) {
    if (roots.empty()) {
        auto tape = std::make_shared<Tape>();
        tape->interface = interface;
        return tape;
    }
    return Compiler(roots, interface).run();
}

}  // namespace balcony::program
