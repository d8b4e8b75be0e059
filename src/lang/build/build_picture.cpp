// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Pictures: layers that name cameras and other pictures.

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "lang/build/build_camera.hpp"
#include "lang/build/layer_statements.hpp"
#include "lang/build/layers.hpp"
#include "lang/build/resolved_layer.hpp"
#include "lang/build/statements.hpp"

namespace balcony::lang {

namespace {

// The position of a picture among the pictures under construction.
struct Nesting {
    std::vector<LocatedDefinition>
        chain;  // The enclosing pictures, from the outermost to this one.
    std::set<const DefinitionSyntax*> failures;  // Pictures with errors, which are not built again.
};

class PictureBuilder {
public:
    PictureBuilder(const LocatedDefinition& place, Scope& scope, Session& session, Nesting& nesting)
        : place_(place),
          tree_(place.module->tree),
          picture_(*place.camera),
          scope_(scope),
          session_(session),
          reporter_(session.reporter()),
          stages_(*place.module, scope, session),
          nesting_(nesting) {}

    std::optional<camera::Picture> run() {
        const std::size_t errors_before = reporter_.error_count();
        const Statements statements(tree_, picture_.statements, reporter_);
        camera::Picture::Parts parts;
        parts.name = std::string(place_.name());
        size(parts);
        if (const Statement* aspect = statements.find(StatementKind::aspect)) {
            this->aspect(*aspect, parts);
        }
        if (statements.lacks(StatementKind::layer) && statements.lacks(StatementKind::loop)) {
            error(picture_.name.span,
                  fmt::format("the picture '{}' has no layers", picture_.name.text),
                  "add a layer, for example layer panorama");
        }
        visit_layers(place_, scope_, session_,
                     [&](const LayerPlace& place) { return layer(place, parts); });
        // A failed layer has been reported at its first use.
        const bool good = complete_ && !has_broken(picture_.statements) &&
                          reporter_.error_count() == errors_before;
        return good ? finish(std::move(parts)) : std::nullopt;
    }

private:
    using Content = decltype(camera::Layer::content);
    using NestedPicture = std::shared_ptr<const camera::Picture>;

    static bool has_broken(const std::vector<Statement>& statements) {
        return std::any_of(statements.begin(), statements.end(), [](const Statement& one) {
            return one.broken || has_broken(one.block);
        });
    }

    void error(Span span, std::string message, std::string remedy = {}) {
        reporter_.error(tree_.at(span), std::move(message), std::move(remedy));
    }

    // -------------------------------------------------------------------------- the whole picture

    void size(camera::Picture::Parts& parts) {
        std::array<std::size_t, 2> pixels{};
        constexpr double maximum = 1048576.0;
        for (std::size_t i = 0; i < picture_.size.size(); ++i) {
            const ExpressionId id = picture_.size[i];
            const auto value =
                stages_.constant(id, i == 0 ? "the width of a picture" : "the height of a picture");
            if (!value) {
                return;
            }
            if (!(*value >= 1.0 && *value <= maximum && std::floor(*value) == *value)) {
                error(tree_[id].span,
                      fmt::format(
                          "the size of a picture is a whole number of pixels, but this is {:.6g}",
                          *value),
                      "write width and height in pixels, for example 1920 x 1080");
                return;
            }
            pixels[i] = static_cast<std::size_t>(*value);
        }
        if (picture_.size.size() == 2) {
            parts.size = pixels;
        }
    }

    void aspect(const Statement& statement, camera::Picture::Parts& parts) {
        if (!picture_.size.empty()) {
            error(statement.span, "this picture has both a size and an aspect",
                  "remove the aspect, which follows from the size");
        } else if (const auto value = stages_.aspect(statement.value(), "a picture")) {
            parts.aspect = value->ratio;
            parts.sides = value->sides;
        }
    }

    std::optional<camera::Picture> finish(camera::Picture::Parts parts) {
        Result<camera::Picture> made = camera::Picture::make(std::move(parts));
        for (Diagnostic& diagnostic : made.diagnostics) {
            if (!diagnostic.span.source) {
                diagnostic.span = tree_.at(picture_.name.span);
            }
            reporter_.add(std::move(diagnostic));
        }
        return made.value;
    }

    // -------------------------------------------------------------------------------------- layers

    bool layer(const LayerPlace& place, camera::Picture::Parts& parts) {
        const Expression& call = tree_[place.statement.stages().front()];
        std::optional<Content> content = this->content(call, place.names);
        // Reads all statements, to report all mistakes.
        camera::Layer made{std::string(call.name.text) + place.key,
                           content.value_or(NestedPicture())};
        const bool good = read_layer(*place_.module, place.statement, place.names, session_, made);
        if (!content || !good) {
            complete_ = false;
            return true;
        }
        parts.layers.push_back(std::move(made));
        warn_of_lost_leaders(place.statement, parts);
        return true;
    }

