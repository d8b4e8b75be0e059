// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/expr.hpp"
#include "balcony/make_stage.hpp"

namespace balcony::lang {

using camera::Unit;

struct Element;

/// The value of an expression: a number, which is a node of the session's graph with its unit,
/// or a tuple or a list of values. A failed value comes from an error that has been reported;
/// uses of it fail without further diagnostics.
struct Value {
    enum class Form : std::uint8_t { number, tuple, list };

    expr::Expr expr;
    Unit unit = Unit::number;
    /// An error of the number itself (such as a division by 0). It is reported only if the value is
    /// used, so that if(c, a, b) may contain values that its condition excludes.
    std::shared_ptr<const Diagnostic> problem{};
    Form form = Form::number;
    /// The numbers of a tuple, or the numbers and tuples of a list; none of these has failed.
    std::shared_ptr<const std::vector<Element>> elements{};

    [[nodiscard]] bool failed() const { return !expr.valid() && !elements; }
    [[nodiscard]] bool is_constant() const { return expr.valid() && expr.is_constant(); }
    [[nodiscard]] double constant() const { return expr.node().value; }
    /// 0 has every unit.
    [[nodiscard]] bool is_zero() const { return is_constant() && constant() == 0.0; }
    [[nodiscard]] bool is_angle() const { return unit == Unit::angle && !is_zero(); }
    [[nodiscard]] bool is_plain_number() const { return unit == Unit::number && !is_zero(); }
};

/// An element of a tuple or a list and its position.
struct Element {
    Value value;
    SourceSpan place;
};

/// A description of a value: "a number", "3 numbers in parentheses", "a list".
[[nodiscard]] std::string form_of(const Value& value);
/// The value for people: 45deg, (1, 2), [0, 1].
[[nodiscard]] std::string value_text(const Value& value);

/// A function or an operator of the language: one or more operations of the graph.
struct Function {
    std::string_view name;
    std::size_t arity;
    /// Null for count, whose argument is a tuple or a list.
    expr::Expr (*apply)(std::span<const expr::Expr> arguments, expr::Op op);
    expr::Op op;

    [[nodiscard]] bool takes_compound() const { return apply == nullptr; }
};

/// The function with a name; null if there is none. The names are those of expr::operations(), with
/// `if` for select, spow for the signed power, and count.
[[nodiscard]] const Function* find_function(std::string_view name);
/// The operator with a symbol and number of operands: those of the graph, and ^, >, >= and !=.
[[nodiscard]] const Function* find_operator(std::string_view symbol, std::size_t arity);
/// The function of keyframes, which key_calls.hpp evaluates: keys((0, 1), (2, 5), ease = smooth).
inline constexpr std::string_view keys_function = "keys";
/// The function of images, which grey_calls.hpp evaluates: grey("mix.png", x, y).
inline constexpr std::string_view grey_function = "grey";
/// Whether a name is that of a function that every file knows, and all these names.
[[nodiscard]] bool is_function(std::string_view name);
[[nodiscard]] std::vector<std::string> function_names();

/// The unit of a result, or the error of operands with incompatible units.
struct UnitResult {
    Unit unit = Unit::number;
    std::string error;
    std::string remedy;
};
[[nodiscard]] UnitResult unit_of(const Function& function, std::span<const Value> operands);

}  // namespace balcony::lang
