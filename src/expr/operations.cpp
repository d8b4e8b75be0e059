// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "balcony/expr.hpp"

namespace balcony::expr {

namespace {

using Arguments = std::span<const Expr>;

double truth(bool condition) { return condition ? 1.0 : 0.0; }

// The definition of each operation on numbers, its derivative by the chain rule (a: arguments,
// da: their derivatives, f: the expression itself) and what runners owe it; exactness if nothing
// else is said. IEEE 754 rounds + - * / and sqrt correctly, so these are exact to every runner (0
// ULP); glibc and SLEEF each stay within 1 ULP of the true value, so that they may differ by 2.
constexpr double two_libraries = 2.0;

Expr derivative_of_lookup(Graph& graph, const std::shared_ptr<const Table>& table, Arguments a,
                          Arguments da) {
    Expr sum = graph.constant(0.0);
    for (std::size_t axis = 0; axis < a.size(); ++axis) {
        const bool varies = table->axes[axis].degree > 0;
        if (varies && !da[axis].is_constant(0.0)) {
            sum = sum + graph.lookup(graph.derivative_table(table, axis), a) * da[axis];
        }
    }
    return sum;
}

Expr derivative_of_result(Expr f, Arguments a, Arguments da) {
    Graph& graph = f.graph();
    // A copy: what is built here may move it.
    const Call call = graph.call_of(f.argument(0).id());
    if (call.table) {
        return derivative_of_lookup(graph, call.table, a, da);
    }
    const std::vector<Expr> results = graph.call(call.native, a);
    Expr sum = graph.constant(0.0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Expr slope = da[i].is_constant(0.0)
                               ? Expr{}
                               : call.native->derivative(f.node().detail, i, a, results);
        if (slope.valid()) {
            sum = sum + slope * da[i];
        }
    }
    return sum;
}

const std::array<Operation, operation_count> operation_table{{
    {.op = Op::constant, .name = "constant", .meaning = "a number"},
    {.op = Op::input,
     .name = "input",
     .meaning = "a number from outside, such as the column of the picture or time"},
    {.op = Op::variable, .name = "variable", .meaning = "a parameter of a formula"},

    {.op = Op::negate,
     .name = "neg",
     .infix = "-",
     .precedence = Precedence::prefix,
     .arity = 1,
     .units = UnitRule::kept,
     .scalar = [](const double* a) { return -a[0]; },
     .derivative = [](Expr, Arguments, Arguments da) { return -da[0]; },
     .meaning = "-a"},
    {.op = Op::add,
     .name = "add",
     .infix = "+",
     .precedence = Precedence::sum,
     .arity = 2,
     .commutative = true,
     .units = UnitRule::common,
     .scalar = [](const double* a) { return a[0] + a[1]; },
     .derivative = [](Expr, Arguments, Arguments da) { return da[0] + da[1]; },
     .meaning = "a + b"},
    {.op = Op::subtract,
     .name = "sub",
     .infix = "-",
     .precedence = Precedence::sum,
     .arity = 2,
     .units = UnitRule::common,
     .scalar = [](const double* a) { return a[0] - a[1]; },
     .derivative = [](Expr, Arguments, Arguments da) { return da[0] - da[1]; },
     .meaning = "a - b"},
    {.op = Op::multiply,
     .name = "mul",
     .infix = "*",
     .precedence = Precedence::product,
     .arity = 2,
     .commutative = true,
     .units = UnitRule::product,
     .scalar = [](const double* a) { return a[0] * a[1]; },
     .derivative = [](Expr, Arguments a, Arguments da) { return da[0] * a[1] + a[0] * da[1]; },
     .meaning = "a b"},
    {.op = Op::divide,
     .name = "div",
     .infix = "/",
     .precedence = Precedence::product,
     .arity = 2,
     .units = UnitRule::quotient,
     .scalar = [](const double* a) { return a[0] / a[1]; },
     .derivative = [](Expr f, Arguments a, Arguments da) { return (da[0] - f * da[1]) / a[1]; },
     .meaning = "a / b"},
    {.op = Op::modulo,
     .name = "mod",
     .arity = 2,
     .units = UnitRule::common,
     .scalar = [](const double* a) { return a[0] - a[1] * std::floor(a[0] / a[1]); },
     .derivative = [](Expr, Arguments a,
                      Arguments da) { return da[0] - floor(a[0] / a[1]) * da[1]; },
     .meaning = "a - b floor(a / b), between 0 and b"},
    {.op = Op::minimum,
     .name = "min",
     .arity = 2,
     .units = UnitRule::common,
     .scalar = [](const double* a) { return a[1] < a[0] ? a[1] : a[0]; },
     .derivative = [](Expr, Arguments a,
                      Arguments da) { return select(a[1] < a[0], da[1], da[0]); },
     .meaning = "the smaller of a and b"},
    {.op = Op::maximum,
     .name = "max",
     .arity = 2,
     .units = UnitRule::common,
     .scalar = [](const double* a) { return a[0] < a[1] ? a[1] : a[0]; },
     .derivative = [](Expr, Arguments a,
                      Arguments da) { return select(a[0] < a[1], da[1], da[0]); },
     .meaning = "the larger of a and b"},
    {.op = Op::absolute,
     .name = "abs",
     .arity = 1,
     .parity = Parity::even,
     .units = UnitRule::kept,
     .scalar = [](const double* a) { return std::fabs(a[0]); },
     .derivative = [](Expr, Arguments a, Arguments da) { return sign(a[0]) * da[0]; },
     .meaning = "|a|"},
    {.op = Op::sign,
     .name = "sign",
     .arity = 1,
     .parity = Parity::odd,
     .units = UnitRule::anything_to_number,
     .scalar =
         [](const double* a) {
             return a[0] > 0.0 ? 1.0 : a[0] < 0.0 ? -1.0 : a[0] == 0.0 ? 0.0 : a[0];
         },
     .meaning = "-1, 0 or 1"},
    {.op = Op::floor,
     .name = "floor",
     .arity = 1,
     .scalar = [](const double* a) { return std::floor(a[0]); },
     .meaning = "the next integer below"},

    {.op = Op::square_root,
     .name = "sqrt",
     .arity = 1,
     .scalar = [](const double* a) { return std::sqrt(a[0]); },
     .derivative = [](Expr f, Arguments, Arguments da) { return 0.5 * da[0] / f; },
     .meaning = "square root, a >= 0"},
    {.op = Op::power,
     .name = "pow",
     .arity = 2,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::pow(a[0], a[1]); },
     .derivative =
         [](Expr f, Arguments a, Arguments da) {
             const Expr by_base = a[1] * pow(a[0], a[1] - 1.0) * da[0];
             return da[1].is_constant(0.0) ? by_base : by_base + f * log(a[0]) * da[1];
         },
     .meaning = "a to the power b; a >= 0 unless b is an integer"},
    {.op = Op::exponential,
     .name = "exp",
     .arity = 1,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::exp(a[0]); },
     .derivative = [](Expr f, Arguments, Arguments da) { return f * da[0]; },
     .meaning = "e to the power a"},
    {.op = Op::logarithm,
     .name = "log",
     .arity = 1,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::log(a[0]); },
     .derivative = [](Expr, Arguments a, Arguments da) { return da[0] / a[0]; },
     .meaning = "natural logarithm, a > 0"},

