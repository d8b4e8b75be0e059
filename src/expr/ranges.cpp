// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "expr/ranges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "balcony/expr.hpp"

namespace balcony::expr::ranges {

namespace {

using Limits = std::numeric_limits<double>;

constexpr Range unknown{};
constexpr Range condition{0.0, 1.0, false};
constexpr Range always{1.0, 1.0, false};
constexpr Range never{0.0, 0.0, false};

bool is_bounded(const Range& a) { return std::isfinite(a.least) && std::isfinite(a.most); }

// A sum, difference, product or quotient of finite numbers, not by 0, is never NaN; of infinite
// ones it may be.
Range of_bounded(const Range* a, double least, double most) {
    return is_bounded(a[0]) && is_bounded(a[1]) ? Range{least, most, false} : unknown;
}

template <class Function>
Range of_corners(const Range* a, const Function& function) {
    const std::array values{function(a[0].least, a[1].least), function(a[0].least, a[1].most),
                            function(a[0].most, a[1].least), function(a[0].most, a[1].most)};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return {*least, *most, false};
}

// What the runners' functions may be beside glibc's: each is within 1 ULP of the true value, and an
// ULP below a power of two is half of one above. Where results are not normal numbers, they may be
// anything as small.
double margin(double value) { return 4.0 * Limits::epsilon() * std::fabs(value) + Limits::min(); }

Range widened(double least, double most) {
    const double below =
        std::isfinite(least) ? least - margin(least) : std::min(least, Limits::max() / 2.0);
    const double above =
        std::isfinite(most) ? most + margin(most) : std::max(most, -Limits::max() / 2.0);
    return {below, above, false};
}

template <double (*function)(double)>
Range increasing(const Range& a) {
    return widened(function(a.least), function(a.most));
}

// Of sin(x + phase), whose values at the ends are given.
Range wave(const Range& a, double phase, double at_least, double at_most) {
    constexpr double turn = 2.0 * std::numbers::pi;
    // Beyond, rounding of the quotients below might hide a crest.
    constexpr double far = 1e6;
    constexpr double tolerance = 1e-9;
    if (!(a.least > -far && a.most < far)) {
        return is_bounded(a) ? widened(-1.0, 1.0) : unknown;
    }
    const auto reaches = [&](double extremum) {
        const double first = std::ceil((a.least - extremum) / turn - tolerance);
        return first <= (a.most - extremum) / turn + tolerance;
    };
    const double crest = std::numbers::pi / 2.0 - phase;
    return widened(reaches(crest + std::numbers::pi) ? -1.0 : std::min(at_least, at_most),
                   reaches(crest) ? 1.0 : std::max(at_least, at_most));
}

bool is_true(const Range& a) { return !a.may_be_nan && (a.least > 0.0 || a.most < 0.0); }
bool is_false(const Range& a) { return !a.may_be_nan && a.least == 0.0 && a.most == 0.0; }

bool are_numbers(const Range* a) { return !a[0].may_be_nan && !a[1].may_be_nan; }

std::optional<std::size_t> first_if(bool first, bool second) {
    if (first) {
        return 0;
    }
    return second ? std::optional<std::size_t>(1) : std::nullopt;
}

}  // namespace

Range negated(const Range* a) { return {-a[0].most, -a[0].least, false}; }

Range sum(const Range* a) { return of_bounded(a, a[0].least + a[1].least, a[0].most + a[1].most); }

Range difference(const Range* a) {
    return of_bounded(a, a[0].least - a[1].most, a[0].most - a[1].least);
}

Range product(const Range* a) {
    const Range corners = of_corners(a, [](double x, double y) { return x * y; });
    return of_bounded(a, corners.least, corners.most);
}

Range quotient(const Range* a) {
    if (a[1].least <= 0.0 && a[1].most >= 0.0) {
        return unknown;
    }
    const Range corners = of_corners(a, [](double x, double y) { return x / y; });
    return of_bounded(a, corners.least, corners.most);
}

// The quotient q = (a/b)(1 + e) has a floor k <= q, so that b k <= a (1 + e): the remainder is not
// below 0 by more than the roundings of a. It does not exceed b by more, for k > q - 1.
Range remainder(const Range* a) {
    if (chosen_remainder(a) == 0) {
        return a[0];
    }
    const double largest = std::max(std::fabs(a[0].least), std::fabs(a[0].most));
    const bool overflows = !(largest < Limits::max() / 2.0 && std::isfinite(largest / a[1].least));
    if (!(a[1].least > 0.0) || overflows) {
        return unknown;
    }
    const double roundings = margin(largest);
    return of_bounded(a, -roundings, a[1].most + margin(a[1].most) + roundings);
}

Range smaller(const Range* a) {
    return {std::min(a[0].least, a[1].least), std::min(a[0].most, a[1].most), false};
}

Range larger(const Range* a) {
    return {std::max(a[0].least, a[1].least), std::max(a[0].most, a[1].most), false};
}

Range absolute(const Range* a) {
    const double low = std::fabs(a[0].least);
    const double high = std::fabs(a[0].most);
    const bool has_zero = a[0].least <= 0.0 && a[0].most >= 0.0;
    return {has_zero ? 0.0 : std::min(low, high), std::max(low, high), false};
}

Range sign(const Range* a) {
    const auto of = [](double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; };
    return {of(a[0].least), of(a[0].most), false};
}

Range floor(const Range* a) { return {std::floor(a[0].least), std::floor(a[0].most), false}; }

Range square_root(const Range* a) {
    return a[0].least >= 0.0 ? Range{std::sqrt(a[0].least), std::sqrt(a[0].most), false} : unknown;
}

Range power(const Range* a) {
    if (!(a[0].least > 0.0) || !is_bounded(a[0]) || !is_bounded(a[1])) {
        return unknown;
    }
    const Range corners = of_corners(a, [](double x, double y) { return std::pow(x, y); });
    return widened(corners.least, corners.most);
}

Range exponential(const Range* a) { return increasing<std::exp>(a[0]); }

Range logarithm(const Range* a) { return a[0].least >= 0.0 ? increasing<std::log>(a[0]) : unknown; }

Range sine(const Range* a) { return wave(a[0], 0.0, std::sin(a[0].least), std::sin(a[0].most)); }

Range cosine(const Range* a) {
    return wave(a[0], std::numbers::pi / 2.0, std::cos(a[0].least), std::cos(a[0].most));
}

Range arcsine(const Range* a) {
    return a[0].least >= -1.0 && a[0].most <= 1.0 ? increasing<std::asin>(a[0]) : unknown;
}

Range arccosine(const Range* a) {
    return a[0].least >= -1.0 && a[0].most <= 1.0
               ? widened(std::acos(a[0].most), std::acos(a[0].least))
               : unknown;
}

Range arctangent(const Range* a) { return increasing<std::atan>(a[0]); }

// Seen from the origin, the corners of a box bound it, unless it has the origin or the angle jumps
// in it.
Range arctangent2(const Range* a) {
    const bool is_one_piece = a[1].least > 0.0 || a[0].least > 0.0 || a[0].most < 0.0;
    if (!is_one_piece || !is_bounded(a[0]) || !is_bounded(a[1])) {
        return widened(-std::numbers::pi, std::numbers::pi);
    }
    const Range corners = of_corners(a, [](double y, double x) { return std::atan2(y, x); });
    return widened(corners.least, corners.most);
}

Range hyperbolic_sine(const Range* a) { return increasing<std::sinh>(a[0]); }
Range hyperbolic_tangent(const Range* a) { return increasing<std::tanh>(a[0]); }
Range inverse_hyperbolic_sine(const Range* a) { return increasing<std::asinh>(a[0]); }

Range less(const Range* a) {
    if (!are_numbers(a)) {
        return condition;
    }
    return a[0].most < a[1].least ? always : a[0].least >= a[1].most ? never : condition;
}

Range less_equal(const Range* a) {
    if (!are_numbers(a)) {
        return condition;
    }
    return a[0].most <= a[1].least ? always : a[0].least > a[1].most ? never : condition;
}

Range equal(const Range* a) {
    if (!are_numbers(a)) {
        return condition;
    }
    if (a[0].most < a[1].least || a[0].least > a[1].most) {
        return never;
    }
    const bool is_one_number = a[0].least == a[1].most && a[0].most == a[1].least;
    return is_one_number ? always : condition;
}

Range logical_and(const Range* a) {
    if (is_false(a[0]) || is_false(a[1])) {
        return never;
    }
    return is_true(a[0]) && is_true(a[1]) ? always : condition;
}

Range logical_or(const Range* a) {
    if (is_true(a[0]) || is_true(a[1])) {
        return always;
    }
    return is_false(a[0]) && is_false(a[1]) ? never : condition;
}

Range logical_not(const Range* a) {
    return is_true(a[0]) ? never : is_false(a[0]) ? always : condition;
}

Range is_finite(const Range* a) {
    return !a[0].may_be_nan && is_bounded(a[0]) ? always : condition;
}

Range selected(const Range* a) {
    if (const auto branch = chosen_branch(a)) {
        return a[*branch];
    }
    return {std::min(a[1].least, a[2].least), std::max(a[1].most, a[2].most),
            a[1].may_be_nan || a[2].may_be_nan};
}

// a - b floor(a/b) is a, to the last bit, where the floor is 0 and a is not -0.
std::optional<std::size_t> chosen_remainder(const Range* a) {
    const bool has_one = a[0].least > 0.0 && a[1].least > 0.0 && std::isfinite(a[1].most) &&
                         a[0].most / a[1].least < 1.0;
    return has_one ? std::optional<std::size_t>(0) : std::nullopt;
}

std::optional<std::size_t> chosen_smaller(const Range* a) {
    return first_if(a[0].most < a[1].least, a[1].most < a[0].least);
}

std::optional<std::size_t> chosen_larger(const Range* a) {
    return first_if(a[0].least > a[1].most, a[1].least > a[0].most);
}

std::optional<std::size_t> chosen_branch(const Range* a) {
    if (is_true(a[0])) {
        return 1;
    }
    return is_false(a[0]) ? std::optional<std::size_t>(2) : std::nullopt;
}

}  // namespace balcony::expr::ranges

namespace balcony::expr {

namespace {

bool may_be_asked(const Operation& row, const Range* arguments) {
    const auto is_number = [](const Range& argument) { return !argument.may_be_nan; };
    return row.condition || row.op == Op::select ||
           std::all_of(arguments, arguments + row.arity, is_number);
}

}  // namespace

Range range_of(Op op, const Range* arguments) {
    const Operation& row = operation(op);
    return row.range != nullptr && may_be_asked(row, arguments) ? row.range(arguments) : Range{};
}

Range range_of_square(const Range& argument) {
    const Range size = range_of(Op::absolute, &argument);
    return size.may_be_nan || std::isinf(size.most)
               ? Range{}
               : Range{size.least * size.least, size.most * size.most, false};
}

std::optional<std::size_t> chosen_argument(Op op, const Range* arguments) {
    const Operation& row = operation(op);
    return row.chosen != nullptr && may_be_asked(row, arguments) ? row.chosen(arguments)
                                                                 : std::nullopt;
}

}  // namespace balcony::expr
