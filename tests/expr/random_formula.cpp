// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "random_formula.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace balcony::expr {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = std::numeric_limits<double>::epsilon();

std::size_t arity_of(Op op) {
    return op == Op::result ? 2 : static_cast<std::size_t>(operation(op).arity);
}

double native_result(std::size_t number, const double* a) {
    return number == 0 ? a[0] / (1.0 + a[1] * a[1]) : 1.0 / (1.0 + a[0] * a[0] + a[1] * a[1]);
}

class FormulaNative final : public Native {
public:
    std::string_view name() const override { return "blend"; }
    std::size_t argument_count() const override { return 2; }
    std::size_t result_count() const override { return 2; }
    void evaluate(std::size_t count, const double* const* arguments,
                  double* const* results) const override {
        for (std::size_t i = 0; i < count; ++i) {
            const std::array at{arguments[0][i], arguments[1][i]};
            results[0][i] = native_result(0, at.data());
            results[1][i] = native_result(1, at.data());
        }
    }
    Expr derivative(std::size_t result, std::size_t argument, std::span<const Expr> a,
                    std::span<const Expr> f) const override {
        if (result == 1) {
            return -2.0 * a[argument] * f[1] * f[1];
        }
        const Expr factor = 1.0 / (1.0 + a[1] * a[1]);
        return argument == 0 ? factor : -2.0 * a[1] * f[0] * factor;
    }
};

/// A function on numbers with the error that it may make.
struct Step {
    Op op;
    std::size_t result = 0;

    [[nodiscard]] double max_ulp() const {
        // Four roundings, each of a value no larger than what follows from it.
        return op == Op::result ? 4.0 : operation(op).max_ulp;
    }
    [[nodiscard]] double operator()(const double* a) const {
        return op == Op::result ? native_result(result, a) : operation(op).scalar(a);
    }
};

double input_value(std::string_view name, const Point& point) {
    if (name == "x" || name == "y") {
        return name == "x" ? point.x : point.y;
    }
    const auto given = std::find_if(point.inputs.begin(), point.inputs.end(),
                                    [name](const InputValue& input) { return input.name == name; });
    return name == "t" ? point.time : given->value;
}

Bounded apply_bounded(const Step& step, std::span<const Bounded> arguments) {
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        values[i] = arguments[i].value;
    }
    const double value = step(values.data());
    if (std::any_of(arguments.begin(), arguments.end(),
                    [](const Bounded& argument) { return !std::isfinite(argument.error); })) {
        return {value, infinity};
    }
    double error =
        (step.max_ulp() + 1.0) * rounding * std::fabs(value) + std::numeric_limits<double>::min();
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        // More than twice the bound: two arguments that move towards each other must be seen to
        // meet. No round number: a jump by 2 pi must not look like none to a sine.
        // 0 is tried by itself, since it alone counts as false.
        const double reach = 2.3 * arguments[i].error;
        const double to_zero = std::fabs(values[i]) <= reach ? -values[i] : 0.0;
        for (const double change : {-reach, reach, to_zero}) {
            std::array<double, 3> moved = values;
            moved[i] += change;
            const double difference = std::fabs(step(moved.data()) - value);
            error += std::isfinite(difference) ? difference : infinity;
        }
    }
    if (step.op == Op::equal &&
        std::fabs(values[0] - values[1]) <= 2.0 * (arguments[0].error + arguments[1].error)) {
        error += 1.0;
    }
    return {value, std::isfinite(value) ? error : infinity};
}

}  // namespace

const std::shared_ptr<const Native>& formula_native() {
    static const std::shared_ptr<const Native> native = std::make_shared<const FormulaNative>();
    return native;
}

