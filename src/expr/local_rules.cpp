// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "expr/local_rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace balcony::expr {

namespace {

using Arguments = std::span<const Expr>;

// The constant and the other factor, if the node is such a product.
struct Scaled {
    double factor = 0.0;
    Expr rest;
};

bool is_scaled(Expr e, Scaled& scaled) {
    if (e.op() != Op::multiply) {
        return false;
    }
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        if (e.argument(i).is_constant()) {
            scaled = {e.argument(i).node().value, e.argument(1 - i)};
            return true;
        }
    }
    return false;
}

Expr fold(Graph& graph, const Operation& row, Arguments a) {
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!a[i].is_constant()) {
            return {};
        }
        values[i] = a[i].node().value;
    }
    return graph.constant(row.scalar(values.data()));
}

Expr add_rules(Graph& graph, Expr a, Expr b) {
    if (a.is_constant(0.0)) {
        return b;
    }
    if (b.is_constant(0.0)) {
        return a;
    }
    if (a.same(b)) {
        return 2.0 * a;
    }
    if (b.op() == Op::negate) {
        return a - b.argument(0);
    }
    if (a.op() == Op::negate) {
        return b - a.argument(0);
    }
    for (const auto& [constant, sum] : {std::pair(a, b), std::pair(b, a)}) {
        if (!constant.is_constant() || sum.op() != Op::add) {
            continue;
        }
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
            if (sum.argument(i).is_constant()) {
                const double total = constant.node().value + sum.argument(i).node().value;
                return sum.argument(1 - i) + graph.constant(total);
            }
        }
    }
    return {};
}

Expr subtract_rules(Graph& graph, Expr a, Expr b) {
    if (a.same(b)) {
        return graph.constant(0.0);
    }
    if (b.is_constant()) {
        return a + graph.constant(-b.node().value);
    }
    if (a.is_constant(0.0)) {
        return -b;
    }
    if (b.op() == Op::negate) {
        return a + b.argument(0);
    }
    if (a.op() == Op::negate) {
        return -(a.argument(0) + b);
    }
    return {};
}

Expr multiply_rules(Graph& graph, Expr a, Expr b) {
    for (const auto& [constant, other] : {std::pair(a, b), std::pair(b, a)}) {
        if (!constant.is_constant()) {
            continue;
        }
        const double c = constant.node().value;
        Scaled scaled;
        if (c == 0.0) {
            return graph.constant(0.0);
        }
        if (c == 1.0) {
            return other;
        }
        if (c == -1.0) {
            return -other;
        }
        if (other.op() == Op::negate) {
            return -c * other.argument(0);
        }
        // Not if the combined factors would overflow or lose precision.
        if (is_scaled(other, scaled) && std::isnormal(c * scaled.factor)) {
            return (c * scaled.factor) * scaled.rest;
        }
    }
    // A sign moves to the outside unless it is computed less often where it is.
    const Rate rate = Rates()(a.dependence() | b.dependence());
    if (a.op() == Op::negate && a.rate() == rate) {
        return -(a.argument(0) * b);
    }
    if (b.op() == Op::negate && b.rate() == rate) {
        return -(a * b.argument(0));
    }
    if (a.same(b) && a.op() == Op::absolute) {
        return a.argument(0) * a.argument(0);
    }
    // Without this rule, a signed power with exponent 1 would have the slope 0 at 0.
    for (const auto& [sign, size] : {std::pair(a, b), std::pair(b, a)}) {
        if (sign.op() == Op::sign && size.op() == Op::absolute &&
            sign.argument(0).same(size.argument(0))) {
            return size.argument(0);
        }
    }
    return {};
}

Expr divide_rules(Graph& graph, Expr a, Expr b) {
    if (a.is_constant(0.0)) {
        return a;
    }
    // Not if the reciprocal would overflow or lose precision.
    if (b.is_constant() && std::isnormal(1.0 / b.node().value)) {
        return a * graph.constant(1.0 / b.node().value);
    }
    if (a.op() == Op::negate) {
        return -(a.argument(0) / b);
    }
    if (b.op() == Op::negate) {
        return -(a / b.argument(0));
    }
    // Derivatives of nested roots contain many of these; a product is much cheaper than a quotient.
    if (a.op() == Op::divide) {
        return a.argument(0) / (a.argument(1) * b);
    }
    Scaled scaled;
    if (is_scaled(a, scaled)) {
        return scaled.factor * (scaled.rest / b);
    }
    return {};
}

// x^p for p a multiple of 1/8 by squarings and square roots. Each product rounds once and doubles
// the relative error of a square, which gives at most |p| + 3 units in the last place: 64 keeps it
// below 1.5e-14.
constexpr double max_expanded_exponent = 64.0;

bool expands(double p) {
    return std::fabs(p) <= max_expanded_exponent && p * 8.0 == std::floor(p * 8.0);
}

