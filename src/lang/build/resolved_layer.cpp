// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/build/resolved_layer.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "balcony/names.hpp"
#include "lang/names/evaluate.hpp"
#include "lang/syntax/statement_rows.hpp"

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

// The definition of a name in a file, or else the built-in camera of that name.
std::optional<LocatedDefinition> find(const LocatedDefinition& picture, const Identifier& name,
                                      Session& session) {
    const Module& module = *picture.module;
    const LocatedDefinition* place = session.find(module, name.text);
    const bool is_itself =
        place != nullptr && place->camera == picture.camera && picture.camera->base.valid();
    if (place != nullptr && !is_itself) {
        return *place;
    }
    // What is made of another one of its own name means one of another file.
    for (const LocatedDefinition& one : visible_definitions(module)) {
        if (is_itself && one.module != &module && one.camera->name.text == name.text) {
            return one;
        }
    }
    if (const Module* built_in = session.load_built_in(name.text)) {
        // After too many errors, files are not read.
        const std::vector<LocatedDefinition> own = own_definitions(*built_in);
        return own.empty() ? std::nullopt : std::optional(own.back());
    }
    for (const camera::StageEntry& row : session.catalogue()) {
        if (row.name == name.text) {
            session.reporter().error(
                module.tree.at(name.span),
                fmt::format("expected a camera, but '{}' is a stage ({})", name.text,
                            camera::name_of(row.kind)),
                fmt::format("a stage belongs in the block of a camera: camera NAME {{ {} {} ... }}",
                            statements_for(row.kind).front(), signature(row)));
            return std::nullopt;
        }
    }
    if (!module.scope->incomplete()) {
        session.reporter().error(module.tree.at(name.span),
                                 fmt::format("there is no camera or picture named '{}'", name.text),
                                 [&] { return known_names(name.text, picture); });
    }
    return std::nullopt;
}

bool read_parameters(const SyntaxTree& tree, const Expression& call, Scope& names, Session& session,
                     std::string_view what, const LocatedDefinition& place,
                     GivenParameters& given) {
    Reporter& reporter = session.reporter();
    if (call.kind == ExpressionKind::formula) {
        reporter.error(tree.at(call.span),
                       fmt::format("{} needs a name, but this is a formula", what),
                       "define a camera that uses the formula, and name that camera");
        return false;
    }
    bool good = true;
    std::map<std::string_view, Span> known;
    for (const Argument& argument : call.arguments) {
        const SourceSpan span = tree.at(tree[argument.value].span);
        if (!argument.name) {
            const auto& parameters = place.camera->parameters;
            reporter.error(span, fmt::format("parameters of {} must be named", what),
                           fmt::format("write {}({} = {})", call.name.text,
                                       parameters.empty() ? "name" : parameters.front().name.text,
                                       tree.text(tree[argument.value].span)));
            good = false;
            continue;
        }
        const auto [earlier, is_new] = known.emplace(argument.name->text, argument.name->span);
        if (!is_new) {
            report_given_twice(*argument.name, tree.at(argument.name->span),
                               tree.at(earlier->second), reporter);
            good = false;
        }
        const Value value = evaluate_any(tree, argument.value, names, session.context());
        good = good && !value.failed();
        given.values.push_back({*argument.name, tree.at(argument.name->span), value, span});
    }
    return good;
}

// A camera is made of a camera, and a picture of a picture.
bool is_of_one_kind(const LocatedDefinition& derived, const Expression& call,
                    const LocatedDefinition& base, Reporter& reporter) {
    if (derived.camera->is_picture == base.camera->is_picture) {
        return true;
    }
    const SyntaxTree& tree = derived.module->tree;
    reporter.error(tree.at(call.name.span),
                   fmt::format("'{}' is a {}, but a {} is needed", call.name.text,
                               word_for(*base.camera), word_for(*derived.camera)),
                   fmt::format("write {} {} = {}", word_for(*base.camera), derived.name(),
                               tree.text(call.span)));
    return false;
}

bool in_a_circle(const std::vector<LocatedDefinition>& chain, const LocatedDefinition& next,
                 Session& session) {
    const auto first =
        std::find_if(chain.begin(), chain.end(),
                     [&next](const LocatedDefinition& one) { return one.camera == next.camera; });
    if (first == chain.end()) {
        return false;
    }
    std::string names;
    for (auto one = first; one != chain.end(); ++one) {
        names += fmt::format("{} -> ", one->name());
    }
    session.reporter().error(next.module->tree.at(next.camera->name.span),
                             fmt::format("the {} '{}' is made of itself: {}{}",
                                         word_for(*next.camera), next.name(), names, next.name()),
                             "make one of them of another, or write its statements");
    return true;
}

}  // namespace

std::optional<ResolvedLayer> resolve_base(ResolvedLayer written, Session& session) {
    const DefinitionSyntax* const derived = written.place.camera;
    std::vector<LocatedDefinition> chain;
    while (written.place.camera->base.valid()) {
        const LocatedDefinition place = written.place;
        if (in_a_circle(chain, place, session)) {
            return std::nullopt;
        }
        chain.push_back(place);
        const Module& module = *place.module;
        const Expression& call = module.tree[place.camera->base];
        const std::optional<LocatedDefinition> base = find(place, call.name, session);
        if (!base || !is_of_one_kind(place, call, *base, session.reporter()) ||
            !read_parameters(module.tree, call, *module.scope, session,
                             fmt::format("a {}", word_for(*base->camera)), *base, written.given)) {
            return std::nullopt;
        }
        written.place = *base;
    }
    written.place.derived = chain.empty() ? nullptr : derived;
    return written;
}

std::optional<ResolvedLayer> resolve_layer(const LocatedDefinition& picture, const Expression& call,
                                           Scope& names, Session& session, std::string_view what) {
    const std::optional<LocatedDefinition> place = find(picture, call.name, session);
    if (!place) {
        return std::nullopt;
    }
    ResolvedLayer content{*place, {}};
    const bool good =
        read_parameters(picture.module->tree, call, names, session, what, *place, content.given);
    return good ? resolve_base(std::move(content), session) : std::nullopt;
}

}  // namespace balcony::lang
