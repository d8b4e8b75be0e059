// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Stages that consist of a formula, and formulas as arguments of stages.

#include <fmt/format.h>

#include "lang/build/stages.hpp"
#include "lang/names/evaluate.hpp"

namespace balcony::lang {

namespace {

using camera::StageEntry;
using camera::StageKind;
using camera::StageParameter;

std::string numbers_in_words(std::size_t minimum, std::size_t maximum) {
    return minimum == maximum ? fmt::format("{}", minimum)
                              : fmt::format("{} or {}", minimum, maximum);
}

}  // namespace

std::optional<camera::Formula> StageBuilder::stage_formula(const StageEntry& row,
                                                           const Expression& node) {
    const std::string written = signature(row);
    if (node.kind != ExpressionKind::formula) {
        error(node.span, fmt::format("'{}' needs a formula", row.name),
              fmt::format("the syntax is {}", written));
        return std::nullopt;
    }
    const auto fits = [this, &row](const Value& result, const SourceSpan& place) {
        if (result.is_angle() && row.kind != StageKind::parameter_transformer) {
            error(
                place,
                fmt::format("the results of '{}' must be lengths, but this is an angle", row.name),
                "divide it by 1rad to get the number of radians");
            return false;
        }
        return true;
    };
    return formula({row.name, *row.formula, written, fits}, node);
}

std::optional<camera::Formula> StageBuilder::formula_argument(const StageEntry& row,
                                                              const StageParameter& parameter,
                                                              ExpressionId given) {
    const Expression& node = tree_[given];
    const std::string written = signature(parameter.name, parameter.shape);
    if (node.kind != ExpressionKind::formula) {
        error(node.span, fmt::format("'{}' of '{}' takes a formula", parameter.name, row.name),
              fmt::format("the syntax is {}", written));
        return std::nullopt;
    }
    const auto in_unit = [this, &row, &parameter](const Value& result, const SourceSpan& place) {
        return fits(row, parameter, result, place);
    };
    return formula({parameter.name, parameter.shape, written, in_unit}, node);
}

std::optional<camera::Formula> StageBuilder::formula(const FormulaRules& rules,
                                                     const Expression& node) {
    const camera::FormulaShape& shape = rules.shape;
    if (node.parameters.size() != shape.parameters) {
        error(
            node.name.span,
            fmt::format("the formula '{}' has {} parameter{}, but this one has {}", rules.name,
                        shape.parameters, shape.parameters == 1 ? "" : "s", node.parameters.size()),
            fmt::format("the syntax is {}", rules.written));
        return std::nullopt;
    }
    if (node.arguments.size() < shape.min_results || node.arguments.size() > shape.max_results) {
        error(node.span,
              fmt::format("the formula '{}' has {} result{}, but this one has {}", rules.name,
                          numbers_in_words(shape.min_results, shape.max_results),
                          shape.max_results == 1 ? "" : "s", node.arguments.size()),
              fmt::format("the syntax is {}", rules.written));
        return std::nullopt;
    }
    Scope scope(&scope_);
    for (const camera::FormulaFunction& function : shape.functions) {
        scope.offer(function);
    }
    std::vector<expr::Expr> variables;
    for (const Identifier& name : node.parameters) {
        const SourceSpan place = tree_.at(name.span);
        if (name.text == "t" || name.text == "pi") {
            error(name.span,
                  fmt::format("'{}' is reserved: it is {}", name.text,
                              name.text == "t" ? "time" : "the number 3.14159..."),
                  "choose another name, for example u");
            return std::nullopt;
        }
        variables.push_back(graph_->fresh_variable());
        const Value value{variables.back(), Dimension::either, nullptr};
        if (!scope.define(name.text, {value, place, "parameter", true})) {
            report_duplicate(name, place, scope.find_here(name.text)->place, reporter_);
            return std::nullopt;
        }
    }
    const auto results = formula_results(rules, node, scope);
    return results ? std::optional(camera::Formula(graph_, std::move(variables), *results))
                   : std::nullopt;
}

std::optional<std::vector<expr::Expr>> StageBuilder::formula_results(const FormulaRules& rules,
                                                                     const Expression& node,
                                                                     Scope& scope) {
    std::vector<expr::Expr> results;
    for (const Argument& result : node.arguments) {
        const Value value = evaluate(tree_, result.value, scope, *graph_, reporter_);
        if (!value.failed() && rules.fits(value, tree_.at(tree_[result.value].span))) {
            results.push_back(value.expr);
        }
    }
    return results.size() == node.arguments.size() ? std::optional(std::move(results))
                                                   : std::nullopt;
}

}  // namespace balcony::lang
