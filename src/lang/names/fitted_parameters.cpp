// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/names/fitted_parameters.hpp"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "lang/names/definition_scope.hpp"
#include "lang/names/evaluate.hpp"
#include "lang/names/scene_names.hpp"

namespace balcony::lang {

FittedParameters::FittedParameters(const LocatedDefinition& place, Scope& names, Session& session)
    : place_(place), tree_(place.module->tree), session_(session), scene_names_(&names) {
    const std::set<std::string_view> parameters = parameter_names(*place.camera);
    for (const Statement& statement : place.camera->statements) {
        if (statement.kind == StatementKind::fitted && !statement.broken) {
            for (const Assignment& assignment : statement.assignments()) {
                read(assignment, parameters);
            }
        }
    }
    if (!entries_.empty()) {
        define_scene_names(session.scene().value_or(SceneMeasures()), axes(), *session.graph(),
                           scene_names_);
    }
}

void FittedParameters::read(const Assignment& assignment,
                            const std::set<std::string_view>& parameters) {
    for (std::size_t i = 0; i < assignment.names.size(); ++i) {
        const Identifier& name = assignment.names[i];
        if (parameters.contains(name.text)) {
            add(assignment, i);
        } else if (!place_.camera->broken) {
            session_.reporter().missing(
                name.text, tree_.at(name.span),
                fmt::format("the {} '{}' has no parameter '{}' that fit could set",
                            word_for(*place_.camera), place_.camera->name.text, name.text),
                [&] { return instead_of_parameter(*place_.camera, name.text); });
        }
    }
}

void FittedParameters::add(const Assignment& assignment, std::size_t index) {
    const Identifier& name = assignment.names[index];
    const auto [earlier, is_new] = entries_.try_emplace(name.text, Entry{&assignment, index});
    if (!is_new) {
        const Entry& first = earlier->second;
        Diagnostic diagnostic = error(fmt::format("'{}' is fitted twice", name.text),
                                      tree_.at(name.span), "remove one of the two");
        diagnostic.notes.push_back(
            {tree_.at(first.assignment->names[first.index].span), "first fitted here"});
        session_.reporter().add(std::move(diagnostic));
    }
}

// A picture has z up; a camera says it.
Axes FittedParameters::axes() const {
    const auto& statements = place_.camera->statements;
    const bool y_up =
        std::any_of(statements.begin(), statements.end(), [](const Statement& statement) {
            return statement.kind == StatementKind::axes && !statement.broken &&
                   statement.word().text == "y_up";
        });
    return y_up ? Axes::y_up : Axes::z_up;
}

// Whether the position is fitted to that of someone who stands in the scene.
bool FittedParameters::stands() const {
    const auto px = entries_.find("px");
    if (px == entries_.end() || axes() != Axes::z_up) {
        return false;
    }
    const Expression& place = tree_[px->second.assignment->value];
    return place.kind == ExpressionKind::name && place.name.text == "scene_inside";
}

std::optional<double> FittedParameters::look_of(std::string_view name) const {
    const bool looks = session_.scene() && session_.scene()->look && stands();
    const SceneMeasures::Look look = looks ? *session_.scene()->look : SceneMeasures::Look{};
    return !looks            ? std::nullopt
           : name == "yaw"   ? std::optional(look.yaw)
           : name == "pitch" ? std::optional(look.pitch)
           : name == "roll"  ? std::optional(look.roll)
                             : std::nullopt;
}

bool FittedParameters::follows_place(std::string_view name) const {
    const auto found = entries_.find(name);
    if (found == entries_.end()) {
        return look_of(name).has_value();
    }
    const ExpressionId value = found->second.assignment->value;
    const std::size_t first = tree_[value].first.value();
    const auto nodes = std::span(tree_.expressions).subspan(first, value.value() + 1 - first);
    return std::any_of(nodes.begin(), nodes.end(), [](const Expression& node) {
        return node.kind == ExpressionKind::name && node.name.text == "scene_inside";
    });
}

std::optional<FittedParameters::Fitted> FittedParameters::find(std::string_view name) {
    if (const std::optional<double> angle = look_of(name)) {
        Value value{session_.graph()->constant(*angle)};
        value.unit = Unit::angle;
        return Fitted{std::move(value), tree_.at(place_.camera->name.span)};
    }
    const auto found = entries_.find(name);
    if (found == entries_.end()) {
        return std::nullopt;
    }
    const auto& [assignment, index] = found->second;
    const SourceSpan place = tree_.at(tree_[assignment->value].span);
    const Value value = evaluate_any(tree_, assignment->value, scene_names_, session_.context());
    if (value.failed() || !assignment->is_tuple) {
        return Fitted{value, place};
    }
    const std::size_t count = assignment->names.size();
    if (value.form != Value::Form::tuple || value.elements->size() != count) {
        session_.reporter().error(
            place, fmt::format("{} names are fitted, but this is {}", count, form_of(value)),
            "write as many numbers in parentheses, for example (px, py, pz) = scene_inside");
        return Fitted{{}, place};
    }
    return Fitted{(*value.elements)[index].value, place};
}

}  // namespace balcony::lang
