// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/names/definition_scope.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "camera/catalogue/parameter_text.hpp"
#include "lang/names/evaluate.hpp"
#include "lang/names/parameter_limits.hpp"
#include "lang/names/unused_names.hpp"

namespace balcony::lang {

std::string_view word_for(const DefinitionSyntax& camera) {
    return camera.is_picture ? "picture" : "camera";
}

std::set<std::string_view> parameter_names(const DefinitionSyntax& camera) {
    std::set<std::string_view> names;
    for (const DefinitionParameter& parameter : camera.parameters) {
        names.insert(parameter.name.text);
    }
    return names;
}

std::string no_parameter(const LocatedDefinition& place, std::string_view name) {
    return fmt::format("the {} '{}' has no parameter '{}'", word_for(*place.camera), place.name(),
                       name);
}

std::string instead_of_parameter(const DefinitionSyntax& camera, std::string_view name) {
    std::vector<std::string> known;
    for (const DefinitionParameter& parameter : camera.parameters) {
        known.emplace_back(parameter.name.text);
    }
    return known.empty() ? "it has no parameters" : suggestion(name, known, "its parameters are");
}

namespace {

// Whether a statement that was not read may have defined a name.
bool lacks_names(const std::vector<Statement>& statements) {
    return std::any_of(statements.begin(), statements.end(), [](const Statement& statement) {
        return statement.kind == StatementKind::unknown ||
               (statement.kind == StatementKind::let && statement.let().name.text.empty());
    });
}

}  // namespace

DefinitionScope::DefinitionScope(const LocatedDefinition& place, const GivenParameters& given,
                                 Session& session)
    : place_(place),
      tree_(place.module->tree),
      session_(session),
      scope_(place.module->scope.get()),
      fitted_(place, scope_, session),
      parameters_(lang::parameter_names(*place.camera)),
      open_(given.open.begin(), given.open.end()) {
    if (place.camera->broken || lacks_names(place.camera->statements)) {
        scope_.mark_incomplete();
    }
    read_overrides(given.overrides);
    read_values(given.values);
    std::vector<const Statement*> lets;
    for (const Statement& statement : place.camera->statements) {
        if (statement.kind == StatementKind::let) {
            lets.push_back(&statement);
            scope_.announce(statement.let().name.text,
                            "it is a let in the camera's body, but a default may use only the "
                            "parameters before it and lets outside of cameras");
        }
    }
    define_parameters();
    define_lets(tree_, lets, scope_, session.context());
}

void DefinitionScope::read_overrides(const std::vector<Override>& overrides) {
    for (const Override& given : overrides) {
        const auto source = std::make_shared<const SourceText>(
            "--set", fmt::format("{}={}", given.name, given.expression));
        if (!parameters_.contains(given.name)) {
            session_.reporter().error(
                {source, 0, given.name.size()}, no_parameter(place_, given.name),
                [&] { return instead_of_parameter(*place_.camera, given.name); });
            continue;
        }
        const std::size_t errors_before = session_.reporter().error_count();
        const SyntaxTree& tree =
            session_.keep(parse_override(source, session_.catalogue(), session_.reporter()));
        const bool good = session_.reporter().error_count() == errors_before;
        const std::string_view name = tree.source->text().substr(0, given.name.size());
        overrides_.insert_or_assign(name, good ? &tree : nullptr);
    }
}

void DefinitionScope::read_values(const std::vector<ParameterValue>& values) {
    for (const ParameterValue& value : values) {
        values_.try_emplace(value.name.text, &value);
        if (!place_.camera->broken && !parameters_.contains(value.name.text)) {
            session_.reporter().error(value.name_place, no_parameter(place_, value.name.text), [&] {
                return instead_of_parameter(*place_.camera, value.name.text);
            });
        }
    }
}

void DefinitionScope::define_parameters() {
    for (const DefinitionParameter& parameter : place_.camera->parameters) {
        scope_.announce(parameter.name.text,
                        "a default may use only the parameters before it and lets outside of "
                        "cameras");
    }
    for (const DefinitionParameter& parameter : place_.camera->parameters) {
        define_parameter(parameter);
    }
}

void DefinitionScope::define_parameter(const DefinitionParameter& parameter) {
    const std::string_view name = parameter.name.text;
    Value value;
    SourceSpan written = tree_.at(parameter.name.span);
    if (parameter.default_value.valid()) {
        value = evaluate_any(tree_, parameter.default_value, scope_, session_.context());
        written = tree_.at(tree_[parameter.default_value].span);
    }
    value = fitted(value, parameter);
    if (const auto given = values_.find(name); given != values_.end()) {
        written = given->second->value_place;
        value = checked(given->second->value, written, value, name);
    }
    if (const auto given = overrides_.find(name); given != overrides_.end()) {
        value = overridden(given->second, value, name, written);
    }
    value = within_limits(value, written, place_, parameter, session_);
    if (session_.scene() && fitted_.contains(name)) {
        session_.note_fitted(place_.name(), name, value, fitted_.follows_place(name));
    }
    if (open_.contains(name)) {
        value = opened(value, name);
    }
    const SourceSpan place = tree_.at(parameter.name.span);
    if (!scope_.define(name, {value, place, "parameter", false})) {
        report_duplicate(parameter.name, place, scope_.find_here(name)->place, session_.reporter());
    }
}

// The value in the scene that the session fits cameras to, unless it is beyond the limits of the
// parameter. Without a scene, a fit statement is only checked.
Value DefinitionScope::fitted(const Value& default_value, const DefinitionParameter& parameter) {
    const std::string_view name = parameter.name.text;
    const auto found = fitted_.find(name);
    if (!found) {
        return default_value;
    }
    const Value value = checked(found->value, found->place, default_value, name);
    const bool is_taken =
        session_.scene() &&
        (!value.is_constant() ||
         camera::contains(limits_of(place_, parameter, session_), value.constant()));
    return is_taken || value.failed() ? value : default_value;
}

// An input in the place of a number that does not change.
Value DefinitionScope::opened(const Value& value, std::string_view name) {
    if (!value.is_constant()) {
        return value;
    }
    const std::string input = parameter_input(name);
    session_.inputs().push_back({input, value.constant()});
    Value made = value;
    made.expr = session_.graph()->input(input);
    return made;
}

Value DefinitionScope::overridden(const SyntaxTree* tree, const Value& default_value,
                                  std::string_view name, SourceSpan& written) {
    if (tree == nullptr) {
        return {};
    }
    const ExpressionId id(tree->expressions.size() - 1);
    const Value value = evaluate_any(*tree, id, scope_, session_.context());
    written = tree->at((*tree)[id].span);
    return checked(value, written, default_value, name);
}

// A value with the same form and unit as the default. Otherwise an error is reported and the value
// has failed. Lists may have any length and units; the stage that takes them checks these.
Value DefinitionScope::checked(const Value& value, const SourceSpan& span,
                               const Value& default_value, std::string_view name) {
    if (value.failed() || default_value.failed()) {
        return value;
    }
    if (form_of(value) != form_of(default_value)) {
        session_.reporter().error(span,
                                  fmt::format("'{}' must be {}, but this is {}", name,
                                              form_of(default_value), form_of(value)),
                                  "write it in the same form as the parameter's default");
        return {};
    }
    if (value.form == Value::Form::tuple) {
        for (std::size_t i = 0; i < value.elements->size(); ++i) {
            const Element& element = (*value.elements)[i];
            if (checked(element.value, element.place, (*default_value.elements)[i].value, name)
                    .failed()) {
                return {};
            }
        }
        return value;
    }
    if (default_value.unit == Unit::angle && value.is_plain_number()) {
        session_.reporter().error(
            span, fmt::format("'{}' must be an angle, but this is a plain number", name),
            "append deg or rad: 30deg, 0.5rad");
        return {};
    }
    if (default_value.is_plain_number() && value.is_angle()) {
        session_.reporter().error(
            span, fmt::format("'{}' must be a plain number, but this is an angle", name),
            "remove deg or rad");
        return {};
    }
    return value;
}

std::vector<Value> DefinitionScope::values() {
    std::vector<Value> all;
    for (const DefinitionParameter& parameter : place_.camera->parameters) {
        all.push_back(scope_.find_here(parameter.name.text)->value);
    }
    return all;
}

void DefinitionScope::warn_of_unused() {
    if (place_.derived != nullptr) {
        return;
    }
    const auto warn = [this](const Identifier& name, std::string_view what) {
        const Definition* definition = scope_.find_here(name.text);
        if (definition != nullptr && !definition->used) {
            lang::warn_of_unused(tree_, name, what, session_.reporter());
        }
    };
    for (const DefinitionParameter& parameter : place_.camera->parameters) {
        warn(parameter.name, "parameter");
    }
    for (const Statement& statement : place_.camera->statements) {
        if (statement.kind == StatementKind::let) {
            warn(statement.let().name, word_for(statement.let()));
            warn_of_unused_parameters(tree_, statement.let(), session_.reporter());
        } else if (statement.kind == StatementKind::loop) {
            warn_of_unused_in_loop(tree_, statement, session_.reporter());
        }
    }
}

}  // namespace balcony::lang
