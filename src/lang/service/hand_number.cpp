// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/service/hand_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lang/names/evaluate.hpp"

namespace balcony::lang {

namespace {

constexpr int deepest = 100;  // Of lets in lets.

double at(expr::Expr formula, double hand) {
    const std::array inputs{expr::InputValue{hand_input(), hand}};
    return expr::evaluate(std::array{formula}, {.inputs = inputs}).front();
}

const Argument* argument_named(const Expression& call, std::string_view name) {
    const auto found =
        std::find_if(call.arguments.begin(), call.arguments.end(),
                     [&](const Argument& one) { return one.name && one.name->text == name; });
    return found != call.arguments.end() ? &*found : nullptr;
}

}  // namespace

std::string_view hand_input() { return "hand"; }

// Newton's iteration, with halved steps where the formula has no value.
std::optional<double> leaf_for(const HandNumber& number, double value) {
    const expr::Expr slope =
        expr::differentiate(number.formula, number.formula.graph().input(hand_input()));
    double leaf = number.leaf->value;
    double miss = at(number.formula, leaf) - value;
    const double most = 1e-12 * (1.0 + std::abs(value));
    for (int i = 0; i < 60 && std::abs(miss) > most; ++i) {
        double step = -miss / at(slope, leaf);
        double after = at(number.formula, leaf + step) - value;
        for (int k = 0; k < 40 && !(std::abs(after) < std::abs(miss)); ++k) {
            step *= 0.5;
            after = at(number.formula, leaf + step) - value;
        }
        if (!(std::abs(after) < std::abs(miss))) {
            break;
        }
        leaf += step;
        miss = after;
    }
    // What rounding leaves of the formula.
    const bool is_met = std::abs(miss) <= 1e-9 * (1.0 + std::abs(value));
    return is_met ? std::optional(leaf) : std::nullopt;
}

// A number that is read: the leaf that was found, and whether there are several.
struct HandNumbers::Reading {
    std::optional<HandLeaf> leaf{};
    bool moves = true;
    int depth = 0;
};

HandNumbers::HandNumbers(const KnownText& text, const LocatedDefinition& written,
                         const LocatedDefinition& place, DefinitionScope& scope)
    : text_(text),
      written_(written),
      place_(place),
      tree_(place.module->tree),
      scope_(scope),
      parameters_(scope.values()) {}

std::optional<HandNumber> HandNumbers::read(ExpressionId id, const camera::Range& limits) {
    const Value value = evaluate(tree_, id, scope_.names(), text_.session->context());
    if (value.failed()) {
        return std::nullopt;
    }
    HandNumber made;
    made.number.limits = limits;
    made.number.is_angle = value.is_angle();
    made.number.value = expr::evaluate(std::array{value.expr}, {}).front();
    if (!std::isfinite(made.number.value)) {
        return std::nullopt;
    }
    Reading reading;
    made.formula = formula(id, true, reading);
    if (!value.is_constant() || !reading.moves || !reading.leaf || !made.formula.valid()) {
        return made;
    }
    made.leaf = reading.leaf;
    made.number.moves = true;
    made.number.parameter = reading.leaf->parameter;
    made.number.begin = reading.leaf->literal.begin;
    made.number.end = reading.leaf->literal.end;
    return made;
}

ExpressionId HandNumbers::named_by(ExpressionId id) const {
    for (int i = 0; i < deepest && tree_[id].kind == ExpressionKind::name; ++i) {
        const LetSyntax* const let = let_named(tree_[id].name.text);
        if (let == nullptr || !let->value.valid() || !let->parameters.empty()) {
            break;
        }
        id = let->value;
    }
    return id;
}

bool HandNumbers::has_names(ExpressionId id) const {
    for (std::size_t i = tree_[id].first.value(); i <= id.value(); ++i) {
        const Expression& node = tree_.expressions[i];
        if (node.kind == ExpressionKind::name && node.name.text != "pi") {
            return true;
        }
    }
    return false;
}

const LetSyntax* HandNumbers::let_named(std::string_view name) const {
    const auto is_it = [&](const Statement& statement) {
        return statement.kind == StatementKind::let && statement.let().name.text == name;
    };
    for (const Statement& statement : place_.camera->statements) {
        if (is_it(statement)) {
            return &statement.let();
        }
    }
    for (const Item& item : tree_.items) {
        const auto* const statement = std::get_if<Statement>(&item);
        if (statement != nullptr && is_it(*statement)) {
            return &statement->let();
        }
    }
    return nullptr;
}

expr::Expr HandNumbers::of_leaf(HandLeaf leaf, Reading& reading) {
    reading.moves = reading.moves && (!reading.leaf || *reading.leaf == leaf);
    reading.leaf = std::move(leaf);
    return text_.session->graph()->input(hand_input());
}

ExpressionId HandNumbers::written_value(std::size_t parameter) const {
    const DefinitionParameter& declared = place_.camera->parameters[parameter];
    const DefinitionSyntax& definition = *written_.camera;
    if (written_.module != text_.module) {
        return {};
    }
    if (!definition.base.valid()) {
        return declared.default_value;
    }
    const Argument* const given = argument_named(text_.tree()[definition.base], declared.name.text);
    return given != nullptr ? given->value : ExpressionId();
}

HandLeaf HandNumbers::parameter_leaf(std::size_t parameter) const {
    const Value& value = parameters_[parameter];
    HandLeaf leaf{std::string(place_.camera->parameters[parameter].name.text),
                  {},
                  value.constant(),
                  value.is_angle()};
    if (const ExpressionId written = written_value(parameter); written.valid()) {
        leaf.literal = text_.tree()[written].span;
    }
    return leaf;
}

expr::Expr HandNumbers::of_name(const Expression& node, Reading& reading) {
    const std::string_view name = node.name.text;
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
        if (place_.camera->parameters[i].name.text == name) {
            return parameters_[i].is_constant() ? of_leaf(parameter_leaf(i), reading)
                                                : expr::Expr();
        }
    }
    if (const LetSyntax* const let = let_named(name)) {
        return let->value.valid() && let->parameters.empty() ? formula(let->value, true, reading)
                                                             : expr::Expr();
    }
    // What is imported, and pi.
    const Definition* const known = scope_.names().find(name);
    return known != nullptr && !known->function && known->value.is_constant() ? known->value.expr
                                                                              : expr::Expr();
}

