// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/camera_scope.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "lang/evaluate.hpp"

namespace balcony::lang {

CameraScope::CameraScope(const CameraPlace& place, const std::vector<Override>& overrides,
                         Session& session)
    : place_(place),
      tree_(place.module->tree),
      session_(session),
      scope_(place.module->scope.get()) {
    read_overrides(overrides);
    std::vector<const Statement*> lets;
    for (const Statement& statement : place.camera->statements) {
        if (statement.kind == StatementKind::let) {
            lets.push_back(&statement);
            scope_.announce(statement.name.text,
                            "it is a let in the camera's body; a default may use only the "
                            "parameters before it and lets outside of cameras");
        }
    }
    define_parameters();
    define_lets(tree_, lets, scope_, *session.graph(), session.reporter());
}

void CameraScope::read_overrides(const std::vector<Override>& overrides) {
    std::vector<std::string> known;
    for (const CameraParameter& parameter : place_.camera->parameters) {
        known.emplace_back(parameter.name.text);
    }
    for (const Override& given : overrides) {
        const auto source = std::make_shared<const SourceText>(
            "--set", fmt::format("{}={}", given.name, given.expression));
        if (std::find(known.begin(), known.end(), given.name) == known.end()) {
            session_.reporter().error({source, 0, given.name.size()},
                                      fmt::format("the camera '{}' has no parameter '{}'",
                                                  place_.camera->name.text, given.name),
                                      known.empty()
                                          ? "it has no parameters"
                                          : suggestion(given.name, known, "its parameters are"));
            continue;
        }
        const std::size_t errors_before = session_.reporter().error_count();
        const SyntaxTree& tree = session_.keep(parse_override(source, session_.reporter()));
        const bool good = session_.reporter().error_count() == errors_before;
        const std::string_view name = tree.source->text().substr(0, given.name.size());
        given_.push_back({name, good ? &tree : nullptr});
    }
}

void CameraScope::define_parameters() {
    for (const CameraParameter& parameter : place_.camera->parameters) {
        scope_.announce(parameter.name.text,
                        "a default may use only the parameters before it and lets outside of "
                        "cameras");
    }
    for (const CameraParameter& parameter : place_.camera->parameters) {
        define_parameter(parameter);
    }
}

void CameraScope::define_parameter(const CameraParameter& parameter) {
    const std::string_view name = parameter.name.text;
    Value value;
    if (parameter.default_value.valid()) {
        value = evaluate(tree_, parameter.default_value, scope_, *session_.graph(),
                         session_.reporter());
    }
    // The last one given counts, as is usual for options.
    const auto given = std::find_if(given_.rbegin(), given_.rend(),
                                    [name](const Given& one) { return one.name == name; });
    if (given != given_.rend()) {
        value = overridden(*given, value, name);
    }
    const SourceSpan place = tree_.at(parameter.name.span);
    if (!scope_.define(name, {value, place, "parameter", false})) {
        report_duplicate(parameter.name, place, scope_.find_here(name)->place, session_.reporter());
    }
}

Value CameraScope::overridden(const Given& given, const Value& default_value,
                              std::string_view name) {
    if (given.tree == nullptr) {
        return {};
    }
    const ExpressionId id(given.tree->expressions.size() - 1);
    const Value value = evaluate(*given.tree, id, scope_, *session_.graph(), session_.reporter());
    if (value.failed() || default_value.failed()) {
        return value;
    }
    const SourceSpan span = given.tree->at((*given.tree)[id].span);
    if (default_value.is_angle() && value.is_plain_number()) {
        session_.reporter().error(span,
                                  fmt::format("'{}' is an angle, but this is a plain number", name),
                                  "attach deg or rad: 30deg, 0.5rad");
        return {};
    }
    if (default_value.is_plain_number() && value.is_angle()) {
        session_.reporter().error(span,
                                  fmt::format("'{}' is a plain number, but this is an angle", name),
                                  "leave out deg or rad");
        return {};
    }
    return value;
}

void CameraScope::warn_of_unused() {
    const auto warn = [this](const Identifier& name, std::string_view what) {
        const Definition* definition = scope_.find_here(name.text);
        if (definition != nullptr && !definition->used) {
            session_.reporter().warning(tree_.at(name.span),
                                        fmt::format("the {} '{}' is not used", what, name.text));
        }
    };
    for (const CameraParameter& parameter : place_.camera->parameters) {
        warn(parameter.name, "parameter");
    }
    for (const Statement& statement : place_.camera->statements) {
        if (statement.kind == StatementKind::let) {
            warn(statement.name, "let");
        }
    }
}

}  // namespace balcony::lang
