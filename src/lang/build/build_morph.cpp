// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// morph A .. B, amount = a: a camera between two others, by their rays or by their parameters.

#include "lang/build/build_morph.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "balcony/morph.hpp"
#include "lang/build/build_camera.hpp"
#include "lang/build/resolved_layer.hpp"
#include "lang/names/definition_scope.hpp"
#include "lang/names/evaluate.hpp"

namespace balcony::lang {

namespace {

constexpr std::size_t max_nested_morphs = 16;

/// A camera under construction, for as long as this lives.
class InChain {
public:
    InChain(Session& session, const DefinitionSyntax* camera) : chain_(session.morphs()) {
        chain_.push_back(camera);
    }
    InChain(const InChain&) = delete;
    InChain& operator=(const InChain&) = delete;
    ~InChain() { chain_.pop_back(); }

private:
    std::vector<const DefinitionSyntax*>& chain_;
};

class MorphBuilder {
public:
    MorphBuilder(const LocatedDefinition& place, const Statement& statement,
                 const MorphSettings& settings, Scope& scope, StageBuilder& stages,
                 Session& session)
        : place_(place),
          tree_(place.module->tree),
          statement_(statement),
          call_(tree_[statement.stages().front()]),
          settings_(settings),
          scope_(scope),
          stages_(stages),
          session_(session),
          reporter_(session.reporter()) {}

    std::optional<camera::Camera::Parts> run() {
        const InChain in_chain(session_, place_.camera);
        if (!read_arguments()) {
            return std::nullopt;
        }
        const auto first = resolve(0);
        const auto second = resolve(1);
        if (!first || !second) {
            return std::nullopt;
        }
        const bool same = first->place.camera == second->place.camera;
        if (by_.text == "parameters" && !same) {
            error(by_.span,
                  fmt::format("'{}' and '{}' are different cameras, which have no parameters in "
                              "common",
                              camera_of(0).name.text, camera_of(1).name.text),
                  "write by = rays, or two calls of one camera");
            return std::nullopt;
        }
        auto made =
            same && by_.text != "rays" ? by_parameters(*first, *second) : by_rays(*first, *second);
        session_.morph_levels(place_.camera) =
            1 + std::max(session_.morph_levels(first->place.camera),
                         session_.morph_levels(second->place.camera));
        return made;
    }

private:
    void error(Span span, std::string message, std::string remedy) {
        reporter_.error(tree_.at(span), std::move(message), std::move(remedy));
    }

    [[nodiscard]] const Expression& camera_of(std::size_t i) const {
        return tree_[call_.arguments[i].value];
    }

    // ---------------------------------------------------------------------------------- reading

    bool read_arguments() {
        std::map<std::string_view, Span> given;
        for (const Argument& argument : call_.arguments) {
            if (!argument.name) {
                continue;
            }
            const auto [earlier, is_new] = given.emplace(argument.name->text, argument.name->span);
            if (!is_new) {
                report_given_twice(*argument.name, tree_.at(argument.name->span),
                                   tree_.at(earlier->second), reporter_);
                return false;
            }
            if (!read(*argument.name, argument.value)) {
                return false;
            }
        }
        if (!amount_.valid()) {
            error(statement_.keyword, "this morph has no amount",
                  "add how far it is from the first camera, 0, to the second, 1: amount = "
                  "keys((0, 0), (3, 1), ease = smooth)");
        }
        return amount_.valid();
    }

