// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/names/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "balcony/catalogue.hpp"
#include "lang/names/function_calls.hpp"

namespace balcony::lang {

namespace {

constexpr std::size_t deepest_calls = 400;
constexpr std::size_t max_nodes_in_calls = 4'000'000;

// What an expression may be.
enum class Wanted : std::uint8_t { number, any };

// Evaluates parts of an expression that are expressions on their own.
class DeeperCall {
public:
    explicit DeeperCall(CallWork& calls) : calls_(calls) { ++calls_.depth; }
    DeeperCall(const DeeperCall&) = delete;
    DeeperCall& operator=(const DeeperCall&) = delete;
    ~DeeperCall() { --calls_.depth; }

private:
    CallWork& calls_;
};

// Visits the nodes of an expression in their order, operands first, so that deep expressions need
// no recursion. The parts of an element and the arguments of a file's function may be tuples and
// lists; they are expressions of their own.
class Evaluator {
public:
    Evaluator(const SyntaxTree& tree, Scope& scope, const Context& context)
        : tree_(tree),
          scope_(scope),
          context_(context),
          graph_(context.graph),
          reporter_(context.reporter) {}

    // A value with its problem, if it has one.
    Value run(ExpressionId id, Wanted wanted) {
        root_ = id;
        wanted_ = wanted;
        first_ = tree_[id].first.value();
        order_ = order_of(id.value());
        if (!all_belong_to_an_expression(order_) || is_too_much(order_.size())) {
            return {};
        }
        try {
            values_.reserve(order_.size());
            for (const std::size_t i : order_) {
                values_.push_back(value_of(tree_.expressions[i], i == id.value()));
            }
        } catch (const expr::GraphTooLarge&) {
            error(tree_[id].span, "the formulas of this file are too large",
                  "leave some out, or share what they have in common by let");
            return {};
        }
        return values_.back();
    }

private:
    void error(Span span, std::string message, std::string remedy = {}) {
        reporter_.error(tree_.at(span), std::move(message), std::move(remedy));
    }

    // The nodes that are evaluated here.
    [[nodiscard]] std::vector<std::size_t> order_of(std::size_t last) const {
        std::vector<std::size_t> order;
        for (std::size_t next = last + 1; next > first_;) {
            const std::size_t i = next - 1;
            order.push_back(i);
            next =
                has_parts_of_its_own(tree_.expressions[i]) ? tree_.expressions[i].first.value() : i;
        }
        std::reverse(order.begin(), order.end());
        return order;
    }

    // Of a node that precedes the current one.
    [[nodiscard]] const Value& value_at(ExpressionId id) const {
        const auto place = std::lower_bound(order_.begin(), order_.end(), id.value());
        return values_[static_cast<std::size_t>(place - order_.begin())];
    }

    [[nodiscard]] bool has_parts_of_its_own(const Expression& node) const {
        return node.kind == ExpressionKind::element || calls_let(node, scope_) ||
               calls_count(node, scope_) || calls_special(node, scope_);
    }

    bool all_belong_to_an_expression(const std::vector<std::size_t>& order) {
        return std::all_of(order.begin(), order.end(), [this](std::size_t i) {
            return belongs_to_an_expression(tree_.expressions[i]);
        });
    }

    // Functions that call others several times could need any amount of time.
    bool is_too_much(std::size_t count) {
        CallWork& calls = context_.calls;
        calls.nodes += calls.depth > 0 ? count : 0;
        const bool too_deep = calls.depth > deepest_calls;
        if (!calls.exceeds_limit && (too_deep || calls.nodes > max_nodes_in_calls)) {
            calls.exceeds_limit = true;
            error(tree_[root_].span,
                  too_deep ? fmt::format("calls of functions are nested more than {} levels deep",
                                         deepest_calls)
                           : fmt::format("the calls of functions have more than {} operations",
                                         max_nodes_in_calls),
                  "name intermediate results by let, and call functions fewer times");
        }
        return calls.exceeds_limit;
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
            case ExpressionKind::call: return check_call(tree_, node, scope_, context_);
            default: return true;
        }
    }