    // A leader without corners goes to what a layer below shows.
    void warn_of_lost_leaders(const Statement& statement, const camera::Picture::Parts& parts) {
        if (source_of(parts, parts.layers.size() - 1)) {
            return;
        }
        for (const Statement& one : statement.block) {
            if (one.kind == StatementKind::leader && !one.broken && one.corners() == nullptr) {
                reporter_.warning(
                    tree_.at(one.span),
                    fmt::format("no layer below shows '{}' with the same parameters, so this "
                                "leader goes to the region of 'show' in the whole picture",
                                parts.layers.back().name),
                    "write its corners: leader (0.2, 0.1) .. (0.4, 0.3)");
            }
        }
    }

    // ---------------------------------------------------------------------- what a layer shows

    std::optional<Content> content(const Expression& call, Scope& names) {
        const auto shown = resolve_layer(place_, call, names, session_);
        if (!shown) {
            return std::nullopt;
        }
        const auto& [place, given] = *shown;
        std::optional<Content> made;
        if (!place.camera->is_picture) {
            if (auto camera = build_camera(place, given, session_, false)) {
                made.emplace(std::move(*camera));
            }
        } else if (!in_a_circle(place, call) && !too_deep(call)) {
            if (auto picture = nested(place, given)) {
                made.emplace(std::move(picture));
            }
        }
        return made;
    }

    // Null if there is an error.
    NestedPicture nested(const LocatedDefinition& place, const GivenParameters& given) {
        if (nesting_.failures.contains(place.camera)) {
            return nullptr;
        }
        DefinitionScope scope(place, given, session_);
        const std::vector<Value> parameters = scope.values();
        const Session::Built* built = session_.built(place, parameters);
        if (built == nullptr) {
            nesting_.chain.push_back(place);
            auto picture = PictureBuilder(place, scope.names(), session_, nesting_).run();
            nesting_.chain.pop_back();
            if (!picture) {
                nesting_.failures.insert(place.camera);
                return nullptr;
            }
            built = &session_.share(place, parameters,
                                    std::make_shared<const camera::Picture>(std::move(*picture)));
        }
        return std::get<NestedPicture>(**built);
    }

    bool in_a_circle(const LocatedDefinition& place, const Expression& call) {
        const auto first = std::find_if(
            nesting_.chain.begin(), nesting_.chain.end(),
            [&place](const LocatedDefinition& one) { return one.camera == place.camera; });
        if (first == nesting_.chain.end()) {
            return false;
        }
        std::string names;
        for (auto one = first; one != nesting_.chain.end(); ++one) {
            names += fmt::format("{} -> ", one->camera->name.text);
        }
        error(call.name.span,
              fmt::format("the picture '{0}' shows itself: {1}{0}", place.camera->name.text, names),
              "change one of its layers to show something else");
        return true;
    }

    bool too_deep(const Expression& call) {
        if (nesting_.chain.size() < camera::max_nested_pictures) {
            return false;
        }
        error(call.name.span, fmt::format("pictures are nested more than {} levels deep",
                                          camera::max_nested_pictures));
        return true;
    }

    const LocatedDefinition place_;
    const SyntaxTree& tree_;
    const DefinitionSyntax& picture_;
    Scope& scope_;
    Session& session_;
    Reporter& reporter_;
    StageBuilder stages_;
    Nesting& nesting_;
    bool complete_ = true;
};

}  // namespace

std::optional<camera::Picture> build_picture(const LocatedDefinition& place,
                                             const GivenParameters& given, Session& session,
                                             std::vector<Value>* values) {
    if (!place.camera->is_picture) {
        std::optional<camera::Camera> camera = build_camera(place, given, session, true, values);
        return camera ? std::optional<camera::Picture>(std::move(*camera)) : std::nullopt;
    }
    const std::size_t errors_before = session.reporter().error_count();
    DefinitionScope scope(place, given, session);
    Nesting nesting{{place}, {}};
    auto made = PictureBuilder(place, scope.names(), session, nesting).run();
    if (session.reporter().error_count() > errors_before) {
        return std::nullopt;
    }
    if (session.reporter().error_count() == 0) {
        scope.warn_of_unused();
    }
    if (values != nullptr) {
        *values = scope.values();
    }
    return made;
}

}  // namespace balcony::lang