    bool read(const Identifier& name, ExpressionId value) {
        if (name.text == "amount") {
            amount_ = value;
            return true;
        }
        const bool is_by = name.text == "by";
        if (!is_by && name.text != "aspect") {
            error(name.span, fmt::format("a morph has no argument named '{}'", name.text),
                  suggestion(name.text, {"amount", "by", "aspect"}, "its arguments are"));
            return false;
        }
        const std::vector<std::string> known =
            is_by ? std::vector<std::string>{"rays", "parameters"} : camera::fits().all();
        const Expression& word = tree_[value];
        if (word.kind != ExpressionKind::name ||
            std::find(known.begin(), known.end(), word.name.text) == known.end()) {
            error(word.span,
                  fmt::format("'{}' of a morph cannot be '{}'", name.text, tree_.text(word.span)),
                  suggestion(word.name.text, known, "the choices are"));
            return false;
        }
        (is_by ? by_ : fit_) = word.name;
        return true;
    }

    std::optional<ResolvedLayer> resolve(std::size_t i) {
        const Expression& call = camera_of(i);
        auto found = resolve_layer(place_, call, scope_, session_, "a camera of a morph");
        if (!found) {
            return std::nullopt;
        }
        if (found->place.camera->is_picture) {
            error(call.name.span,
                  fmt::format("'{}' is a picture, but a morph is between cameras", call.name.text),
                  "name a camera, for example one of its layers");
            return std::nullopt;
        }
        const auto& chain = session_.morphs();
        if (std::find(chain.begin(), chain.end(), found->place.camera) != chain.end()) {
            error(call.name.span,
                  fmt::format("the camera '{}' is part of its own morph", call.name.text),
                  "name another camera");
            return std::nullopt;
        }
        if (chain.size() + session_.morph_levels(found->place.camera) > max_nested_morphs) {
            error(call.name.span,
                  fmt::format("morphs are nested more than {} levels deep", max_nested_morphs),
                  "let one morph go through several cameras by keys of its parameters");
            return std::nullopt;
        }
        return found;
    }

    // Errors in a camera get a note with its place in the morph.
    std::optional<camera::Camera> build(const ResolvedLayer& found, std::size_t i) {
        const std::size_t before = reporter_.count();
        auto made = build_camera(found.place, found.given, session_, false);
        reporter_.annotate(before, {tree_.at(camera_of(i).span), "in this camera of the morph"});
        return made;
    }

    // ------------------------------------------------------------------------------------- rays

    std::optional<camera::Camera::Parts> by_rays(const ResolvedLayer& from,
                                                 const ResolvedLayer& to) {
        const auto amount = stages_.formula_of_picture(amount_, "the amount of a morph");
        const auto first = build(from, 0);
        const auto second = build(to, 1);
        if (!amount || !first || !second || !check(*first, 0) || !check(*second, 1)) {
            return std::nullopt;
        }
        const Axes common =
            first->parts().axes == second->parts().axes ? first->parts().axes : Axes::z_up;
        return camera::morphed({*first, *second, *amount,
                                camera::fits().find(fit_.text).value_or(camera::Fit::fit),
                                settings_.axes.value_or(common), settings_.aspect});
    }

    bool check(const camera::Camera& camera, std::size_t i) {
        const Expression& call = camera_of(i);
        if (camera.parts().lens) {
            reporter_.warning(
                tree_.at(call.span),
                fmt::format("the lens of '{}' has no effect in a morph of rays", call.name.text),
                "write a lens in the camera that morphs");
        }
        if (camera.parts().bend) {
            error(call.span,
                  fmt::format("the rays of '{}' are bent, which a morph of rays cannot blend",
                              call.name.text),
                  "write bend in the camera that morphs, and morph cameras without it");
            return false;
        }
        if (camera.parts().time) {
            error(call.span,
                  fmt::format("'{}' has a time of its own for each ray, which a morph of rays "
                              "cannot blend",
                              call.name.text),
                  "write time in the camera that morphs, and morph cameras without it");
            return false;
        }
        return true;
    }

    // ------------------------------------------------------------------------------- parameters

