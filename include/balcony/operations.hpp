// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The table of operations: all that graphs, runners, the language and tests know about each of
// them stands in its row.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

namespace balcony::expr {

class Expr;

/// All kinds of nodes. The table in operations() has the facts about each.
enum class Op : std::uint8_t {
    // leaves
    constant,
    input,
    variable,
    // arithmetic
    negate,
    add,
    subtract,
    multiply,
    divide,
    modulo,
    minimum,
    maximum,
    absolute,
    sign,
    floor,
    // powers
    square_root,
    power,
    exponential,
    logarithm,
    // circular functions
    sine,
    cosine,
    tangent,
    arcsine,
    arccosine,
    arctangent,
    arctangent2,
    // hyperbolic functions
    hyperbolic_sine,
    hyperbolic_cosine,
    hyperbolic_tangent,
    inverse_hyperbolic_sine,
    inverse_hyperbolic_cosine,
    inverse_hyperbolic_tangent,
    // conditions
    less,
    less_equal,
    equal,
    logical_and,
    logical_or,
    logical_not,
    is_finite,
    select,
    // functions that are no formulas
    call,    ///< Has no value itself.
    result,  ///< One result of a call, which is its argument.
};

inline constexpr std::size_t operation_count = static_cast<std::size_t>(Op::result) + 1;

/// How tightly what is written binds, loosest first.
enum class Precedence : std::uint8_t {
    disjunction,
    conjunction,
    comparison,
    sum,
    product,
    prefix,
    atom
};

/// Whether f(-x) is f(x) or -f(x) for an operation on one argument.
enum class Parity : std::uint8_t { none, even, odd };

/// Which units the arguments of an operation may have, plain number or angle, and which one the
/// result has.
enum class UnitRule : std::uint8_t {
    numbers,             ///< Plain numbers give a plain number.
    numbers_to_angle,    ///< Plain numbers give an angle.
    anything_to_number,  ///< Any units give a plain number.
    kept,                ///< The result has the unit of its one argument.
    common,              ///< All have one unit, the result too.
    common_to_number,    ///< All have one unit, the result is a plain number.
    common_to_angle,     ///< All have one unit, the result is an angle.
    common_after_first,  ///< The first is a plain number, the others have one unit, the result too.
    product,             ///< An angle if either is one; not both.
    quotient,            ///< Of two angles, a plain number; an angle by a number stays one.
};

/// Where the values of an expression lie: from `least` to `most`, those that are not NaN.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool may_be_nan = true;
};

/// All facts about one operation, which are defined only here.
struct Operation {
    static constexpr int variadic = -1;

    Op op = Op::constant;
    std::string_view name{};   ///< The name in the language and in printed formulas.
    std::string_view infix{};  ///< The infix symbol; empty if it is written as a call.
    Precedence precedence = Precedence::atom;  ///< Of what is written with the infix spelling.
    int arity = 0;                             ///< The number of arguments, or variadic.
    bool commutative = false;
    bool condition = false;  ///< Its value is 1 or 0.
    Parity parity = Parity::none;
    UnitRule units = UnitRule::numbers;
    /// The maximum error of a runner in units in the last place, if the result is a normal number.
    double max_ulp = 0.0;
    /// Defines the operation; null for leaves, calls and their results.
    double (*scalar)(const double* arguments) = nullptr;
    /// The derivative of self, given its arguments (of a result, those of the call) and theirs;
    /// null where it is 0 throughout.
    Expr (*derivative)(Expr self, std::span<const Expr> arguments,
                       std::span<const Expr> slopes) = nullptr;
    /// Where the values of every runner lie if the arguments lie there; null where nothing is
    /// known. Conditions and select() alone are asked about arguments that may be NaN.
    Range (*range)(const Range* arguments) = nullptr;
    /// Which argument the value always is then, to the last bit; none if that is open. Null for
    /// operations that never choose.
    std::optional<std::size_t> (*chosen)(const Range* arguments) = nullptr;
    std::string_view meaning{};  ///< One line for documentation.
};

[[nodiscard]] const std::array<Operation, operation_count>& operations();
[[nodiscard]] const Operation& operation(Op op);

/// Where the values of an operation lie if its arguments lie there. They may be NaN.
[[nodiscard]] Range range_of(Op op, const Range* arguments);
/// Where the square of a value lies, which is more than what its product by itself tells.
[[nodiscard]] Range range_of_square(const Range& argument);
/// Which argument the value of an operation always is, to the last bit; none if that is open.
[[nodiscard]] std::optional<std::size_t> chosen_argument(Op op, const Range* arguments);

}  // namespace balcony::expr
