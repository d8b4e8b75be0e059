// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/stages.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "lang/evaluate.hpp"

namespace balcony::lang {

namespace {

using camera::Arguments;
using camera::ParameterType;
using camera::Scalar;
using camera::StageEntry;
using camera::StageKind;
using camera::StageParameter;
using camera::Unit;

// The statements that stages of a kind belong to.
std::string_view statement_for(StageKind kind) {
    switch (kind) {
        case StageKind::picture_arranger: return "place";
        case StageKind::picture_mapper: return "map";
        case StageKind::parameter_transformer: return "warp";
        case StageKind::object_generator: return "eye', 'toward' and 'object";
        case StageKind::object_transformer: return "move";
        case StageKind::direction_rule: return "look";
    }
    return {};
}

std::string_view article(StageKind kind) {
    return camera::name_of(kind).starts_with('o') ? "an" : "a";
}

std::vector<std::string> names_of_kind(StageKind kind) {
    std::vector<std::string> names;
    for (const StageEntry& row : camera::catalogue()) {
        if (row.kind == kind) {
            names.emplace_back(row.name);
        }
    }
    return names;
}

std::size_t count_of(ParameterType type) {
    switch (type) {
        case ParameterType::pair:
        case ParameterType::size: return 2;
        case ParameterType::triple:
        case ParameterType::axis: return 3;
        default: return 1;
    }
}

// A number as a user would write it.
std::string written(double value, Unit unit) {
    if (unit == Unit::angle) {
        return fmt::format("{:.6g}deg", value * 180.0 / std::numbers::pi);
    }
    return fmt::format("{:.6g}", value);
}

std::string range_text(const StageParameter& parameter) {
    const bool has_least = std::isfinite(parameter.least);
    const bool has_most = std::isfinite(parameter.most);
    const std::string least = written(parameter.least, parameter.unit);
    const std::string most = written(parameter.most, parameter.unit);
    const char* from = parameter.above_least ? "above" : "at least";
    if (has_least && has_most) {
        return parameter.above_least ? fmt::format("above {} and at most {}", least, most)
                                     : fmt::format("from {} to {}", least, most);
    }
    return has_least ? fmt::format("{} {}", from, least) : fmt::format("at most {}", most);
}

std::string formula_signature(const StageEntry& row) {
    static constexpr std::array<std::string_view, 3> space = {"x", "y", "z"};
    static constexpr std::array<std::string_view, 2> parameter = {"u", "v"};
    std::string names;
    for (std::size_t i = 0; i < row.formula->parameters; ++i) {
        const bool in_space = row.formula->parameters > parameter.size();
        names += fmt::format("{}{}", i == 0 ? "" : ", ",
                             in_space ? space[std::min(i, space.size() - 1)] : parameter[i]);
    }
    static constexpr std::array<std::string_view, 4> forms = {"[]", "[a]", "[a, b]", "[a, b, c]"};
    const auto form = [](std::size_t count) { return forms[std::min(count, forms.size() - 1)]; };
    std::string text = fmt::format("{}({}) = {}", row.name, names,
                                   form(row.formula->results_least));
    if (row.formula->results_most > row.formula->results_least) {
        text += fmt::format(" or {}", form(row.formula->results_most));
    }
    return text;
}

std::string numbers_in_words(std::size_t least, std::size_t most) {
    return least == most ? fmt::format("{}", least) : fmt::format("{} or {}", least, most);
}

}  // namespace

std::string signature(const StageEntry& row) {
    if (row.formula) {
        return formula_signature(row);
    }
    std::string text = fmt::format("{}(", row.name);
    for (const StageParameter& parameter : row.parameters) {
        text += fmt::format("{}{}", &parameter == &row.parameters.front() ? "" : ", ",
                            parameter.name);
    }
    return text + ")";
}

// ------------------------------------------------------------------------------- the whole stage

StageBuilder::Stage StageBuilder::make_stage(StageKind kind, ExpressionId call) {
    const Expression& node = tree_[call];
    const StageEntry* row = find_row(kind, node.name);
    if (row == nullptr) {
        return nullptr;
    }
    Arguments arguments;
    if (row->formula) {
        std::optional<camera::Formula> made = formula(*row, node);
        if (!made) {
            return nullptr;
        }
        arguments.set_formula(std::move(*made));
        return make_from_row(*row, arguments, node.name.span);
    }
    if (node.kind == ExpressionKind::formula) {
        error(node.span, fmt::format("'{}' is not made from a formula", row->name),
              fmt::format("it is written {}", signature(*row)));
        return nullptr;
    }
    std::vector<ExpressionId> given(row->parameters.size());
    bool good = assign(*row, node, given);
    for (std::size_t i = 0; i < given.size(); ++i) {
        const StageParameter& parameter = row->parameters[i];
        if (given[i].valid()) {
            good = set_argument(*row, parameter, given[i], arguments) && good;
        } else if (good) {
            good = set_default(*row, parameter, node.name.span, arguments);
        }
    }
    return good ? make_from_row(*row, arguments, node.span) : nullptr;
}

StageBuilder::Stage StageBuilder::make_from_row(const StageEntry& row, const Arguments& arguments,
                                                Span span) {
    Result<Stage> made = row.make(arguments);
    for (Diagnostic& diagnostic : made.diagnostics) {
        if (!diagnostic.span.source) {
            diagnostic.span = tree_.at(span);
        }
        reporter_.add(std::move(diagnostic));
    }
    return made ? *made : nullptr;
}

const StageEntry* StageBuilder::find_row(StageKind kind, const Identifier& name) {
    if (const StageEntry* row = camera::find_stage(kind, name.text)) {
        return row;
    }
    for (const StageEntry& row : camera::catalogue()) {
        if (row.name == name.text) {
            error(name.span,
                  fmt::format("'{}' is {} {}, but this is the place of {} {}", name.text,
                              article(row.kind), camera::name_of(row.kind), article(kind),
                              camera::name_of(kind)),
                  fmt::format("{}s belong to '{}'", camera::name_of(row.kind),
                              statement_for(row.kind)));
            return nullptr;
        }
    }
    error(name.span, fmt::format("there is no {} named '{}'", camera::name_of(kind), name.text),
          suggestion(name.text, names_of_kind(kind), "there are"));
    return nullptr;
}

// --------------------------------------------------------------------------------- its arguments

// Finds out which parameter each argument is for.
bool StageBuilder::assign(const StageEntry& row, const Expression& call,
                          std::vector<ExpressionId>& given) {
    bool good = true;
    bool named = false;
    std::size_t position = 0;
    for (const Argument& argument : call.arguments) {
        const Span span = tree_[argument.value].span;
        const StageParameter* parameter = nullptr;
        if (argument.name) {
            named = true;
            parameter = named_parameter(row, *argument.name);
        } else if (named) {
            error(span, "an argument without a name stands behind one with a name",
                  fmt::format("arguments come in the order of {}, or with their names",
                              signature(row)));
        } else if (position < row.parameters.size()) {
            parameter = &row.parameters[position++];
        } else {
            error(span,
                  fmt::format("'{}' takes {} argument{}, but is given {}", row.name,
                              row.parameters.size(), row.parameters.size() == 1 ? "" : "s",
                              call.arguments.size()),
                  fmt::format("it is written {}", signature(row)));
            return false;
        }
        if (parameter == nullptr) {
            good = false;
            continue;
        }
        ExpressionId& slot = given[static_cast<std::size_t>(parameter - row.parameters.data())];
        if (slot.valid()) {
            Diagnostic diagnostic =
                balcony::error(fmt::format("'{}' is given twice", parameter->name),
                               tree_.at(argument.name ? argument.name->span : span));
            diagnostic.notes.push_back({tree_.at(tree_[slot].span), "it is given here first"});
            reporter_.add(std::move(diagnostic));
            good = false;
        } else {
            slot = argument.value;
        }
    }
    return good;
}

const StageParameter* StageBuilder::named_parameter(const StageEntry& row,
                                                    const Identifier& name) {
    std::vector<std::string> known;
    for (const StageParameter& parameter : row.parameters) {
        if (parameter.name == name.text) {
            return &parameter;
        }
        known.emplace_back(parameter.name);
    }
    error(name.span, fmt::format("'{}' has no argument '{}'", row.name, name.text),
          known.empty() ? fmt::format("'{}' takes no arguments", row.name)
                        : suggestion(name.text, known, "its arguments are"));
    return nullptr;
}

bool StageBuilder::set_default(const StageEntry& row, const StageParameter& parameter, Span call,
                               Arguments& arguments) {
    if (parameter.type == ParameterType::choice) {
        arguments.set(parameter.name, std::string(parameter.choices.front()));
        return true;
    }
    if (parameter.default_value.empty()) {
        error(call, fmt::format("'{}' is not given its '{}' ({})", row.name, parameter.name,
                                parameter.meaning),
              fmt::format("it is written {}", signature(row)));
        return false;
    }
    std::vector<Scalar> values(parameter.default_value.begin(), parameter.default_value.end());
    values.resize(count_of(parameter.type), values.back());
    arguments.set(parameter.name, std::move(values));
    return true;
}

bool StageBuilder::set_argument(const StageEntry& row, const StageParameter& parameter,
                                ExpressionId given, Arguments& arguments) {
    if (parameter.type == ParameterType::choice) {
        std::optional<std::string> word = choice(row, parameter, given);
        if (word) {
            arguments.set(parameter.name, std::move(*word));
        }
        return word.has_value();
    }
    if (parameter.type == ParameterType::curve) {
        camera::ObjectGeneratorPointer made = curve(row, parameter, given);
        if (made) {
            arguments.set(parameter.name, made);
        }
        return made != nullptr;
    }
    std::optional<std::vector<Scalar>> values = numbers(row, parameter, given);
    if (values) {
        arguments.set(parameter.name, std::move(*values));
    }
    return values.has_value();
}

std::optional<std::string> StageBuilder::choice(const StageEntry& row,
                                                const StageParameter& parameter,
                                                ExpressionId given) {
    const Expression& node = tree_[given];
    const std::vector<std::string> words(parameter.choices.begin(), parameter.choices.end());
    if (node.kind != ExpressionKind::name) {
        error(node.span, fmt::format("'{}' of '{}' is a word", parameter.name, row.name),
              fmt::format("write {}", one_of(words)));
        return std::nullopt;
    }
    if (std::find(words.begin(), words.end(), node.name.text) == words.end()) {
        error(node.span,
              fmt::format("'{}' of '{}' cannot be '{}'", parameter.name, row.name, node.name.text),
              suggestion(node.name.text, words, "it is"));
        return std::nullopt;
    }
    return std::string(node.name.text);
}

camera::ObjectGeneratorPointer StageBuilder::curve(const StageEntry& row,
                                                   const StageParameter& parameter,
                                                   ExpressionId given) {
    const Expression& node = tree_[given];
    if (node.kind != ExpressionKind::name && node.kind != ExpressionKind::call &&
        node.kind != ExpressionKind::formula) {
        error(node.span, fmt::format("'{}' of '{}' is a curve, but this is {}", parameter.name,
                                     row.name,
                                     node.kind == ExpressionKind::tuple ? "a tuple" : "a number"),
              "write a curve such as circle(1) or curve(u) = [cos(u), sin(u)]");
        return nullptr;
    }
    auto made = make<camera::ObjectGenerator>(StageKind::object_generator, given);
    if (made && made->dimension() != 1) {
        error(node.span,
              fmt::format("'{}' of '{}' is a curve, but '{}' is a {}", parameter.name, row.name,
                          node.name.text, made->dimension() == 0 ? "point" : "surface"));
        return nullptr;
    }
    return made;
}

// --------------------------------------------------------------------------------------- numbers

std::optional<std::vector<double>> StageBuilder::named_axis(const Expression& node) {
    const bool negative = node.kind == ExpressionKind::operation && node.name.text == "-" &&
                          node.arguments.size() == 1;
    const Expression& named = negative ? tree_[node.arguments[0].value] : node;
    const std::string_view axes = "xyz";
    if (named.kind != ExpressionKind::name || named.name.text.size() != 1 ||
        axes.find(named.name.text) == std::string_view::npos) {
        return std::nullopt;
    }
    std::vector<double> direction(3, 0.0);
    direction[axes.find(named.name.text)] = negative ? -1.0 : 1.0;
    return direction;
}

std::optional<std::vector<Scalar>> StageBuilder::numbers(const StageEntry& row,
                                                         const StageParameter& parameter,
                                                         ExpressionId given) {
    const Expression& node = tree_[given];
    const std::size_t count = count_of(parameter.type);
    if (parameter.type == ParameterType::axis) {
        if (const auto direction = named_axis(node)) {
            return std::vector<Scalar>(direction->begin(), direction->end());
        }
    }
    const bool one = node.kind != ExpressionKind::tuple;
    if (one && (count == 1 || parameter.type == ParameterType::size)) {
        const std::optional<Scalar> value = number(row, parameter, given);
        return value ? std::optional(std::vector<Scalar>(count, *value)) : std::nullopt;
    }
    if (one || node.arguments.size() != count) {
        const std::string form = count == 1   ? "one number"
                                 : count == 2 ? "two numbers, (a, b)"
                                              : "three numbers, (a, b, c)";
        error(node.span,
              fmt::format("'{}' of '{}' is {}{}{}, but {}", parameter.name, row.name, form,
                          parameter.type == ParameterType::axis ? ", or x, y or z" : "",
                          parameter.type == ParameterType::size ? ", or one for both" : "",
                          one ? "this is one number"
                              : fmt::format("these are {}", node.arguments.size())));
        return std::nullopt;
    }
    std::vector<Scalar> values;
    for (const Argument& element : node.arguments) {
        if (const std::optional<Scalar> value = number(row, parameter, element.value)) {
            values.push_back(*value);
        }
    }
    return values.size() == count ? std::optional(std::move(values)) : std::nullopt;
}

std::optional<Scalar> StageBuilder::number(const StageEntry& row, const StageParameter& parameter,
                                           ExpressionId given) {
    const Value value = evaluate(tree_, given, scope_, *graph_, reporter_);
    if (value.failed() || !fits(row, parameter, value, tree_[given].span)) {
        return std::nullopt;
    }
    if (value.is_constant()) {
        return Scalar(value.constant());
    }
    return Scalar(camera::Formula(graph_, {}, {value.expr}));
}

bool StageBuilder::fits(const StageEntry& row, const StageParameter& parameter, const Value& value,
                        Span span) {
    const std::string what = fmt::format("'{}' of '{}'", parameter.name, row.name);
    if (parameter.unit == Unit::number && value.is_angle()) {
        error(span, fmt::format("{} is a plain number, but this is an angle", what),
              "leave out deg or rad, or divide the angle by 1rad");
        return false;
    }
    if (parameter.unit == Unit::angle && value.is_plain_number()) {
        const bool literal = tree_.text(span).find_first_not_of("0123456789.") == std::string::npos;
        error(span, fmt::format("{} is an angle, but this is a plain number", what),
              literal ? fmt::format("write {0}deg or {0}rad", tree_.text(span))
                      : "multiply it by 1rad if it counts radians, by 1deg if degrees");
        return false;
    }
    if (!value.is_constant()) {
        return true;
    }
    const double number = value.constant();
    const bool too_small =
        parameter.above_least ? number <= parameter.least : number < parameter.least;
    if (too_small || number > parameter.most) {
        error(span, fmt::format("{} must be {}, but is {}", what, range_text(parameter),
                                written(number, parameter.unit)));
        return false;
    }
    return true;
}

camera::PictureMapperPointer StageBuilder::make_mapper(std::string_view name,
                                                       std::span<const ExpressionId> values,
                                                       Span span) {
    const StageEntry* row = camera::find_stage(StageKind::picture_mapper, name);
    assert(row != nullptr && row->parameters.size() == values.size());
    Arguments arguments;
    bool good = true;
    for (std::size_t i = 0; i < values.size(); ++i) {
        good = set_argument(*row, row->parameters[i], values[i], arguments) && good;
    }
    return good ? std::static_pointer_cast<const camera::PictureMapper>(
                      make_from_row(*row, arguments, span))
                : nullptr;
}

camera::DirectionRulePointer StageBuilder::make_default_rule(std::string_view name, Span span) {
    const StageEntry* row = camera::find_stage(StageKind::direction_rule, name);
    assert(row != nullptr);
    Arguments arguments;
    bool good = true;
    for (const StageParameter& parameter : row->parameters) {
        good = set_default(*row, parameter, span, arguments) && good;
    }
    return good ? std::static_pointer_cast<const camera::DirectionRule>(
                      make_from_row(*row, arguments, span))
                : nullptr;
}

std::optional<double> StageBuilder::constant(ExpressionId id, std::string_view what) {
    const Value value = evaluate(tree_, id, scope_, *graph_, reporter_);
    if (value.failed()) {
        return std::nullopt;
    }
    if (value.is_angle()) {
        error(tree_[id].span, fmt::format("{} is a plain number, but this is an angle", what));
        return std::nullopt;
    }
    if (!value.is_constant()) {
        error(tree_[id].span, fmt::format("{} cannot change with time", what));
        return std::nullopt;
    }
    return value.constant();
}

// -------------------------------------------------------------------------------------- formulas

std::optional<camera::Formula> StageBuilder::formula(const StageEntry& row,
                                                     const Expression& node) {
    const camera::FormulaShape& shape = *row.formula;
    if (node.kind != ExpressionKind::formula) {
        error(node.span, fmt::format("'{}' is made from a formula", row.name),
              fmt::format("it is written {}", signature(row)));
        return std::nullopt;
    }
    if (node.parameters.size() != shape.parameters) {
        error(node.name.span,
              fmt::format("the formula '{}' has {} parameter{}, but this one has {}", row.name,
                          shape.parameters, shape.parameters == 1 ? "" : "s",
                          node.parameters.size()),
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
            error(name.span, fmt::format("'{}' is taken: it is {}", name.text,
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