    std::optional<camera::Camera::Parts> by_parameters(const ResolvedLayer& from,
                                                       const ResolvedLayer& to) {
        const std::string_view why =
            "parameters are the same in the whole picture; write by = rays for an amount that "
            "depends on x and y";
        Scope inner(&scope_);
        inner.announce("x", why);
        inner.announce("y", why);
        const Value amount = evaluate(tree_, amount_, inner, session_.context());
        if (amount.failed()) {
            return std::nullopt;
        }
        if (amount.is_angle()) {
            error(tree_[amount_].span, "the amount of a morph is a number, but this is an angle",
                  "remove deg or rad, or divide the angle by 1rad");
            return std::nullopt;
        }
        const auto first = values_of(from, 0);
        const auto second = values_of(to, 1);
        if (!first || !second) {
            return std::nullopt;
        }
        ResolvedLayer between{from.place, {}};
        for (std::size_t i = 0; i < first->size(); ++i) {
            const Identifier& name = from.place.camera->parameters[i].name;
            const auto value = blended((*first)[i], (*second)[i], amount.expr, name.text);
            if (!value) {
                return std::nullopt;
            }
            const SourceSpan span = tree_.at(statement_.span);
            between.given.values.push_back({name, span, *value, span});
        }
        const auto camera = build(between, 1);
        return camera ? own_parts(*camera) : std::nullopt;
    }

    std::optional<std::vector<Value>> values_of(const ResolvedLayer& found, std::size_t i) {
        const std::size_t errors_before = reporter_.error_count();
        const std::size_t before = reporter_.count();
        DefinitionScope names(found.place, found.given, session_);
        reporter_.annotate(before, {tree_.at(camera_of(i).span), "in this camera of the morph"});
        return reporter_.error_count() == errors_before ? std::optional(names.values())
                                                        : std::nullopt;
    }

    // A value of the same form and unit as both.
    std::optional<Value> blended(const Value& a, const Value& b, expr::Expr amount,
                                 std::string_view name) {
        if (!a.elements) {
            Value made = a.is_zero() ? b : a;
            made.expr = a.expr.same(b.expr) ? a.expr : (1.0 - amount) * a.expr + amount * b.expr;
            return made;
        }
        if (a.elements->size() != b.elements->size()) {
            error(call_.span,
                  fmt::format("'{}' has {} elements in the first camera of this morph, but {} in "
                              "the second",
                              name, a.elements->size(), b.elements->size()),
                  "give both lists the same length, or write by = rays");
            return std::nullopt;
        }
        auto elements = std::make_shared<std::vector<Element>>(*a.elements);
        for (std::size_t i = 0; i < elements->size(); ++i) {
            const auto element =
                blended((*a.elements)[i].value, (*b.elements)[i].value, amount, name);
            if (!element) {
                return std::nullopt;
            }
            (*elements)[i].value = *element;
        }
        Value made = a;
        made.elements = std::move(elements);
        return made;
    }

    std::optional<camera::Camera::Parts> own_parts(const camera::Camera& camera) {
        camera::Camera::Parts parts = camera.parts();
        if (settings_.axes && *settings_.axes != parts.axes) {
            error(statement_.span,
                  fmt::format("'{}' has other axes than this camera", camera_of(0).name.text),
                  "remove the axes of this camera, or write by = rays");
            return std::nullopt;
        }
        parts.aspect = settings_.aspect.value_or(parts.aspect);
        return parts;
    }

    const LocatedDefinition place_;
    const SyntaxTree& tree_;
    const Statement& statement_;
    const Expression& call_;
    const MorphSettings& settings_;
    Scope& scope_;
    StageBuilder& stages_;
    Session& session_;
    Reporter& reporter_;
    ExpressionId amount_{};
    Identifier by_{};
    Identifier fit_{};
};

}  // namespace

std::optional<camera::Camera::Parts> build_morph(const LocatedDefinition& place,
                                                 const Statement& statement,
                                                 const MorphSettings& settings, Scope& scope,
                                                 StageBuilder& stages, Session& session) {
    return MorphBuilder(place, statement, settings, scope, stages, session).run();
}

}  // namespace balcony::lang
