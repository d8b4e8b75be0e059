// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The distortion of a lens, which maps a plane to a plane: its published formula, for numbers and
// for formulas, with derivatives.

#include <array>
#include <vector>

#include "balcony/expr.hpp"

namespace balcony::camera {

/// Parts of what is needed: how exact an inverse is, and what is no inverse at all. The second also
/// holds where a program computes in single precision, whose roundings are some 1e-7.
inline constexpr double inverse_accuracy = 1e-13;
inline constexpr double inverse_doubt = 1e-5;

/// A value with its partial derivatives by two variables a and b (forward differentiation).
template <class Number>
struct Dual {
    Number value, by_a, by_b;
};

template <class Number>
Dual<Number> operator+(const Dual<Number>& p, const Dual<Number>& q) {
    return {p.value + q.value, p.by_a + q.by_a, p.by_b + q.by_b};
}
template <class Number>
Dual<Number> operator+(const Dual<Number>& p, double number) {
    return {p.value + number, p.by_a, p.by_b};
}
template <class Number>
Dual<Number> operator*(double factor, const Dual<Number>& p) {
    return {factor * p.value, factor * p.by_a, factor * p.by_b};
}
template <class Number>
Dual<Number> operator*(const Dual<Number>& p, const Dual<Number>& q) {
    return {p.value * q.value, p.by_a * q.value + p.value * q.by_a,
            p.by_b * q.value + p.value * q.by_b};
}
template <class Number>
Dual<Number> operator/(const Dual<Number>& p, const Dual<Number>& q) {
    const Number quotient = p.value / q.value;
    return {quotient, (p.by_a - quotient * q.by_a) / q.value,
            (p.by_b - quotient * q.by_b) / q.value};
}

/// A point of a plane.
template <class Number>
struct PlanePoint {
    Number a, b;
};

/// OpenCV's documentation of calib3d and COLMAP's of its camera models: with q = a² + b², radial
/// factor N(q)/D(q), tangential p1 and p2, thin prism s1 .. s4.
struct Distortion {
    std::vector<double> numerator{1.0};    ///< Of powers of q from 0.
    std::vector<double> denominator{1.0};  ///< The same; the first is 1.
    std::array<double, 2> tangential{};
    std::array<double, 4> prism{};

    [[nodiscard]] bool is_radial() const {
        return tangential == std::array<double, 2>{} && prism == std::array<double, 4>{};
    }
};

template <class Number>
Number polynomial(const std::vector<double>& coefficients, const Number& q) {
    Number sum = 0.0 * q + coefficients.back();
    for (std::size_t i = coefficients.size() - 1; i-- > 0;) {
        sum = sum * q + coefficients[i];
    }
    return sum;
}

template <class Number>
Number radial_factor(const Distortion& d, const Number& q) {
    const Number numerator = polynomial(d.numerator, q);
    return d.denominator.size() > 1 ? numerator / polynomial(d.denominator, q) : numerator;
}

/// Of a distortion that is not radial: what it adds to the radial part.
template <class Number>
PlanePoint<Number> sideways_part(const Distortion& d, const PlanePoint<Number>& p) {
    const auto& [p1, p2] = d.tangential;
    const auto& [s1, s2, s3, s4] = d.prism;
    const Number q = p.a * p.a + p.b * p.b;
    const Number ab = p.a * p.b;
    return {(2.0 * p1) * ab + p2 * (q + 2.0 * (p.a * p.a)) + q * (s2 * q + s1),
            p1 * (q + 2.0 * (p.b * p.b)) + (2.0 * p2) * ab + q * (s4 * q + s3)};
}

template <class Number>
PlanePoint<Number> distorted(const Distortion& d, const PlanePoint<Number>& p) {
    const Number radial = radial_factor(d, p.a * p.a + p.b * p.b);
    if (d.is_radial()) {
        return {p.a * radial, p.b * radial};
    }
    const PlanePoint<Number> sideways = sideways_part(d, p);
    return {p.a * radial + sideways.a, p.b * radial + sideways.b};
}

/// With the partial derivatives by a and b.
template <class Number>
PlanePoint<Dual<Number>> distorted_with_derivatives(const Distortion& d,
                                                    const PlanePoint<Number>& p) {
    const Number zero = 0.0 * p.a;
    const Number one = zero + 1.0;
    return distorted(d, PlanePoint<Dual<Number>>{{p.a, one, zero}, {p.b, zero, one}});
}

}  // namespace balcony::camera
