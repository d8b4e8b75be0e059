// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/expr.hpp"

namespace balcony::expr {

namespace {

Expr unary(Op op, Expr a) {
    const std::array arguments{a};
    return a.graph().apply(op, arguments);
}

Expr binary(Op op, Expr a, Expr b) {
    const std::array arguments{a, b};
    return a.graph().apply(op, arguments);
}

Expr like(Expr a, double value) { return a.graph().constant(value); }

}  // namespace

Expr operator-(Expr a) { return unary(Op::negate, a); }
Expr operator+(Expr a, Expr b) { return binary(Op::add, a, b); }
Expr operator+(Expr a, double b) { return a + like(a, b); }
Expr operator+(double a, Expr b) { return like(b, a) + b; }
Expr operator-(Expr a, Expr b) { return binary(Op::subtract, a, b); }
Expr operator-(Expr a, double b) { return a - like(a, b); }
Expr operator-(double a, Expr b) { return like(b, a) - b; }
Expr operator*(Expr a, Expr b) { return binary(Op::multiply, a, b); }
Expr operator*(Expr a, double b) { return a * like(a, b); }
Expr operator*(double a, Expr b) { return like(b, a) * b; }
Expr operator/(Expr a, Expr b) { return binary(Op::divide, a, b); }
Expr operator/(Expr a, double b) { return a / like(a, b); }
Expr operator/(double a, Expr b) { return like(b, a) / b; }

Expr operator<(Expr a, Expr b) { return binary(Op::less, a, b); }
Expr operator<(Expr a, double b) { return a < like(a, b); }
Expr operator<(double a, Expr b) { return like(b, a) < b; }
Expr operator<=(Expr a, Expr b) { return binary(Op::less_equal, a, b); }
Expr operator<=(Expr a, double b) { return a <= like(a, b); }
Expr operator<=(double a, Expr b) { return like(b, a) <= b; }
Expr equal(Expr a, Expr b) { return binary(Op::equal, a, b); }
Expr operator&&(Expr a, Expr b) { return binary(Op::logical_and, a, b); }
Expr operator||(Expr a, Expr b) { return binary(Op::logical_or, a, b); }
Expr operator!(Expr a) { return unary(Op::logical_not, a); }
Expr is_finite(Expr a) { return unary(Op::is_finite, a); }
Expr select(Expr condition, Expr if_true, Expr if_false) {
    const std::array arguments{condition, if_true, if_false};
    return condition.graph().apply(Op::select, arguments);
}

Expr mod(Expr a, Expr b) { return binary(Op::modulo, a, b); }
Expr min(Expr a, Expr b) { return binary(Op::minimum, a, b); }
Expr max(Expr a, Expr b) { return binary(Op::maximum, a, b); }
Expr abs(Expr a) { return unary(Op::absolute, a); }
Expr sign(Expr a) { return unary(Op::sign, a); }
Expr floor(Expr a) { return unary(Op::floor, a); }
Expr sqrt(Expr a) { return unary(Op::square_root, a); }
Expr pow(Expr a, Expr b) { return binary(Op::power, a, b); }
Expr pow(Expr a, double b) { return pow(a, like(a, b)); }
Expr exp(Expr a) { return unary(Op::exponential, a); }
Expr log(Expr a) { return unary(Op::logarithm, a); }
Expr sin(Expr a) { return unary(Op::sine, a); }
Expr cos(Expr a) { return unary(Op::cosine, a); }
Expr tan(Expr a) { return unary(Op::tangent, a); }
Expr asin(Expr a) { return unary(Op::arcsine, a); }
Expr acos(Expr a) { return unary(Op::arccosine, a); }
Expr atan(Expr a) { return unary(Op::arctangent, a); }
Expr atan2(Expr y, Expr x) { return binary(Op::arctangent2, y, x); }
Expr sinh(Expr a) { return unary(Op::hyperbolic_sine, a); }
Expr cosh(Expr a) { return unary(Op::hyperbolic_cosine, a); }
Expr tanh(Expr a) { return unary(Op::hyperbolic_tangent, a); }
Expr asinh(Expr a) { return unary(Op::inverse_hyperbolic_sine, a); }
Expr acosh(Expr a) { return unary(Op::inverse_hyperbolic_cosine, a); }
Expr atanh(Expr a) { return unary(Op::inverse_hyperbolic_tangent, a); }

Expr signed_power(Expr x, Expr p) { return sign(x) * pow(abs(x), p); }

}  // namespace balcony::expr
