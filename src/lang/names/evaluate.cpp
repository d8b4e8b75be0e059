// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/names/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "balcony/catalogue.hpp"

namespace balcony::lang {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;

// Visits the nodes of an expression in their order, operands first, so that deep expressions need
// no recursion.
class Evaluator {
public:
    Evaluator(const SyntaxTree& tree, Scope& scope, const Context& context)
        : tree_(tree),
          scope_(scope),
          graph_(context.graph),
          reporter_(context.reporter),
          catalogue_(context.catalogue) {}

    Value run(ExpressionId id) {
        first_ = tree_[id].first.value();
        const std::size_t last = id.value();
        for (std::size_t i = first_; i <= last; ++i) {
            if (!belongs_to_an_expression(tree_.expressions[i])) {
                return {};
            }
        }
        try {
            for (std::size_t i = first_; i <= last; ++i) {
                values_.push_back(value_of(tree_.expressions[i]));
            }
        } catch (const expr::GraphTooLarge&) {
            error(tree_[id].span, "the formulas of this file are too large",
                  "leave some out, or share what they have in common by let");
            return {};
        }
        Value result = values_.back();
        if (result.problem) {
            reporter_.add(*result.problem);
            return {};
        }
        return result;
    }

private:
    void error(Span span, std::string message, std::string remedy = {}) {
        reporter_.error(tree_.at(span), std::move(message), std::move(remedy));
    }

    // Reports stages, tuples and formulas in place of a number before their parts cause errors of
    // their own.
    bool belongs_to_an_expression(const Expression& node) {
        switch (node.kind) {
            case ExpressionKind::tuple:
                error(node.span,
                      fmt::format("expected a number, but found {} numbers in parentheses",
                                  node.arguments.size()),
                      "write one number, or combine them with operators");
                return false;
            case ExpressionKind::list:
                error(node.span, "expected a number, but found a list",
                      "brackets are for lists of points and for the results of a formula; "
                      "use ( ) to group parts of an expression");
                return false;
            case ExpressionKind::text:
                error(node.span, "expected a number, but found a file name",
                      "write a number; tables are only for arguments that are points");
                return false;
            case ExpressionKind::formula:
                error(node.span, "expected a number, but found a formula",
                      "write only its expression here");
                return false;
            case ExpressionKind::call: return is_function_call(node);
            default: return true;
        }
    }

    bool is_function_call(const Expression& node) {
        const camera::FormulaFunction* offered = scope_.find_function(node.name.text);
        const Function* function = find_function(node.name.text);
        if (offered == nullptr && function == nullptr) {
            unknown_function(node.name);
            return false;
        }
        for (const Argument& argument : node.arguments) {
            if (argument.name) {
                error(argument.name->span,
                      fmt::format("the function '{}' takes no named arguments", node.name.text),
                      fmt::format("remove '{} ='", argument.name->text));
                return false;
            }
        }
        const std::size_t arity =
            offered != nullptr ? offered->native->argument_count() : function->arity;
        if (node.arguments.size() != arity) {
            error(node.span,
                  fmt::format("'{}' takes {} argument{}, but {} are given", node.name.text, arity,
                              arity == 1 ? "" : "s", node.arguments.size()),
                  fmt::format("the syntax is {}", call_of(node.name.text, arity)));
            return false;
        }
        return true;
    }

    void unknown_function(const Identifier& name) {
        for (const camera::StageEntry& row : catalogue_) {
            if (row.name == name.text) {
                error(
                    name.span,
                    fmt::format("expected a number, but '{}' is a stage ({})", name.text,
                                camera::name_of(row.kind)),
                    fmt::format("write a number; run 'balcony list {}' to see how to use the stage",
                                name.text));
                return;
            }
        }
        if (scope_.find(name.text) != nullptr) {
            error(name.span, fmt::format("'{}' is a number and cannot be called", name.text),
                  fmt::format("write {} * ( ... ) for a product", name.text));
            return;
        }
        std::vector<std::string> names = scope_.offered_names();
        const std::vector<std::string> everywhere = function_names();
        names.insert(names.end(), everywhere.begin(), everywhere.end());
        error(name.span, fmt::format("unknown function '{}'", name.text),
              suggestion(name.text, names, "the functions are"));
    }