Expr expanded_power(Graph& graph, Expr x, double p) {
    if (p < 0.0) {
        return 1.0 / expanded_power(graph, x, -p);
    }
    const auto eighths = static_cast<unsigned>(p * 8.0);
    Expr product = graph.constant(1.0);
    Expr square = x;
    for (unsigned whole = eighths / 8; whole != 0; whole /= 2) {
        if (whole % 2 == 1) {
            product = product * square;
        }
        if (whole > 1) {
            square = square * square;
        }
    }
    Expr root = x;
    for (unsigned fraction = eighths % 8; fraction != 0; fraction = fraction * 2 % 8) {
        root = sqrt(root);
        if (fraction >= 4) {
            product = product * root;
        }
    }
    return product;
}

Expr power_rules(Graph& graph, Expr a, Expr b) {
    if (!b.is_constant() || !expands(b.node().value)) {
        return {};
    }
    const double p = b.node().value;
    const bool even = std::fmod(p, 2.0) == 0.0;
    return expanded_power(graph, even && a.op() == Op::absolute ? a.argument(0) : a, p);
}

Expr absolute_rules(Expr a) {
    switch (a.op()) {
        case Op::absolute:
        case Op::square_root:
        case Op::exponential:
        case Op::hyperbolic_cosine: return a;
        case Op::multiply: return a.argument(0).same(a.argument(1)) ? a : Expr{};
        default: return {};
    }
}

Expr square_root_rules(Expr a) {
    if (a.op() == Op::multiply && a.argument(0).same(a.argument(1))) {
        return abs(a.argument(0));
    }
    return {};
}

Expr select_rules(Expr condition, Expr a, Expr b) {
    if (condition.is_constant()) {
        return condition.node().value != 0.0 ? a : b;
    }
    if (a.same(b)) {
        return a;
    }
    if (condition.op() == Op::logical_not) {
        return select(condition.argument(0), b, a);
    }
    if (operation(condition.op()).condition && a.is_constant(1.0) && b.is_constant(0.0)) {
        return condition;
    }
    return {};
}

// A condition combined with a constant or with itself; `absorbing` is the constant that determines
// the result.
Expr logical_rules(Graph& graph, Expr a, Expr b, bool absorbing) {
    for (const auto& [constant, other] : {std::pair(a, b), std::pair(b, a)}) {
        if (constant.is_constant()) {
            const bool decides = (constant.node().value != 0.0) == absorbing;
            if (decides) {
                return graph.constant(absorbing ? 1.0 : 0.0);
            }
            return operation(other.op()).condition ? other : Expr{};
        }
    }
    return a.same(b) && operation(a.op()).condition ? a : Expr{};
}

// f(-x) for the functions that are even or odd.
Expr parity_rules(Graph& graph, const Operation& row, Expr a) {
    if (row.parity == Parity::none || a.op() != Op::negate) {
        return {};
    }
    const std::array inner{a.argument(0)};
    const Expr f = graph.apply(row.op, inner);
    return row.parity == Parity::even ? f : -f;
}

// Arithmetic with a number that is none gives none.
bool has_no_value(Op op, Arguments a) {
    const bool arithmetic = op == Op::add || op == Op::subtract || op == Op::multiply ||
                            op == Op::divide || op == Op::negate;
    return arithmetic && std::any_of(a.begin(), a.end(), [](Expr argument) {
               return argument.is_constant() && std::isnan(argument.node().value);
           });
}

}  // namespace

Expr apply_local_rules(Graph& graph, Op op, Arguments a) {
    const Operation& row = operation(op);
    if (has_no_value(op, a)) {
        return graph.constant(std::numeric_limits<double>::quiet_NaN());
    }
    if (const Expr constant = fold(graph, row, a); constant.valid()) {
        return constant;
    }
    if (const Expr reflected = parity_rules(graph, row, a[0]); reflected.valid()) {
        return reflected;
    }
    switch (op) {
        case Op::add: return add_rules(graph, a[0], a[1]);
        case Op::subtract: return subtract_rules(graph, a[0], a[1]);
        case Op::multiply: return multiply_rules(graph, a[0], a[1]);
        case Op::divide: return divide_rules(graph, a[0], a[1]);
        case Op::power: return power_rules(graph, a[0], a[1]);
        case Op::absolute: return absolute_rules(a[0]);
        case Op::square_root: return square_root_rules(a[0]);
        case Op::select: return select_rules(a[0], a[1], a[2]);
        case Op::logical_and: return logical_rules(graph, a[0], a[1], false);
        case Op::logical_or: return logical_rules(graph, a[0], a[1], true);
        case Op::minimum:
        case Op::maximum: return a[0].same(a[1]) ? a[0] : Expr{};
        case Op::negate:
            if (a[0].op() == Op::negate) {
                return a[0].argument(0);
            }
            return a[0].op() == Op::subtract ? a[0].argument(1) - a[0].argument(0) : Expr{};
        case Op::logical_not:
            if (a[0].op() == Op::logical_not && operation(a[0].argument(0).op()).condition) {
                return a[0].argument(0);
            }
            return {};
        default: return {};
    }
}

}  // namespace balcony::expr
