// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Formulas, which are stages themselves or arguments of one.

#include <fmt/format.h>

#include "lang/build/stages.hpp"
#include "lang/names/evaluate.hpp"

namespace balcony::lang {

StageBuilder::Located StageBuilder::formula(std::string_view name,
                                            const camera::FormulaShape& shape,
                                            const Expression& node) {
    Located made{camera::Failed{}, {tree_.at(node.span)}};
    if (node.kind != ExpressionKind::formula) {
        made.value = camera::Unsuitable{};
        return made;
    }
    const auto has_shape = [&](std::size_t results) {
        auto trouble = camera::shape_error(name, shape, node.parameters.size(), results);
        if (trouble) {
            const bool parameters = !shape.takes(node.parameters.size());
            trouble->span = tree_.at(parameters ? node.name.span : node.span);
            reporter_.add(std::move(*trouble));
        }
        return !trouble;
    };
    if (!shape.takes(node.parameters.size()) && !has_shape(node.arguments.size())) {
        return made;
    }
    Scope scope(&scope_);
    for (const camera::FormulaFunction& function : shape.functions) {
        scope.offer(function);
    }
    std::vector<expr::Expr> variables;
    if (!define_formula_parameters(node, scope, variables)) {
        return made;
    }
    std::vector<expr::Expr> results;
    std::vector<camera::Unit> units;
    const auto add = [&](const Value& value, const SourceSpan& place) {
        results.push_back(value.expr);
        units.push_back(value.unit);
        made.place.parts.push_back({place});
    };
    bool good = true;
    for (const Argument& result : node.arguments) {
        const SourceSpan place = tree_.at(tree_[result.value].span);
        const Value value = evaluate_any(tree_, result.value, scope, session_.context());
        if (value.form == Value::Form::list) {
            reporter_.error(place, "a result of a formula is a number, but this is a list",
                            "write the numbers one by one, or a tuple for several of them");
        }
        good = good && !value.failed() && value.form != Value::Form::list;
        if (value.form == Value::Form::tuple) {
            for (const Element& element : *value.elements) {
                add(element.value, place);
            }
        } else if (good) {
            add(value, place);
        }
    }
    if (good && has_shape(results.size())) {
        made.value =
            camera::Formula(graph_, std::move(variables), std::move(results), std::move(units));
    }
    return made;
}

std::optional<camera::Formula> StageBuilder::formula_of_picture(ExpressionId id,
                                                                std::string_view what) {
    Scope scope(&scope_);
    std::vector<expr::Expr> variables;
    for (const std::string_view name : {"x", "y"}) {
        variables.push_back(graph_->fresh_variable());
        const Value value{variables.back(), Unit::number, nullptr};
        scope.define(name, {value, tree_.at(tree_[id].span), "parameter", true});
    }
    const Value value = evaluate(tree_, id, scope, session_.context());
    if (value.failed()) {
        return std::nullopt;
    }
    if (value.is_angle()) {
        error(tree_[id].span, fmt::format("{} is a number, but this is an angle", what),
              "remove deg or rad, or divide the angle by 1rad");
        return std::nullopt;
    }
    return camera::Formula(graph_, std::move(variables), {value.expr});
}

bool StageBuilder::define_formula_parameters(const Expression& node, Scope& scope,
                                             std::vector<expr::Expr>& variables) {
    for (const Identifier& name : node.parameters) {
        const SourceSpan place = tree_.at(name.span);
        if (name.text == "t" || name.text == "pi") {
            error(name.span,
                  fmt::format("'{}' is reserved: it is {}", name.text,
                              name.text == "t" ? "time" : "the number 3.14159..."),
                  "choose another name, for example u");
            return false;
        }
        variables.push_back(graph_->fresh_variable());
        const Value value{variables.back(), Unit::either, nullptr};
        if (!scope.define(name.text, {value, place, "parameter", true})) {
            report_duplicate(name, place, scope.find_here(name.text)->place, reporter_);
            return false;
        }
    }
    return true;
}

}  // namespace balcony::lang
