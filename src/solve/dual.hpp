// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Numbers with their derivatives, so that what a constraint misses is written once.

#include <array>
#include <cmath>
#include <cstddef>

namespace balcony::solve {

/// A number with its derivatives by the positions of up to four marks: x and y of each.
struct Dual {
    static constexpr std::size_t marks = 4;

    double value = 0.0;
    std::array<double, 2 * marks> by{};

    Dual() = default;
    // NOLINTNEXTLINE(google-explicit-constructor)
    Dual(double constant) : value(constant) {}
    /// The coordinate of a number, x of mark 0 being number 0 and y of mark 3 number 7.
    static Dual coordinate(double value, std::size_t number) {
        Dual made(value);
        made.by[number] = 1.0;
        return made;
    }
    /// f(this), where f has this value and this derivative.
    [[nodiscard]] Dual through(double f, double slope) const {
        Dual made(f);
        for (std::size_t i = 0; i < by.size(); ++i) {
            made.by[i] = slope * by[i];
        }
        return made;
    }
};

inline Dual combined(double value, const Dual& a, double by_a, const Dual& b, double by_b) {
    Dual made(value);
    for (std::size_t i = 0; i < made.by.size(); ++i) {
        made.by[i] = by_a * a.by[i] + by_b * b.by[i];
    }
    return made;
}

inline Dual operator+(const Dual& a, const Dual& b) {
    return combined(a.value + b.value, a, 1.0, b, 1.0);
}
inline Dual operator-(const Dual& a, const Dual& b) {
    return combined(a.value - b.value, a, 1.0, b, -1.0);
}
inline Dual operator*(const Dual& a, const Dual& b) {
    return combined(a.value * b.value, a, b.value, b, a.value);
}
inline Dual operator/(const Dual& a, const Dual& b) {
    const double quotient = a.value / b.value;
    return combined(quotient, a, 1.0 / b.value, b, -quotient / b.value);
}
inline Dual sqrt(const Dual& a) {
    const double root = std::sqrt(a.value);
    return a.through(root, 0.5 / root);
}
inline Dual max(const Dual& a, const Dual& b) { return a.value < b.value ? b : a; }

}  // namespace balcony::solve
