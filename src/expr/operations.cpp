// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "balcony/expr.hpp"

namespace balcony::expr {

namespace {

using Arguments = std::span<const Expr>;

double truth(bool condition) { return condition ? 1.0 : 0.0; }

// Every operation except leaves and look-ups: its definition, its derivative by the chain
// rule (a: arguments, da: their derivatives, f: the expression itself) and its error bound for
// runners. IEEE 754 rounds + - * / and sqrt correctly, so these are exact to every runner (0 ULP);
// glibc and SLEEF each stay within 1 ULP of the true value, so that they may differ by 2.
constexpr double exact = 0.0;
constexpr double two_libraries = 2.0;

Expr derivative_of_lookup(Expr f, Arguments a, Arguments da) {
    Graph& graph = f.graph();
    const TableId id(f.node().detail);
    Expr sum = graph.constant(0.0);
    for (std::size_t axis = 0; axis < a.size(); ++axis) {
        const bool varies = graph.table(id)->axes[axis].degree > 0;
        if (varies && !da[axis].is_constant(0.0)) {
            sum = sum + graph.lookup(graph.derivative_table(id, axis), a) * da[axis];
        }
    }
    return sum;
}

Expr derivative_of_native(Expr f, Arguments a, Arguments da) {
    Graph& graph = f.graph();
    const NativeId id(f.node().detail);
    Expr sum = graph.constant(0.0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::shared_ptr<const Native> slope =
            da[i].is_constant(0.0) ? nullptr : graph.native(id)->derivative(i);
        if (slope) {
            sum = sum + graph.native(std::move(slope), a) * da[i];
        }
    }
    return sum;
}

const std::array<Operation, operation_count> table{{
    {Op::constant, "constant", "", 0, false, false, exact, nullptr, nullptr, "a number"},
    {Op::input, "input", "", 0, false, false, exact, nullptr, nullptr,
     "a number from outside, such as the column of the picture or time"},
    {Op::variable, "variable", "", 0, false, false, exact, nullptr, nullptr,
     "a parameter of a formula"},

    {Op::negate, "neg", "-", 1, false, false, exact, [](const double* a) { return -a[0]; },
     [](Expr, Arguments, Arguments da) { return -da[0]; }, "-a"},
    {Op::add, "add", "+", 2, true, false, exact, [](const double* a) { return a[0] + a[1]; },
     [](Expr, Arguments, Arguments da) { return da[0] + da[1]; }, "a + b"},
    {Op::subtract, "sub", "-", 2, false, false, exact, [](const double* a) { return a[0] - a[1]; },
     [](Expr, Arguments, Arguments da) { return da[0] - da[1]; }, "a - b"},
    {Op::multiply, "mul", "*", 2, true, false, exact, [](const double* a) { return a[0] * a[1]; },
     [](Expr, Arguments a, Arguments da) { return da[0] * a[1] + a[0] * da[1]; }, "a b"},
    {Op::divide, "div", "/", 2, false, false, exact, [](const double* a) { return a[0] / a[1]; },
     [](Expr f, Arguments a, Arguments da) { return (da[0] - f * da[1]) / a[1]; }, "a / b"},
    {Op::modulo, "mod", "", 2, false, false, exact,
     [](const double* a) { return a[0] - a[1] * std::floor(a[0] / a[1]); },
     [](Expr, Arguments a, Arguments da) { return da[0] - floor(a[0] / a[1]) * da[1]; },
     "a - b floor(a / b), between 0 and b"},
    {Op::minimum, "min", "", 2, false, false, exact,
     [](const double* a) { return a[1] < a[0] ? a[1] : a[0]; },
     [](Expr, Arguments a, Arguments da) { return select(a[1] < a[0], da[1], da[0]); },
     "the smaller of a and b"},
    {Op::maximum, "max", "", 2, false, false, exact,
     [](const double* a) { return a[0] < a[1] ? a[1] : a[0]; },
     [](Expr, Arguments a, Arguments da) { return select(a[0] < a[1], da[1], da[0]); },
     "the larger of a and b"},
    {Op::absolute, "abs", "", 1, false, false, exact,
     [](const double* a) { return std::fabs(a[0]); },
     [](Expr, Arguments a, Arguments da) { return sign(a[0]) * da[0]; }, "|a|"},
    {Op::sign, "sign", "", 1, false, false, exact,
     [](const double* a) {
         return a[0] > 0.0 ? 1.0 : a[0] < 0.0 ? -1.0 : a[0] == 0.0 ? 0.0 : a[0];
     },
     nullptr, "-1, 0 or 1"},
    {Op::floor, "floor", "", 1, false, false, exact,
     [](const double* a) { return std::floor(a[0]); }, nullptr, "the next integer below"},

    {Op::square_root, "sqrt", "", 1, false, false, exact,
     [](const double* a) { return std::sqrt(a[0]); },
     [](Expr f, Arguments, Arguments da) { return 0.5 * da[0] / f; }, "square root, a >= 0"},
    {Op::power, "pow", "", 2, false, false, two_libraries,
     [](const double* a) { return std::pow(a[0], a[1]); },
     [](Expr f, Arguments a, Arguments da) {
         const Expr by_base = a[1] * pow(a[0], a[1] - 1.0) * da[0];
         return da[1].is_constant(0.0) ? by_base : by_base + f * log(a[0]) * da[1];
     },
     "a to the power b; a >= 0 unless b is an integer"},
    {Op::exponential, "exp", "", 1, false, false, two_libraries,
     [](const double* a) { return std::exp(a[0]); },
     [](Expr f, Arguments, Arguments da) { return f * da[0]; }, "e to the power a"},
    {Op::logarithm, "log", "", 1, false, false, two_libraries,
     [](const double* a) { return std::log(a[0]); },
     [](Expr, Arguments a, Arguments da) { return da[0] / a[0]; }, "natural logarithm, a > 0"},

    {Op::sine, "sin", "", 1, false, false, two_libraries,
     [](const double* a) { return std::sin(a[0]); },
     [](Expr, Arguments a, Arguments da) { return cos(a[0]) * da[0]; }, "sine"},
    {Op::cosine, "cos", "", 1, false, false, two_libraries,
     [](const double* a) { return std::cos(a[0]); },
     [](Expr, Arguments a, Arguments da) { return -(sin(a[0]) * da[0]); }, "cosine"},
    {Op::tangent, "tan", "", 1, false, false, two_libraries,
     [](const double* a) { return std::tan(a[0]); },
     [](Expr f, Arguments, Arguments da) { return (1.0 + f * f) * da[0]; }, "tangent"},
    {Op::arcsine, "asin", "", 1, false, false, two_libraries,
     [](const double* a) { return std::asin(a[0]); },
     [](Expr, Arguments a, Arguments da) { return da[0] / sqrt(1.0 - a[0] * a[0]); },
     "inverse sine, |a| <= 1"},
    {Op::arccosine, "acos", "", 1, false, false, two_libraries,
     [](const double* a) { return std::acos(a[0]); },
     [](Expr, Arguments a, Arguments da) { return -(da[0] / sqrt(1.0 - a[0] * a[0])); },
     "inverse cosine, |a| <= 1"},
    {Op::arctangent, "atan", "", 1, false, false, two_libraries,
     [](const double* a) { return std::atan(a[0]); },
     [](Expr, Arguments a, Arguments da) { return da[0] / (1.0 + a[0] * a[0]); },
     "inverse tangent"},
    {Op::arctangent2, "atan2", "", 2, false, false, two_libraries,
     [](const double* a) { return std::atan2(a[0], a[1]); },
     [](Expr, Arguments a, Arguments da) {
         return (a[1] * da[0] - a[0] * da[1]) / (a[0] * a[0] + a[1] * a[1]);
     },
     "the angle of the point (x = b, y = a)"},

    {Op::hyperbolic_sine, "sinh", "", 1, false, false, two_libraries,
     [](const double* a) { return std::sinh(a[0]); },
     [](Expr, Arguments a, Arguments da) { return cosh(a[0]) * da[0]; }, "hyperbolic sine"},
    {Op::hyperbolic_cosine, "cosh", "", 1, false, false, two_libraries,
     [](const double* a) { return std::cosh(a[0]); },
     [](Expr, Arguments a, Arguments da) { return sinh(a[0]) * da[0]; }, "hyperbolic cosine"},
    {Op::hyperbolic_tangent, "tanh", "", 1, false, false, two_libraries,
     [](const double* a) { return std::tanh(a[0]); },
     [](Expr f, Arguments, Arguments da) { return (1.0 - f * f) * da[0]; }, "hyperbolic tangent"},
    {Op::inverse_hyperbolic_sine, "asinh", "", 1, false, false, two_libraries,
     [](const double* a) { return std::asinh(a[0]); },
     [](Expr, Arguments a, Arguments da) { return da[0] / sqrt(a[0] * a[0] + 1.0); },
     "inverse hyperbolic sine"},
    {Op::inverse_hyperbolic_cosine, "acosh", "", 1, false, false, two_libraries,
     [](const double* a) { return std::acosh(a[0]); },
     [](Expr, Arguments a, Arguments da) { return da[0] / (sqrt(a[0] - 1.0) * sqrt(a[0] + 1.0)); },
     "inverse hyperbolic cosine, a >= 1"},
    {Op::inverse_hyperbolic_tangent, "atanh", "", 1, false, false, two_libraries,
     [](const double* a) { return std::atanh(a[0]); },
     [](Expr, Arguments a, Arguments da) { return da[0] / (1.0 - a[0] * a[0]); },
     "inverse hyperbolic tangent, |a| < 1"},

    {Op::less, "less", "<", 2, false, true, exact,
     [](const double* a) { return truth(a[0] < a[1]); }, nullptr, "a < b"},
    {Op::less_equal, "less_equal", "<=", 2, false, true, exact,
     [](const double* a) { return truth(a[0] <= a[1]); }, nullptr, "a <= b"},
    {Op::equal, "equal", "==", 2, true, true, exact,
     [](const double* a) { return truth(a[0] == a[1]); }, nullptr, "a = b"},
    {Op::logical_and, "and", "&&", 2, true, true, exact,
     [](const double* a) { return truth(a[0] != 0.0 && a[1] != 0.0); }, nullptr, "a and b"},
    {Op::logical_or, "or", "||", 2, true, true, exact,
     [](const double* a) { return truth(a[0] != 0.0 || a[1] != 0.0); }, nullptr, "a or b"},
    {Op::logical_not, "not", "!", 1, false, true, exact,
     [](const double* a) { return truth(a[0] == 0.0); }, nullptr, "not a"},
    {Op::is_finite, "is_finite", "", 1, false, true, exact,
     [](const double* a) { return truth(std::isfinite(a[0])); }, nullptr,
     "a is neither infinite nor undefined"},
    {Op::select, "select", "", 3, false, false, exact,
     [](const double* a) { return a[0] != 0.0 ? a[1] : a[2]; },
     [](Expr, Arguments a, Arguments da) { return select(a[0], da[1], da[2]); },
     "b where a is true, otherwise c"},

    {Op::lookup, "lookup", "", 1, false, false, exact, nullptr, derivative_of_lookup,
     "value of a tabulated function"},
    {Op::lookup_2, "lookup_of_2", "", 2, false, false, exact, nullptr, derivative_of_lookup,
     "value of a tabulated function of two variables"},
    {Op::lookup_3, "lookup_of_3", "", 3, false, false, exact, nullptr, derivative_of_lookup,
     "value of a tabulated function of three variables"},
    {Op::native, "native", "", 1, false, false, exact, nullptr, derivative_of_native,
     "value of a native function"},
    {Op::native_2, "native_of_2", "", 2, false, false, exact, nullptr, derivative_of_native,
     "value of a native function of two variables"},
    {Op::native_3, "native_of_3", "", 3, false, false, exact, nullptr, derivative_of_native,
     "value of a native function of three variables"},
}};

}  // namespace

const std::array<Operation, operation_count>& operations() { return table; }

const Operation& operation(Op op) {
    const Operation& row = table[static_cast<std::size_t>(op)];
    assert(row.op == op && "the table lists the operations in the order of Op");
    return row;
}

}  // namespace balcony::expr
