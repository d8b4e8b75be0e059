// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/service/descriptions.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/make_stage.hpp"
#include "balcony/operations.hpp"
#include "camera/catalogue/stage_text.hpp"
#include "lang/names/definition_scope.hpp"
#include "lang/names/function_calls.hpp"
#include "lang/names/unused_names.hpp"
#include "lang/names/value.hpp"
#include "lang/service/stage_call.hpp"

namespace balcony::lang {

std::string parameter_text(const camera::StageParameter& parameter) {
    const std::string built_in = camera::default_text(parameter);
    const std::string range = camera::range_text(parameter);
    return fmt::format("{}{}: {}{}{}", parameter.name, built_in.empty() ? "" : " = " + built_in,
                       camera::type_text(parameter), range.empty() ? "" : ", " + range,
                       parameter.optional ? ", optional" : "");
}

std::string meaning_of(const StatementRow& row) {
    if (!row.meaning.empty()) {
        return std::string(row.meaning);
    }
    return row.stage_kind ? camera::with_article(camera::name_of(*row.stage_kind)) : std::string();
}

std::string declaration_text(const SyntaxTree& tree, const DefinitionParameter& parameter) {
    const std::string_view value =
        parameter.default_value.valid() ? tree.text(tree[parameter.default_value].span) : "";
    const std::string_view limits = tree.text(parameter.limits);
    return fmt::format("{}{}{}{}{}", parameter.name.text, value.empty() ? "" : " = ", value,
                       limits.empty() ? "" : " ", limits);
}

std::string signature_of(const SyntaxTree& tree, const DefinitionSyntax& camera) {
    if (camera.base.valid()) {
        return fmt::format("{} {} = {}", word_for(camera), camera.name.text,
                           tree.text(tree[camera.base].span));
    }
    std::vector<std::string> parameters;
    for (const DefinitionParameter& parameter : camera.parameters) {
        parameters.push_back(declaration_text(tree, parameter));
    }
    return fmt::format("{} {}{}{}{}", word_for(camera), camera.name.text,
                       parameters.empty() ? "" : "(", fmt::join(parameters, ", "),
                       parameters.empty() ? "" : ")");
}

std::string signature_of(const SyntaxTree& tree, const OwnName& own) {
    switch (own.kind) {
        case OwnKind::camera: return signature_of(tree, *own.definition);
        case OwnKind::parameter: return declaration_text(tree, *own.parameter);
        case OwnKind::variable: return fmt::format("for {}", own.name.text);
        default: return std::string(tree.text(own.declaration));
    }
}

std::string_view first_line(std::string_view text) {
    if (!text.starts_with("// ")) {
        return {};
    }
    return text.substr(3, text.find('\n') - 3);
}

std::string function_signature(std::string_view name) {
    const Function* function = find_function(name);
    if (function == nullptr) {
        return name == keys_function   ? "keys((time, value), ..., ease = linear)"
               : name == grey_function ? "grey(\"image.png\", x, y)"
                                       : std::string(name);
    }
    return call_of(name, function->arity);
}

std::string_view function_meaning(std::string_view name) {
    if (name == "pi") {
        return "3.14159...";
    }
    if (name == "t") {
        return "the time in seconds";
    }
    const Function* function = find_function(name);
    return function == nullptr || function->takes_compound()
               ? std::string_view()
               : expr::operation(function->op).meaning;
}

}  // namespace balcony::lang
