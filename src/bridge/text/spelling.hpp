// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How a language writes the operations of the graph: one row for each, in the order of Op. A table
// that lacks an operation does not compile.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "balcony/operations.hpp"

namespace balcony::bridge {

using expr::Op;

struct Spelling {
    enum class Form : std::uint8_t {
        none,
        structure,  ///< A leaf, a call or its result, which every language writes in its own way.
        operators,  ///< A symbol before or between the operands, with the precedence of the graph.
        call,       ///< A function.
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
[[nodiscard]] constexpr Spelling function(Op op, std::string_view name,
                                          std::string_view helper = {}) {
    return {op, Spelling::Form::call, name, helper};
}
[[nodiscard]] constexpr Spelling pattern(Op op, std::string_view text) {
    return {op, Spelling::Form::pattern, text};
}

/// Whether there is a row for every operation in its place.
[[nodiscard]] constexpr bool complete(const Spellings& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].op != static_cast<Op>(i) || rows[i].form == Spelling::Form::none) {
            return false;
        }
    }
    return true;
}

}  // namespace balcony::bridge