Formula grown_formula(const Choice& below, std::size_t operations_wanted) {
    Formula formula;
    auto& steps = formula.steps;
    constexpr std::size_t two = 0;
    for (const double value : {2.0, 0.0, 1.0, -1.0, 0.5, -3.0, 0.125, 1.75, 0.1}) {
        steps.push_back({Op::constant, {}, value, {}});
    }
    for (const std::string_view name : formula_inputs) {
        steps.push_back({Op::input, {}, 0.0, name});
    }
    const auto push = [&](Op op, std::array<std::size_t, 3> arguments) {
        steps.push_back({op, arguments, 0.0, {}});
        return steps.size() - 1;
    };
    // Half of the operations are those that the simplifier rearranges.
    constexpr std::array arithmetic{Op::add, Op::subtract, Op::multiply, Op::divide, Op::negate};
    constexpr std::size_t first_operation = static_cast<std::size_t>(Op::negate);
    constexpr std::size_t operation_kinds = static_cast<std::size_t>(Op::call) - first_operation;
    while (operations_wanted-- > 0) {
        const Op op = below(12) == 0  ? Op::result
                      : below(2) == 0 ? arithmetic[below(arithmetic.size())]
                                      : static_cast<Op>(first_operation + below(operation_kinds));
        std::array<std::size_t, 3> arguments{};
        for (std::size_t i = 0; i < arity_of(op); ++i) {
            // Recent steps are the likelier ones, so that the formula grows deep.
            arguments[i] = below(3) == 0
                               ? below(steps.size())
                               : steps.size() - 1 - below(std::min<std::size_t>(6, steps.size()));
        }
        const bool function = op >= Op::square_root && op <= Op::inverse_hyperbolic_tangent;
        if (function && below(4) != 0) {
            // Into (-1, 1) or, for roots, logarithms and the like, (1, 3).
            arguments[0] = push(Op::sine, {arguments[0], 0, 0});
            if (op == Op::square_root || op == Op::power || op == Op::logarithm ||
                op == Op::inverse_hyperbolic_cosine) {
                arguments[0] = push(Op::add, {arguments[0], two, 0});
            }
        }
        steps[push(op, arguments)].value = op == Op::result ? static_cast<double>(below(2)) : 0.0;
    }
    return formula;
}

Formula random_formula(std::mt19937_64& random, std::size_t operations_wanted) {
    return grown_formula(
        [&random](std::size_t count) {
            return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
        },
        operations_wanted);
}

Expr build(Graph& graph, const Formula& formula) {
    std::vector<Expr> made;
    made.reserve(formula.steps.size());
    for (const Formula::Step& step : formula.steps) {
        std::array<Expr, 3> arguments;
        const std::size_t arity = arity_of(step.op);
        for (std::size_t i = 0; i < arity; ++i) {
            arguments[i] = made[step.arguments[i]];
        }
        switch (step.op) {
            case Op::constant: made.push_back(graph.constant(step.value)); break;
            case Op::input: made.push_back(graph.input(step.input)); break;
            case Op::result:
                made.push_back(graph.call(
                    formula_native(),
                    std::span(arguments).first(2))[static_cast<std::size_t>(step.value)]);
                break;
            default: made.push_back(graph.apply(step.op, std::span(arguments).first(arity)));
        }
    }
    return made.back();
}

Bounded evaluate_bounded(const Formula& formula, const Point& point) {
    std::vector<Bounded> values;
    values.reserve(formula.steps.size());
    for (const Formula::Step& step : formula.steps) {
        std::array<Bounded, 3> arguments;
        const std::size_t arity = arity_of(step.op);
        for (std::size_t i = 0; i < arity; ++i) {
            arguments[i] = values[step.arguments[i]];
        }
        values.push_back(step.op == Op::input ? Bounded{input_value(step.input, point), 0.0}
                         : arity == 0
                             ? Bounded{step.value, 0.0}
                             : apply_bounded({step.op, static_cast<std::size_t>(step.value)},
                                             std::span(arguments).first(arity)));
    }
    return values.back();
}

Bounded evaluate_bounded(Expr expression, const Point& point) {
    const Graph& graph = expression.graph();
    std::vector<Bounded> values(graph.size());
    for (const NodeId id : reachable(graph, std::span(&expression, 1))) {
        const Node& node = graph[id];
        if (node.op == Op::call) {
            continue;
        }
        std::array<Bounded, 3> arguments;
        std::size_t arity = 0;
        for (const NodeId argument :
             graph.arguments(node.op == Op::result ? graph.arguments(id)[0] : id)) {
            arguments[arity++] = values[argument.value()];
        }
        if (node.op == Op::input) {
            values[id.value()] = {input_value(graph.input_names()[node.detail], point), 0.0};
        } else if (arity == 0) {
            // A constant may have been folded from others.
            values[id.value()] = {node.value, rounding * std::fabs(node.value)};
        } else {
            values[id.value()] =
                apply_bounded({node.op, node.detail}, std::span(arguments).first(arity));
        }
    }
    return values[expression.id().value()];
}

std::string to_text(const Formula& formula) {
    std::ostringstream text;
    for (std::size_t i = 0; i < formula.steps.size(); ++i) {
        const Formula::Step& step = formula.steps[i];
        text << '#' << i << " = " << operation(step.op).name;
        for (std::size_t k = 0; k < arity_of(step.op); ++k) {
            text << " #" << step.arguments[k];
        }
        if (step.op == Op::constant || step.op == Op::result) {
            text << ' ' << step.value;
        }
        text << ' ' << step.input;
        text << '\n';
    }
    return text.str();
}

}  // namespace balcony::expr