    Value value_of(const Expression& node, bool is_root) {
        switch (node.kind) {
            case ExpressionKind::number: return number(node);
            case ExpressionKind::name: return suitable(node, named(node), is_root);
            case ExpressionKind::element: return suitable(node, element(node), is_root);
            case ExpressionKind::operation:
                return applied(node, *find_operator(node.name.text, node.arguments.size()));
            default: break;
        }
        const Callee callee = find_callee(node.name.text, scope_);
        return callee.offered != nullptr ? called(node, *callee.offered)
               : callee.let != nullptr   ? suitable(node, called(node, *callee.let), is_root)
               : callee.special != nullptr
                   ? suitable(node, callee.special(tree_, node, scope_, context_), is_root)
               : callee.built_in->takes_compound() ? counted(node)
                                                   : applied(node, *callee.built_in);
    }

    // Only the whole may be a tuple or a list, if it may be one.
    Value suitable(const Expression& node, Value value, bool is_root) {
        if (!value.elements || (is_root && wanted_ == Wanted::any)) {
            return value;
        }
        error(
            node.span,
            fmt::format("expected a number, but '{}' is {}", tree_.text(node.span), form_of(value)),
            fmt::format("write {}[0] for its first element; a tuple or a list is given whole to "
                        "stages and functions",
                        tree_.text(node.span)));
        return {};
    }

    Value number(const Expression& node) {
        const double factor = node.unit == NumberUnit::degrees ? radians_per_degree : 1.0;
        return {graph_.constant(node.value * factor),
                node.unit == NumberUnit::none ? Unit::number : Unit::angle, nullptr};
    }

