// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Stages that are made from a formula.

#include <fmt/format.h>

#include "lang/evaluate.hpp"
#include "lang/stages.hpp"

namespace balcony::lang {

namespace {

using camera::StageEntry;
using camera::StageKind;

std::string numbers_in_words(std::size_t least, std::size_t most) {
    return least == most ? fmt::format("{}", least) : fmt::format("{} or {}", least, most);
}

}  // namespace

std::optional<camera::Formula> StageBuilder::formula(const StageEntry& row,
                                                     const Expression& node) {
    const camera::FormulaShape& shape = *row.formula;
    if (node.kind != ExpressionKind::formula) {
        error(node.span, fmt::format("'{}' is made from a formula", row.name),
              fmt::format("it is written {}", signature(row)));
        return std::nullopt;
    }
    if (node.parameters.size() != shape.parameters) {
        error(
            node.name.span,
            fmt::format("the formula '{}' has {} parameter{}, but this one has {}", row.name,
                        shape.parameters, shape.parameters == 1 ? "" : "s", node.parameters.size()),
            fmt::format("it is written {}", signature(row)));
        return std::nullopt;
    }
    if (node.arguments.size() < shape.results_least || node.arguments.size() > shape.results_most) {
        error(node.span,
              fmt::format("the formula '{}' has {} results, but this one has {}", row.name,
                          numbers_in_words(shape.results_least, shape.results_most),
                          node.arguments.size()),
              fmt::format("it is written {}", signature(row)));
        return std::nullopt;
    }
    Scope scope(&scope_);
    std::vector<expr::Expr> variables;
    for (const Identifier& name : node.parameters) {
        const SourceSpan place = tree_.at(name.span);
        if (name.text == "t" || name.text == "pi") {
            error(name.span,
                  fmt::format("'{}' is taken: it is {}", name.text,
                              name.text == "t" ? "time" : "the number 3.14159..."),
                  "choose another name, such as u");
            return std::nullopt;
        }
        variables.push_back(graph_->fresh_variable());
        const Value value{variables.back(), Dimension::either, nullptr};
        if (!scope.define(name.text, {value, place, "parameter", true})) {
            report_duplicate(name, place, scope.find_here(name.text)->place, reporter_);
            return std::nullopt;
        }
    }
    const auto results = formula_results(row, node, scope);
    return results ? std::optional(camera::Formula(graph_, std::move(variables), *results))
                   : std::nullopt;
}

std::optional<std::vector<expr::Expr>> StageBuilder::formula_results(const StageEntry& row,
                                                                     const Expression& node,
                                                                     Scope& scope) {
    std::vector<expr::Expr> results;
    for (const Argument& result : node.arguments) {
        const Value value = evaluate(tree_, result.value, scope, *graph_, reporter_);
        if (value.failed()) {
            continue;
        }
        if (value.is_angle() && row.kind != StageKind::parameter_transformer) {
            error(tree_[result.value].span,
                  fmt::format("the results of '{}' are lengths, but this is an angle", row.name),
                  "divide it by 1rad for the number of radians");
            continue;
        }
        results.push_back(value.expr);
    }
    return results.size() == node.arguments.size() ? std::optional(std::move(results))
                                                   : std::nullopt;
}

}  // namespace balcony::lang
