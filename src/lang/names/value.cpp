// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/names/value.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace balcony::lang {

namespace {

using expr::Expr;
using expr::Op;
using Operands = std::span<const Expr>;

Expr as_operation(Operands a, Op op) { return a[0].graph().apply(op, a); }

// Operations with a different name in the graph.
constexpr std::array<Function, 4> added_operators = {{
    {"^", 2, as_operation, Op::power},
    {">", 2, [](Operands a, Op) { return a[1] < a[0]; }, Op::less},
    {">=", 2, [](Operands a, Op) { return a[1] <= a[0]; }, Op::less_equal},
    {"!=", 2, [](Operands a, Op) { return !expr::equal(a[0], a[1]); }, Op::equal},
}};

constexpr std::array<Function, 3> added_functions = {{
    {"if", 3, as_operation, Op::select},
    {"spow", 2, [](Operands a, Op) { return expr::signed_power(a[0], a[1]); }, Op::power},
    {"count", 1, nullptr, Op::constant},
}};

// The graph's operations that are infix operators, or those that are calls.
std::vector<Function> from_operations(bool infix) {
    std::vector<Function> rows;
    for (const expr::Operation& row : expr::operations()) {
        if (row.arity > 0 && row.scalar != nullptr && row.infix.empty() != infix) {
            rows.push_back({infix ? row.infix : row.name, static_cast<std::size_t>(row.arity),
                            as_operation, row.op});
        }
    }
    return rows;
}

const std::vector<Function>& functions() {
    static const std::vector<Function> rows = [] {
        std::vector<Function> made = from_operations(false);
        made.insert(made.end(), added_functions.begin(), added_functions.end());
        return made;
    }();
    return rows;
}

const std::vector<Function>& operators() {
    static const std::vector<Function> rows = [] {
        std::vector<Function> made = from_operations(true);
        made.insert(made.end(), added_operators.begin(), added_operators.end());
        return made;
    }();
    return rows;
}

// --------------------------------------------------------------------------------------- units

constexpr const char* as_a_number = "divide an angle by 1rad or 1deg for a plain number";

UnitResult mismatch(std::string error, std::string remedy = as_a_number) {
    return {Unit::number, std::move(error), std::move(remedy)};
}

// The common unit of operands that must agree; zero and formula parameters agree with any unit.
UnitResult common(const Function& function, std::span<const Value> operands) {
    const bool angle =
        std::any_of(operands.begin(), operands.end(), [](const Value& v) { return v.is_angle(); });
    const bool number = std::any_of(operands.begin(), operands.end(),
                                    [](const Value& v) { return v.is_plain_number(); });
    if (angle && number) {
        const bool call = std::all_of(function.name.begin(), function.name.end(),
                                      [](char c) { return c >= 'a' && c <= 'z'; });
        return mismatch(
            fmt::format("'{}' {} an angle and a plain number", function.name,
                        call ? "is given" : "combines"),
            "write the number as an angle (30deg, 0.5rad), or divide the angle by 1rad");
    }
    if (angle) {
        return {Unit::angle, {}, {}};
    }
    const bool either = std::any_of(operands.begin(), operands.end(),
                                    [](const Value& v) { return v.unit == Unit::either; });
    return {either ? Unit::either : Unit::number, {}, {}};
}

UnitResult product(const Value& a, const Value& b) {
    if (a.is_angle() && b.is_angle()) {
        return mismatch("the product of two angles is not supported");
    }
    if (a.is_angle() || b.is_angle()) {
        return {Unit::angle, {}, {}};
    }
    const bool either = a.unit == Unit::either || b.unit == Unit::either;
    return {either ? Unit::either : Unit::number, {}, {}};
}

UnitResult quotient(const Value& a, const Value& b) {
    if (b.is_angle()) {
        return a.is_plain_number() ? mismatch("a plain number is divided by an angle")
                                   : UnitResult{};
    }
    return {a.unit, {}, {}};
}

UnitResult plain(const Function& function, std::span<const Value> operands, Unit made) {
    const bool angle =
        std::any_of(operands.begin(), operands.end(), [](const Value& v) { return v.is_angle(); });
    if (angle) {
        return mismatch(
            fmt::format("'{}' takes plain numbers, but this is an angle", function.name));
    }
    return {made, {}, {}};
}

}  // namespace

UnitResult unit_of(const Function& function, std::span<const Value> operands) {
    const auto with = [](UnitResult result, Unit made) {
        result.unit = made;
        return result;
    };
    using expr::UnitRule;
    switch (expr::operation(function.op).units) {
        case UnitRule::numbers: return plain(function, operands, Unit::number);
        case UnitRule::numbers_to_angle: return plain(function, operands, Unit::angle);
        case UnitRule::anything_to_number: return {};
        case UnitRule::kept: return {operands[0].unit, {}, {}};
        case UnitRule::common: return common(function, operands);
        case UnitRule::common_to_number: return with(common(function, operands), Unit::number);
        case UnitRule::common_to_angle: return with(common(function, operands), Unit::angle);
        case UnitRule::common_after_first: return common(function, operands.subspan(1));
        case UnitRule::product: return product(operands[0], operands[1]);
        case UnitRule::quotient: return quotient(operands[0], operands[1]);
    }
    return {};
}

std::string form_of(const Value& value) {
    switch (value.form) {
        case Value::Form::tuple:
            return fmt::format("{} numbers in parentheses", value.elements->size());
        case Value::Form::list: return "a list";
        default: return "a number";
    }
}

std::string value_text(const Value& value) {
    if (value.elements) {
        std::vector<std::string> texts;
        for (const Element& element : *value.elements) {
            texts.push_back(value_text(element.value));
        }
        const bool list = value.form == Value::Form::list;
        return fmt::format("{}{}{}", list ? "[" : "(", fmt::join(texts, ", "), list ? "]" : ")");
    }
    if (!value.is_constant()) {
        return "changes with time";
    }
    return value.is_angle() ? fmt::format("{:.6g}deg", value.constant() * 180.0 / std::numbers::pi)
                            : fmt::format("{:.6g}", value.constant());
}

const Function* find_function(std::string_view name) {
    const auto row = std::find_if(functions().begin(), functions().end(),
                                  [name](const Function& f) { return f.name == name; });
    return row == functions().end() ? nullptr : &*row;
}

const Function* find_operator(std::string_view symbol, std::size_t arity) {
    const auto row = std::find_if(
        operators().begin(), operators().end(),
        [symbol, arity](const Function& f) { return f.name == symbol && f.arity == arity; });
    return row == operators().end() ? nullptr : &*row;
}

std::vector<std::string> function_names() {
    std::vector<std::string> names;
    for (const Function& function : functions()) {
        names.emplace_back(function.name);
    }
    names.emplace_back(keys_function);
    names.emplace_back(grey_function);
    return names;
}

bool is_function(std::string_view name) {
    return name == keys_function || name == grey_function || find_function(name) != nullptr;
}

}  // namespace balcony::lang