// The number as a formula of what moves it; none where it calls what files define.
expr::Expr HandNumbers::formula(ExpressionId id, bool is_whole, Reading& reading) {
    const Expression& node = tree_[id];
    // Numbers beside names are constants, others are all of the literal.
    if (is_whole && is_of_text() && !has_names(id)) {
        const Value value = evaluate(tree_, id, scope_.names(), text_.session->context());
        return value.is_constant()
                   ? of_leaf({{}, node.span, value.constant(), value.is_angle()}, reading)
                   : expr::Expr();
    }
    if (reading.depth >= deepest) {
        return {};
    }
    ++reading.depth;
    expr::Expr made;
    if (node.kind == ExpressionKind::name) {
        made = of_name(node, reading);
    } else if (node.kind == ExpressionKind::number) {
        made = text_.session->graph()->constant(
            node.value * (node.unit == NumberUnit::degrees ? radians_per_degree : 1.0));
    } else if (node.kind == ExpressionKind::operation || node.kind == ExpressionKind::call) {
        const Function* const function = node.kind == ExpressionKind::operation
                                             ? find_operator(node.name.text, node.arguments.size())
                                             : find_function(node.name.text);
        std::vector<expr::Expr> arguments;
        for (const Argument& argument : node.arguments) {
            arguments.push_back(formula(argument.value, false, reading));
        }
        const bool is_known = function != nullptr && !function->takes_compound() &&
                              function->arity == arguments.size() &&
                              std::all_of(arguments.begin(), arguments.end(),
                                          [](expr::Expr one) { return one.valid(); });
        made = is_known ? function->apply(arguments, function->op) : expr::Expr();
    }
    --reading.depth;
    return made;
}

}  // namespace balcony::lang
