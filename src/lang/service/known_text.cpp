// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/service/known_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "lang/names/value.hpp"

namespace balcony::lang {

using What = Expected::What;

KnownText::KnownText(std::shared_ptr<const SourceText> text, std::filesystem::path folder,
                     camera::Catalogue known)
    : source(std::move(text)),
      catalogue(std::move(known)),
      places(source),
      files(std::make_unique<Files>(catalogue)),
      session(std::make_unique<Session>(*files)),
      module(session->load(source, folder)),
      names(own_names(module->tree)) {}

std::optional<std::size_t> KnownText::word_at(std::size_t offset) const {
    std::size_t i = places.first_behind(offset);
    const bool begins_later = places[i].span.begin > offset || places[i].kind != TokenKind::name;
    if (begins_later && i > 0 && places[i - 1].span.end == offset) {
        --i;
    }
    const Token& token = places[i];
    const bool is_there = token.kind == TokenKind::name && token.span.begin <= offset;
    return is_there ? std::optional(i) : std::nullopt;
}

bool KnownText::is_in_comment(std::size_t offset) const {
    const std::string_view text = source->text();
    return std::any_of(
        places.read().comments.begin(), places.read().comments.end(), [&](const Span& one) {
            const bool is_line = text.substr(one.begin, 2) == "//";
            return one.begin < offset && (is_line ? offset <= one.end : offset < one.end);
        });
}

Expected KnownText::expected(std::size_t token) const {
    return expected_at(places, token, places.before(token), catalogue);
}

std::optional<LocatedDefinition> KnownText::find_camera(std::string_view name) const {
    if (const LocatedDefinition* visible = session->find(*module, name)) {
        return *visible;
    }
    Module* built_in = session->load_built_in(name);
    const LocatedDefinition* found = built_in != nullptr ? session->find(*built_in, name) : nullptr;
    return found != nullptr ? std::optional(*found) : std::nullopt;
}

std::optional<LocatedDefinition> KnownText::definition_named(std::string_view name) const {
    if (!name.empty()) {
        return find_camera(name);
    }
    const std::vector<LocatedDefinition> own = own_definitions(*module);
    return own.empty() ? std::nullopt : std::optional(own.back());
}

Diagnostic no_camera(std::string_view name) {
    return error(fmt::format("the text has no camera '{}'", name), {}, "name one that it has");
}

std::optional<LocatedDefinition> KnownText::with_parameters(std::string_view name) const {
    constexpr int deepest = 64;
    std::optional<LocatedDefinition> found = find_camera(name);
    for (int i = 0; i < deepest && found && found->camera->base.valid(); ++i) {
        found = find_camera(found->module->tree[found->camera->base].name.text);
    }
    return found;
}

Meant KnownText::meant_by(std::size_t token) const {
    const Span span = places[token].span;
    const auto own = std::find_if(names.begin(), names.end(), [span](const OwnName& one) {
        return one.name.span.begin == span.begin;
    });
    if (own != names.end()) {
        return &*own;
    }
    if (const StatementRow* row = places.row(token)) {
        // lens( ... ): the keyword may be the name of the stage.
        const camera::StageEntry* stage =
            row->stage_kind ? catalogue.find(*row->stage_kind, row->keyword) : nullptr;
        return stage != nullptr ? Meant(stage) : Meant(row);
    }
    const Expected here = expected(token);
    if (here.call.callee != TokenPlaces::none && here.call.begins_argument) {
        Meant argument = meant_argument(here, token);
        if (!std::holds_alternative<std::monostate>(argument)) {
            return argument;
        }
    }
    if (here.what == What::stage) {
        if (const auto* stage = catalogue.find(here.kind, places[token].text)) {
            return stage;
        }
    }
    if (here.what == What::camera) {
        if (const OwnName* camera = find_name(names, places[token].text, span.begin, true)) {
            return camera;
        }
        const auto found = find_camera(places[token].text);
        return found ? Meant(MeantCamera{*found}) : Meant();
    }
    if (here.what == What::choice) {
        const auto& choices = here.parameter->as<camera::ChoiceParameter>()->choices;
        const auto found = std::find(choices.begin(), choices.end(), places[token].text);
        return found != choices.end()
                   ? Meant(MeantParameter{here.call.stage, here.parameter, *found})
                   : Meant();
    }
    return meant_value(here, token);
}

// name = in a call, or a formula that names itself.
Meant KnownText::meant_argument(const Expected& here, std::size_t token) const {
    const bool is_named = places[token + 1].is("=");
    const std::string_view name = places[token].text;
    if (here.call.is_camera && is_named) {
        const auto camera = with_parameters(places[here.call.callee].text);
        if (!camera) {
            return {};
        }
        for (const DefinitionParameter& parameter : camera->camera->parameters) {
            if (parameter.name.text != name) {
                continue;
            }
            const auto own = std::find_if(names.begin(), names.end(), [&](const OwnName& one) {
                return one.parameter == &parameter;
            });
            return own != names.end() ? Meant(&*own)
                                      : Meant(MeantCameraParameter{*camera, &parameter});
        }
        return {};
    }
    const camera::StageParameter* parameter =
        here.call.stage != nullptr ? find_parameter(*here.call.stage, name) : nullptr;
    const bool is_formula = parameter != nullptr && places[token + 1].is("(") &&
                            parameter->as<camera::FormulaParameter>() != nullptr;
    return parameter != nullptr && (is_named || is_formula)
               ? Meant(MeantParameter{here.call.stage, parameter})
               : Meant();
}

Meant KnownText::meant_value(const Expected& here, std::size_t token) const {
    const std::string_view name = places[token].text;
    if (here.what == What::nothing || here.what == What::coordinate || here.what == What::item ||
        here.what == What::statement) {
        return {};
    }
    for (auto i = here.formula_parameters.rbegin(); i != here.formula_parameters.rend(); ++i) {
        if (places[*i].text == name) {
            return MeantFormulaParameter{places[*i].span,
                                         {places[*i].span.begin, places[token].span.end}};
        }
    }
    if (const OwnName* own = find_name(names, name, places[token].span.begin, false)) {
        return own;
    }
    const Definition* known = module->scope->find(name);
    if (known != nullptr && known->place.source) {
        return MeantImport{known};
    }
    const bool is_built_in =
        known != nullptr || is_function(name) || !module->scope->announced(name).empty();
    return is_built_in ? Meant(MeantWord{name}) : Meant();
}

}  // namespace balcony::lang
