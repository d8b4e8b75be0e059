// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How a language writes the operations of the graph: as most languages do, but for rows of its own.
// A language without a row for an operation does not compile.

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "balcony/operations.hpp"

namespace balcony::bridge {

using expr::Op;

struct Spelling {
    enum class Form : std::uint8_t {
        none,
        structure,  ///< A leaf, a call or its result, which every language writes in its own way.
        operators,  ///< A symbol before or between the operands, with the precedence of the graph.
        standard,   ///< A function of the language's library, whose names may have a common part.
        call,       ///< Another function.
        pattern,    ///< A text with {0}, {1}, ... in the place of the operands.
    };

    Op op = Op::constant;
    Form form = Form::none;
    std::string_view text{};
    /// A definition that the text needs, which is written once.
    std::string_view helper{};
};

using Spellings = std::array<Spelling, expr::operation_count>;

[[nodiscard]] constexpr Spelling structure(Op op) { return {op, Spelling::Form::structure}; }
[[nodiscard]] constexpr Spelling symbol(Op op, std::string_view text) {
    return {op, Spelling::Form::operators, text};
}
[[nodiscard]] constexpr Spelling standard(Op op, std::string_view name) {
    return {op, Spelling::Form::standard, name};
}
[[nodiscard]] constexpr Spelling function(Op op, std::string_view name,
                                          std::string_view helper = {}) {
    return {op, Spelling::Form::call, name, helper};
}
[[nodiscard]] constexpr Spelling pattern(Op op, std::string_view text) {
    return {op, Spelling::Form::pattern, text};
}

/// The rows that most languages share. Those of operations that each language writes in its own way
/// are missing.
inline constexpr auto common_spellings = [] {
    Spellings rows;
    for (const Spelling& row : std::initializer_list<Spelling>{
             structure(Op::constant),
             structure(Op::input),
             structure(Op::variable),
             symbol(Op::negate, "-"),
             symbol(Op::add, "+"),
             symbol(Op::subtract, "-"),
             symbol(Op::multiply, "*"),
             symbol(Op::divide, "/"),
             standard(Op::minimum, "min"),
             standard(Op::maximum, "max"),
             standard(Op::absolute, "abs"),
             standard(Op::sign, "sign"),
             standard(Op::floor, "floor"),
             standard(Op::square_root, "sqrt"),
             standard(Op::power, "pow"),
             standard(Op::exponential, "exp"),
             standard(Op::logarithm, "log"),
             standard(Op::sine, "sin"),
             standard(Op::cosine, "cos"),
             standard(Op::tangent, "tan"),
             standard(Op::arcsine, "asin"),
             standard(Op::arccosine, "acos"),
             standard(Op::arctangent, "atan"),
             standard(Op::arctangent2, "atan2"),
             standard(Op::hyperbolic_sine, "sinh"),
             standard(Op::hyperbolic_cosine, "cosh"),
             standard(Op::hyperbolic_tangent, "tanh"),
             standard(Op::inverse_hyperbolic_sine, "asinh"),
             standard(Op::inverse_hyperbolic_cosine, "acosh"),
             standard(Op::inverse_hyperbolic_tangent, "atanh"),
             symbol(Op::less, "<"),
             symbol(Op::less_equal, "<="),
             symbol(Op::equal, "=="),
             symbol(Op::logical_and, "&&"),
             symbol(Op::logical_or, "||"),
             symbol(Op::logical_not, "!"),
             pattern(Op::select, "({0} ? {1} : {2})"),
             structure(Op::call),
             structure(Op::result),
         }) {
        rows[static_cast<std::size_t>(row.op)] = row;
    }
    return rows;
}();

/// The spellings of a language that writes these rows in its own way and the others as most do, or
/// as its relatives do.
[[nodiscard]] consteval Spellings spellings(std::initializer_list<Spelling> own,
                                            Spellings rows = common_spellings) {
    for (const Spelling& row : own) {
        rows[static_cast<std::size_t>(row.op)] = row;
    }
    for (const Spelling& row : rows) {
        if (row.form == Spelling::Form::none) {
            throw "an operation has no spelling";
        }
    }
    return rows;
}

}  // namespace balcony::bridge
