// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/build/resolved_layer.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "balcony/names.hpp"
#include "lang/names/evaluate.hpp"

namespace balcony::lang {

namespace {

// What a layer can name: a similar name, or where all of them are listed.
std::string known_names(std::string_view name, const LocatedDefinition& picture) {
    constexpr std::size_t max_listed = 40;
    std::vector<std::string> own_names;
    for (const LocatedDefinition& place : visible_definitions(*picture.module)) {
        if (place.camera->name.text != picture.camera->name.text) {
            own_names.emplace_back(place.camera->name.text);
        }
    }
    std::vector<std::string> known = own_names;
    known.insert(known.end(), built_in_cameras().begin(), built_in_cameras().end());
    std::sort(own_names.begin(), own_names.end());
    own_names.erase(std::unique(own_names.begin(), own_names.end()), own_names.end());
    const std::string built_in = "'balcony list cameras' shows the built-in ones";
    return did_you_mean(name, known,
                        own_names.empty() || own_names.size() > max_listed
                            ? built_in
                            : fmt::format("this file has {}; {}", all_of(own_names), built_in));
}

std::optional<LocatedDefinition> find(const LocatedDefinition& picture, const Identifier& name,
                                      Session& session) {
    const Module& module = *picture.module;
    if (const LocatedDefinition* place = session.find(module, name.text)) {
        return *place;
    }
    if (const Module* built_in = session.load_built_in(name.text)) {
        // After too many errors, files are not read.
        const std::vector<LocatedDefinition> own = own_definitions(*built_in);
        return own.empty() ? std::nullopt : std::optional(own.back());
    }
    if (!module.scope->incomplete()) {
        session.reporter().error(module.tree.at(name.span),
                                 fmt::format("there is no camera or picture named '{}'", name.text),
                                 [&] { return known_names(name.text, picture); });
    }
    return std::nullopt;
}

bool read_parameters(const SyntaxTree& tree, const Expression& call, Scope& names, Session& session,
                     std::string_view what, GivenParameters& given) {
    Reporter& reporter = session.reporter();
    if (call.kind == ExpressionKind::formula) {
        reporter.error(tree.at(call.span),
                       fmt::format("{} needs a name, but this is a formula", what),
                       "define a camera that uses the formula, and name that camera");
        return false;
    }
    bool good = true;
    for (const Argument& argument : call.arguments) {
        const SourceSpan span = tree.at(tree[argument.value].span);
        if (!argument.name) {
            reporter.error(span, fmt::format("parameters of {} must be named", what),
                           fmt::format("write {}(name = {})", call.name.text,
                                       tree.text(tree[argument.value].span)));
            good = false;
            continue;
        }
        const Value value = evaluate_any(tree, argument.value, names, session.context());
        good = good && !value.failed();
        given.values.push_back({*argument.name, tree.at(argument.name->span), value, span});
    }
    return good;
}

}  // namespace

std::optional<ResolvedLayer> resolve_layer(const LocatedDefinition& picture, const Expression& call,
                                           Scope& names, Session& session, std::string_view what) {
    const std::optional<LocatedDefinition> place = find(picture, call.name, session);
    if (!place) {
        return std::nullopt;
    }
    ResolvedLayer content{*place, {}};
    const bool good =
        read_parameters(picture.module->tree, call, names, session, what, content.given);
    return good ? std::optional(std::move(content)) : std::nullopt;
}

}  // namespace balcony::lang