    Value value_of(const Expression& node) {
        switch (node.kind) {
            case ExpressionKind::number: return number(node);
            case ExpressionKind::name: return named(node);
            case ExpressionKind::operation:
                return applied(node, *find_operator(node.name.text, node.arguments.size()));
            default: break;
        }
        const camera::FormulaFunction* offered = scope_.find_function(node.name.text);
        return offered != nullptr ? called(node, *offered)
                                  : applied(node, *find_function(node.name.text));
    }

    Value number(const Expression& node) {
        const double factor = node.unit == NumberUnit::degrees ? radians_per_degree : 1.0;
        return {graph_.constant(node.value * factor),
                node.unit == NumberUnit::none ? Dimension::number : Dimension::angle, nullptr};
    }

    Value named(const Expression& node) {
        if (Definition* definition = scope_.find(node.name.text)) {
            definition->used = true;
            if (definition->value.elements) {
                error(node.span,
                      fmt::format("expected a number, but '{}' is {}", node.name.text,
                                  form_of(definition->value)),
                      "tuples and lists are given whole to stages; numbers of them need names of "
                      "their own");
                return {};
            }
            return definition->value;
        }
        if (const auto why = scope_.announced(node.name.text); !why.empty()) {
            error(node.span, fmt::format("'{}' cannot be used here", node.name.text),
                  std::string(why));
            return {};
        }
        if (scope_.find_function(node.name.text) != nullptr ||
            find_function(node.name.text) != nullptr) {
            error(node.span, fmt::format("'{}' is a function", node.name.text),
                  fmt::format("add its arguments: {}( ... )", node.name.text));
            return {};
        }
        if (node.name.text == "deg" || node.name.text == "rad") {
            error(node.span, fmt::format("the unit '{}' has no number", node.name.text),
                  fmt::format(
                      "append it to a number, for example 30{0}; multiply an expression by a unit, "
                      "for example x*1{0}",
                      node.name.text));
            return {};
        }
        if (scope_.incomplete()) {
            return {};
        }
        error(node.span, fmt::format("unknown name '{}'", node.name.text),
              suggestion(node.name.text, scope_.names(), "the names available here are"));
        return {};
    }

    Value applied(const Expression& node, const Function& function) {
        std::vector<Value> operands;
        std::vector<expr::Expr> arguments;
        Value result;
        for (const Argument& argument : node.arguments) {
            operands.push_back(values_[argument.value.value() - first_]);
            if (operands.back().failed()) {
                return {};
            }
            arguments.push_back(operands.back().expr);
        }
        const DimensionResult dimension = dimension_of(function, operands);
        if (!dimension.error.empty()) {
            error(node.span, dimension.error, dimension.remedy);
            return {};
        }
        result.dimension = dimension.dimension;
        result.problem = inherited_problem(function, operands);
        if (!result.problem && function.op == expr::Op::divide && operands[1].is_zero()) {
            const Span divisor = tree_[node.arguments[1].value].span;
            result.problem = problem(divisor, "division by 0",
                                     "change the divisor, or exclude 0 with if(condition, a, b)");
        }
        result.expr = function.apply(arguments, function.op);
        if (!result.problem && result.is_constant() && !std::isfinite(result.constant())) {
            result.problem = problem(
                node.span,
                fmt::format("{} {}", with_values(node, operands),
                            std::isnan(result.constant()) ? "has no real value" : "is not finite"),
                "change the numbers, or exclude such values with max, min or if(condition, a, b)");
        }
        return result;
    }

    // A function that the stage around the formula offers.
    Value called(const Expression& node, const camera::FormulaFunction& function) {
        std::vector<expr::Expr> arguments;
        Value result;
        for (const Argument& argument : node.arguments) {
            const Value& operand = values_[argument.value.value() - first_];
            if (operand.failed()) {
                return {};
            }
            if (operand.is_angle()) {
                error(tree_[argument.value].span,
                      fmt::format("'{}' takes plain numbers, but this is an angle", function.name),
                      "divide an angle by 1rad or 1deg for a plain number");
                return {};
            }
            arguments.push_back(operand.expr);
            result.problem = result.problem ? result.problem : operand.problem;
        }
        result.expr = graph_.call(function.native, arguments)[function.result];
        return result;
    }