    Value named(const Expression& node) {
        if (Definition* definition = scope_.find(node.name.text)) {
            definition->used = true;
            if (definition->function) {
                error(node.span, fmt::format("'{}' is a function", node.name.text),
                      fmt::format("add its arguments: {}", signature(*definition->function)));
                return {};
            }
            return definition->value;
        }
        if (const auto why = scope_.announced(node.name.text); !why.empty()) {
            error(node.span, fmt::format("'{}' cannot be used here", node.name.text),
                  std::string(why));
            return {};
        }
        if (scope_.find_function(node.name.text) != nullptr || is_function(node.name.text)) {
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
        reporter_.missing(node.name.text, tree_.at(node.span),
                          fmt::format("unknown name '{}'", node.name.text), [&] {
                              return suggestion(node.name.text, scope_.names(),
                                                "the names available here are");
                          });
        return {};
    }

    Value applied(const Expression& node, const Function& function) {
        std::vector<Value> operands;
        std::vector<expr::Expr> arguments;
        Value result;
        for (const Argument& argument : node.arguments) {
            operands.push_back(value_at(argument.value));
            if (operands.back().failed()) {
                return {};
            }
            arguments.push_back(operands.back().expr);
        }
        const UnitResult unit = unit_of(function, operands);
        if (!unit.error.empty()) {
            error(node.span, unit.error, unit.remedy);
            return {};
        }
        result.unit = unit.unit;
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

    // compound[index], where the index starts at 0.
    Value element(const Expression& node) {
        const ExpressionId at = node.arguments[1].value;
        const Value compound = part(node.arguments[0].value, Wanted::any);
        const Value index = part(at, Wanted::number);
        if (compound.failed() || index.failed()) {
            return {};
        }
        const std::string_view written = tree_.text(tree_[node.arguments[0].value].span);
        if (!compound.elements) {
            error(tree_[node.arguments[0].value].span,
                  fmt::format("'{}' is a number, which has no elements", written),
                  "brackets after a value select an element of a list or a tuple, from 0");
            return {};
        }
        const std::size_t count = compound.elements->size();
        const bool whole = index.is_constant() && !index.is_angle() && !index.problem &&
                           std::floor(index.constant()) == index.constant();
        if (!whole || index.constant() < 0.0 || index.constant() >= static_cast<double>(count)) {
            const std::string found =
                index.is_constant() ? fmt::format("{:.6g}", index.constant()) : "not constant";
            error(tree_[at].span,
                  fmt::format("the index of an element is {}, but this is {}",
                              count == 0 ? "impossible in an empty list"
                                         : fmt::format("a whole number from 0 to {}", count - 1),
                              found),
                  fmt::format("'{}' is {} of {} element{}; the first is {}[0]", written,
                              compound.form == Value::Form::list ? "a list" : "a tuple", count,
                              count == 1 ? "" : "s", written));
            return {};
        }
        return (*compound.elements)[static_cast<std::size_t>(index.constant())].value;
    }

    // count(compound)
    Value counted(const Expression& node) {
        const ExpressionId at = node.arguments[0].value;
        const Value compound = part(at, Wanted::any);
        if (compound.failed()) {
            return {};
        }
        if (!compound.elements) {
            error(tree_[at].span, "'count' takes a list or a tuple, but this is a number",
                  "a list is in brackets: count([(0, 0), (1, 2)]) is 2");
            return {};
        }
        return {graph_.constant(static_cast<double>(compound.elements->size())), Unit::number,
                nullptr};
    }

    // A part that is an expression of its own.
    Value part(ExpressionId id, Wanted wanted) {
        const DeeperCall deeper(context_.calls);
        const ExpressionKind kind = tree_[id].kind;
        const bool compound = kind == ExpressionKind::tuple || kind == ExpressionKind::list;
        return compound && wanted == Wanted::any
                   ? evaluate_any(tree_, id, scope_, context_)
                   : Evaluator(tree_, scope_, context_).run(id, wanted);
    }

    // A function that the file defines.
    Value called(const Expression& node, Definition& definition) {
        const LetFunction& function = *definition.function;
        definition.used = true;
        Scope inner(&function.scope);
        bool good = true;
        for (std::size_t i = 0; i < node.arguments.size(); ++i) {
            const ExpressionId argument = node.arguments[i].value;
            Value value = part(argument, Wanted::any);
            good = good && !value.failed();
            inner.define(function.let.parameters[i].text,
                         {std::move(value), tree_.at(tree_[argument].span), "parameter", true});
        }
        if (!good) {
            return {};
        }
        const Diagnostic::Note note{tree_.at(node.span),
                                    fmt::format("in this call of '{}'", node.name.text)};
        const std::size_t before = reporter_.count();
        Value result =
            Evaluator(function.tree, inner, context_).part(function.let.value, Wanted::any);
        reporter_.annotate(before, note);
        if (result.problem) {
            Diagnostic problem = *result.problem;
            problem.notes.push_back(note);
            result.problem = std::make_shared<const Diagnostic>(std::move(problem));
        }
        return result;
    }

    // A function that the stage around the formula offers.
    Value called(const Expression& node, const camera::FormulaFunction& function) {
        std::vector<expr::Expr> arguments;
        Value result;
        for (const Argument& argument : node.arguments) {
            const Value& operand = value_at(argument.value);
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
    const Context& context_;
    expr::Graph& graph_;
    Reporter& reporter_;
    ExpressionId root_{};
    Wanted wanted_ = Wanted::number;
    std::size_t first_ = 0;
    std::vector<std::size_t> order_;  // The nodes that are evaluated here, increasing.
    std::vector<Value> values_;       // By the same numbers.
};

// Reports the problem of a value that is used.
Value used(Value value, const Context& context) {
    if (!value.problem) {
        return value;
    }
    context.reporter.add(*value.problem);
    return {};
}

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
    return used(Evaluator(tree, scope, context).run(id, Wanted::number), context);
}

Value evaluate_any(const SyntaxTree& tree, ExpressionId id, Scope& scope, const Context& context) {
    const Expression& node = tree[id];
    if (node.kind == ExpressionKind::tuple || node.kind == ExpressionKind::list) {
        return evaluate_elements(tree, node, scope, context);
    }
    return used(Evaluator(tree, scope, context).run(id, Wanted::any), context);
}

std::optional<Value> evaluate_compound(const SyntaxTree& tree, ExpressionId id, Scope& scope,
                                       const Context& context) {
    const Expression& node = tree[id];
    const Definition* definition = scope.find(node.name.text);
    const bool may_be_compound =
        node.kind == ExpressionKind::tuple || node.kind == ExpressionKind::list ||
        node.kind == ExpressionKind::element ||
        (node.kind == ExpressionKind::name && definition != nullptr && !definition->function) ||
        calls_let(node, scope) || calls_special(node, scope);
    if (!may_be_compound) {
        return std::nullopt;
    }
    Value value = evaluate_any(tree, id, scope, context);
    return value.expr.valid() ? std::nullopt : std::optional(std::move(value));
}

}  // namespace balcony::lang
