// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/expr.hpp"

namespace balcony::lang {

/// What a value counts. A formula's parameters are of either kind, as its user decides.
enum class Dimension : std::uint8_t { number, angle, either };

struct Element;

/// What an expression stands for: a number, which is a node of the session's graph with its unit,
/// or a tuple or a list of values. A failed value comes from something that is reported already;
/// whatever uses it fails in silence.
struct Value {
    enum class Form : std::uint8_t { number, tuple, list };

    expr::Expr expr;
    Dimension dimension = Dimension::number;
    /// What is wrong with the number itself (a division by 0); reported if the value is used, so
    /// that if(c, a, b) may hold what it guards against.
    std::shared_ptr<const Diagnostic> problem{};
    Form form = Form::number;
    /// The numbers of a tuple, the numbers and tuples of a list; none of them has failed.
    std::shared_ptr<const std::vector<Element>> elements{};

    [[nodiscard]] bool failed() const { return !expr.valid() && !elements; }
    [[nodiscard]] bool is_constant() const { return expr.valid() && expr.is_constant(); }
    [[nodiscard]] double constant() const { return expr.node().value; }
    /// 0 has every unit.
    [[nodiscard]] bool is_zero() const { return is_constant() && constant() == 0.0; }
    [[nodiscard]] bool is_angle() const { return dimension == Dimension::angle && !is_zero(); }
    [[nodiscard]] bool is_plain_number() const {
        return dimension == Dimension::number && !is_zero();
    }
};

/// A part of a tuple or a list, where it is written.
struct Element {
    Value value;
    SourceSpan place;
};

/// What a value is, in words: a number, 3 numbers in parentheses, a list.
[[nodiscard]] std::string form_of(const Value& value);

/// A function or an operator of the language: an operation of the graph, or made of some.
struct Function {
    std::string_view name;
    std::size_t arity;
    expr::Expr (*apply)(std::span<const expr::Expr> arguments, expr::Op op);
    expr::Op op;
};

/// The function of a name; null if there is none. The names are those of expr::operations(), with
/// `if` for select and spow for the signed power.
[[nodiscard]] const Function* find_function(std::string_view name);
/// The operator of a symbol with so many operands, with ^, >, >= and != added to the graph's.
[[nodiscard]] const Function* find_operator(std::string_view symbol, std::size_t arity);
[[nodiscard]] std::vector<std::string> function_names();

/// The unit of a result, or why the operands' units do not go together.
struct DimensionResult {
    Dimension dimension = Dimension::number;
    std::string error;
    std::string remedy;
};
[[nodiscard]] DimensionResult dimension_of(const Function& function,
                                           std::span<const Value> operands);

}  // namespace balcony::lang
