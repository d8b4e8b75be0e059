// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/build/resolved_layer.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "lang/names/evaluate.hpp"

namespace balcony::lang {

namespace {

std::optional<LocatedDefinition> find(const LocatedDefinition& picture, const Identifier& name,
                                      Session& session) {
    const Module& module = *picture.module;
    const std::vector<LocatedDefinition> visible = visible_definitions(module);
    std::vector<std::string> known = built_in_cameras();
    for (const LocatedDefinition& place : visible) {
        if (place.camera->name.text == name.text) {
            return place;
        }
        known.emplace_back(place.camera->name.text);
    }
    if (const Module* built_in = session.load_built_in(name.text)) {
        // After too many errors, files are not read.
        const std::vector<LocatedDefinition> own = own_definitions(*built_in);
        return own.empty() ? std::nullopt : std::optional(own.back());
    }
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    std::erase(known, std::string(picture.camera->name.text));
    if (!module.scope->incomplete()) {
        session.reporter().error(module.tree.at(name.span),
                                 fmt::format("there is no camera or picture named '{}'", name.text),
                                 suggestion(name.text, known, "there are"));
    }
    return std::nullopt;
}

bool read_parameters(const SyntaxTree& tree, const Expression& call, Scope& names, Session& session,
                     GivenParameters& given) {
    Reporter& reporter = session.reporter();
    if (call.kind == ExpressionKind::formula) {
        reporter.error(tree.at(call.span),
                       "a layer needs the name of a camera or a picture, but this is a formula",
                       "define a camera that uses the formula, and name that camera");
        return false;
    }
    bool good = true;
    for (const Argument& argument : call.arguments) {
        const SourceSpan span = tree.at(tree[argument.value].span);
        if (!argument.name) {
            reporter.error(span, "parameters of a layer must be named",
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
                                           Scope& names, Session& session) {
    const std::optional<LocatedDefinition> place = find(picture, call.name, session);
    if (!place) {
        return std::nullopt;
    }
    ResolvedLayer content{*place, {}};
    const bool good = read_parameters(picture.module->tree, call, names, session, content.given);
    return good ? std::optional(std::move(content)) : std::nullopt;
}

}  // namespace balcony::lang