    {.op = Op::sine,
     .name = "sin",
     .arity = 1,
     .parity = Parity::odd,
     .units = UnitRule::anything_to_number,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::sin(a[0]); },
     .derivative = [](Expr, Arguments a, Arguments da) { return cos(a[0]) * da[0]; },
     .meaning = "sine"},
    {.op = Op::cosine,
     .name = "cos",
     .arity = 1,
     .parity = Parity::even,
     .units = UnitRule::anything_to_number,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::cos(a[0]); },
     .derivative = [](Expr, Arguments a, Arguments da) { return -(sin(a[0]) * da[0]); },
     .meaning = "cosine"},
    {.op = Op::tangent,
     .name = "tan",
     .arity = 1,
     .parity = Parity::odd,
     .units = UnitRule::anything_to_number,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::tan(a[0]); },
     .derivative = [](Expr f, Arguments, Arguments da) { return (1.0 + f * f) * da[0]; },
     .meaning = "tangent"},
    {.op = Op::arcsine,
     .name = "asin",
     .arity = 1,
     .parity = Parity::odd,
     .units = UnitRule::numbers_to_angle,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::asin(a[0]); },
     .derivative = [](Expr, Arguments a, Arguments da) { return da[0] / sqrt(1.0 - a[0] * a[0]); },
     .meaning = "inverse sine, |a| <= 1"},
    {.op = Op::arccosine,
     .name = "acos",
     .arity = 1,
     .units = UnitRule::numbers_to_angle,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::acos(a[0]); },
     .derivative = [](Expr, Arguments a,
                      Arguments da) { return -(da[0] / sqrt(1.0 - a[0] * a[0])); },
     .meaning = "inverse cosine, |a| <= 1"},
    {.op = Op::arctangent,
     .name = "atan",
     .arity = 1,
     .parity = Parity::odd,
     .units = UnitRule::numbers_to_angle,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::atan(a[0]); },
     .derivative = [](Expr, Arguments a, Arguments da) { return da[0] / (1.0 + a[0] * a[0]); },
     .meaning = "inverse tangent"},
    {.op = Op::arctangent2,
     .name = "atan2",
     .arity = 2,
     .units = UnitRule::common_to_angle,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::atan2(a[0], a[1]); },
     .derivative =
         [](Expr, Arguments a, Arguments da) {
             return (a[1] * da[0] - a[0] * da[1]) / (a[0] * a[0] + a[1] * a[1]);
         },
     .meaning = "the angle of the point (x = b, y = a)"},

    {.op = Op::hyperbolic_sine,
     .name = "sinh",
     .arity = 1,
     .parity = Parity::odd,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::sinh(a[0]); },
     .derivative = [](Expr, Arguments a, Arguments da) { return cosh(a[0]) * da[0]; },
     .meaning = "hyperbolic sine"},
    {.op = Op::hyperbolic_cosine,
     .name = "cosh",
     .arity = 1,
     .parity = Parity::even,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::cosh(a[0]); },
     .derivative = [](Expr, Arguments a, Arguments da) { return sinh(a[0]) * da[0]; },
     .meaning = "hyperbolic cosine"},
    {.op = Op::hyperbolic_tangent,
     .name = "tanh",
     .arity = 1,
     .parity = Parity::odd,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::tanh(a[0]); },
     .derivative = [](Expr f, Arguments, Arguments da) { return (1.0 - f * f) * da[0]; },
     .meaning = "hyperbolic tangent"},
    {.op = Op::inverse_hyperbolic_sine,
     .name = "asinh",
     .arity = 1,
     .parity = Parity::odd,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::asinh(a[0]); },
     .derivative = [](Expr, Arguments a, Arguments da) { return da[0] / sqrt(a[0] * a[0] + 1.0); },
     .meaning = "inverse hyperbolic sine"},
    {.op = Op::inverse_hyperbolic_cosine,
     .name = "acosh",
     .arity = 1,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::acosh(a[0]); },
     .derivative = [](Expr, Arguments a,
                      Arguments da) { return da[0] / (sqrt(a[0] - 1.0) * sqrt(a[0] + 1.0)); },
     .meaning = "inverse hyperbolic cosine, a >= 1"},
    {.op = Op::inverse_hyperbolic_tangent,
     .name = "atanh",
     .arity = 1,
     .parity = Parity::odd,
     .max_ulp = two_libraries,
     .scalar = [](const double* a) { return std::atanh(a[0]); },
     .derivative = [](Expr, Arguments a, Arguments da) { return da[0] / (1.0 - a[0] * a[0]); },
     .meaning = "inverse hyperbolic tangent, |a| < 1"},

    {.op = Op::less,
     .name = "less",
     .infix = "<",
     .precedence = Precedence::comparison,
     .arity = 2,
     .condition = true,
     .units = UnitRule::common_to_number,
     .scalar = [](const double* a) { return truth(a[0] < a[1]); },
     .meaning = "a < b"},
    {.op = Op::less_equal,
     .name = "less_equal",
     .infix = "<=",
     .precedence = Precedence::comparison,
     .arity = 2,
     .condition = true,
     .units = UnitRule::common_to_number,
     .scalar = [](const double* a) { return truth(a[0] <= a[1]); },
     .meaning = "a <= b"},
    {.op = Op::equal,
     .name = "equal",
     .infix = "==",
     .precedence = Precedence::comparison,
     .arity = 2,
     .commutative = true,
     .condition = true,
     .units = UnitRule::common_to_number,
     .scalar = [](const double* a) { return truth(a[0] == a[1]); },
     .meaning = "a = b"},
    {.op = Op::logical_and,
     .name = "and",
     .infix = "&&",
     .precedence = Precedence::conjunction,
     .arity = 2,
     .commutative = true,
     .condition = true,
     .scalar = [](const double* a) { return truth(a[0] != 0.0 && a[1] != 0.0); },
     .meaning = "a and b"},
    {.op = Op::logical_or,
     .name = "or",
     .infix = "||",
     .precedence = Precedence::disjunction,
     .arity = 2,
     .commutative = true,
     .condition = true,
     .scalar = [](const double* a) { return truth(a[0] != 0.0 || a[1] != 0.0); },
     .meaning = "a or b"},
    {.op = Op::logical_not,
     .name = "not",
     .infix = "!",
     .precedence = Precedence::prefix,
     .arity = 1,
     .condition = true,
     .scalar = [](const double* a) { return truth(a[0] == 0.0); },
     .meaning = "not a"},
    {.op = Op::is_finite,
     .name = "is_finite",
     .arity = 1,
     .condition = true,
     .units = UnitRule::anything_to_number,
     .scalar = [](const double* a) { return truth(std::isfinite(a[0])); },
     .meaning = "a is neither infinite nor undefined"},
    {.op = Op::select,
     .name = "select",
     .arity = 3,
     .units = UnitRule::common_after_first,
     .scalar = [](const double* a) { return a[0] != 0.0 ? a[1] : a[2]; },
     .derivative = [](Expr, Arguments a, Arguments da) { return select(a[0], da[1], da[2]); },
     .meaning = "b where a is true, otherwise c"},

    {.op = Op::call,
     .name = "call",
     .arity = Operation::variadic,
     .meaning = "a table or a function from outside, at a point"},
    {.op = Op::result,
     .name = "result",
     .arity = 1,
     .derivative = derivative_of_result,
     .meaning = "one of the results of a call"},
}};

}  // namespace

const std::array<Operation, operation_count>& operations() { return operation_table; }

const Operation& operation(Op op) {
    const Operation& row = operation_table[static_cast<std::size_t>(op)];
    assert(row.op == op && "the table lists the operations in the order of Op");
    return row;
}

}  // namespace balcony::expr