    // atan2(a, b)
    static std::string call_of(std::string_view name, std::size_t arity) {
        std::string letters;
        for (std::size_t i = 0; i < arity; ++i) {
            letters += i == 0 ? "" : ", ";
            letters += static_cast<char>('a' + i % 26);
        }
        return fmt::format("{}({})", name, letters);
    }

    // sqrt(-1), 0 ^ -1
    static std::string with_values(const Expression& node, std::span<const Value> operands) {
        std::string text;
        const bool call = node.kind == ExpressionKind::call;
        const std::string join = call ? ", " : fmt::format(" {} ", node.name.text);
        for (const Value& operand : operands) {
            text += fmt::format("{}{:.6g}", text.empty() ? "" : join, operand.constant());
        }
        return call ? fmt::format("{}({})", node.name.text, text) : text;
    }

    std::shared_ptr<const Diagnostic> problem(Span span, std::string message,
                                              std::string remedy) const {
        return std::make_shared<const Diagnostic>(
            balcony::error(std::move(message), tree_.at(span), std::move(remedy)));
    }

    // A constant condition excludes the other branch.
    static std::shared_ptr<const Diagnostic> inherited_problem(const Function& function,
                                                               std::span<const Value> operands) {
        const bool decided =
            function.op == expr::Op::select && operands[0].is_constant() && !operands[0].problem;
        if (decided) {
            return operands[operands[0].constant() != 0.0 ? 1 : 2].problem;
        }
        for (const Value& operand : operands) {
            if (operand.problem) {
                return operand.problem;
            }
        }
        return nullptr;
    }

    const SyntaxTree& tree_;
    Scope& scope_;
    expr::Graph& graph_;
    Reporter& reporter_;
    const camera::Catalogue& catalogue_;
    std::size_t first_ = 0;
    std::vector<Value> values_;
};

// The elements of a tuple or a list: numbers and, in a list, tuples, which may be named.
Value evaluate_elements(const SyntaxTree& tree, const Expression& compound, Scope& scope,
                        const Context& context) {
    const bool is_list = compound.kind == ExpressionKind::list;
    auto elements = std::make_shared<std::vector<Element>>();
    elements->reserve(compound.arguments.size());
    for (const Argument& argument : compound.arguments) {
        const SourceSpan place = tree.at(tree[argument.value].span);
        const bool list_in_list = is_list && tree[argument.value].kind == ExpressionKind::list;
        Value value = list_in_list ? Value()
                      : is_list    ? evaluate_any(tree, argument.value, scope, context)
                                   : evaluate(tree, argument.value, scope, context);
        if (list_in_list || value.form == Value::Form::list) {
            context.reporter.error(place, "a list contains numbers or points, but this is a list",
                                   "write a point in parentheses, (1, 2); write several rows of "
                                   "points as one list, row by row");
            return {};
        }
        if (!value.failed()) {
            elements->push_back({std::move(value), place});
        }
        if (context.reporter.full()) {
            return {};
        }
    }
    Value made;
    if (elements->size() == compound.arguments.size()) {
        made.form = is_list ? Value::Form::list : Value::Form::tuple;
        made.elements = std::move(elements);
    }
    return made;
}

}  // namespace

Value evaluate(const SyntaxTree& tree, ExpressionId id, Scope& scope, const Context& context) {
    return Evaluator(tree, scope, context).run(id);
}

std::optional<Value> evaluate_compound(const SyntaxTree& tree, ExpressionId id, Scope& scope,
                                       const Context& context) {
    const Expression& node = tree[id];
    if (node.kind == ExpressionKind::tuple || node.kind == ExpressionKind::list) {
        return evaluate_elements(tree, node, scope, context);
    }
    Definition* definition =
        node.kind == ExpressionKind::name ? scope.find(node.name.text) : nullptr;
    if (definition == nullptr || definition->value.expr.valid()) {
        return std::nullopt;
    }
    definition->used = true;
    return definition->value;
}

Value evaluate_any(const SyntaxTree& tree, ExpressionId id, Scope& scope, const Context& context) {
    const std::optional<Value> compound = evaluate_compound(tree, id, scope, context);
    return compound ? *compound : evaluate(tree, id, scope, context);
}

}  // namespace balcony::lang
