// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/build/build_camera.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "camera/machine/misfits.hpp"
#include "lang/build/build_map.hpp"
#include "lang/build/build_morph.hpp"
#include "lang/build/stages.hpp"
#include "lang/build/statements.hpp"
#include "lang/names/definition_scope.hpp"
#include "lang/syntax/statement_rows.hpp"

namespace balcony::lang {

namespace {

class CameraBuilder {
public:
    CameraBuilder(const LocatedDefinition& place, Scope& scope, Session& session)
        : place_(place),
          tree_(place.module->tree),
          camera_(*place.camera),
          scope_(scope),
          session_(session),
          reporter_(session.reporter()),
          stages_(*place.module, scope, session),
          statements_(tree_, camera_.statements, reporter_) {}

    std::optional<camera::Camera> run() {
        const std::size_t errors_before = reporter_.error_count();
        camera::Camera::Parts parts;
        parts.name = std::string(place_.name());
        parts.inputs = session_.inputs();
        parts.arrangers = make_arrangers(camera_.statements,
                                         {StatementKind::place, StatementKind::arrange}, stages_);
        aspect(parts);
        axes(parts);
        shared_.mapper = build_map(statements_, tree_, stages_, reporter_);
        shared_.parameter_transformers =
            list<camera::ParameterTransformer>(statements_, StatementKind::warp);
        shared_.object_transformers =
            list<camera::ObjectTransformer>(statements_, StatementKind::move);
        if (is_morph()) {
            morph(parts);
        } else {
            paths(parts);
            own_picture(parts);
            look(parts);
            report_misfits(parts);
        }
        stereo(parts);
        lens(parts);
        bend(parts);
        time(parts);
        parts.written.insert(stages_.written().begin(), stages_.written().end());
        // A null result without a diagnostic here has been reported at its source.
        return reporter_.error_count() == errors_before && complete(parts)
                   ? finish(std::move(parts))
                   : std::nullopt;
    }

private:
    void error(Span span, std::string message, std::string remedy = {}) {
        reporter_.error(tree_.at(span), std::move(message), std::move(remedy));
    }

    template <class Port>
    std::vector<std::shared_ptr<const Port>> list(const Statements& statements,
                                                  StatementKind kind) {
        std::vector<std::shared_ptr<const Port>> made;
        for (const ExpressionId call : statements.stages(kind)) {
            made.push_back(stages_.make<Port>(call));
        }
        return made;
    }

    void aspect(camera::Camera::Parts& parts) {
        const Statement* statement = statements_.find(StatementKind::aspect);
        if (statement == nullptr) {
            return;
        }
        if (const auto value = stages_.aspect(statement->value(), "a camera")) {
            parts.aspect = value->ratio;
            parts.sides = value->sides;
        }
    }

    void axes(camera::Camera::Parts& parts) {
        const Statement* statement = statements_.find(StatementKind::axes);
        if (statement == nullptr) {
            return;
        }
        const Identifier& name = statement->word();
        if (name.text != "z_up" && name.text != "y_up") {
            error(name.span, fmt::format("unknown axes '{}'", name.text),
                  suggestion(name.text, {"z_up", "y_up"}, "write"));
        }
        parts.axes = name.text == "y_up" ? Axes::y_up : Axes::z_up;
    }

    [[nodiscard]] bool complete(const camera::Camera::Parts& parts) const {
        const auto all = [](const auto& stages) {
            return std::all_of(stages.begin(), stages.end(),
                               [](const auto& stage) { return stage != nullptr; });
        };
        const auto whole = [&all](const camera::Path& path) {
            return path.mapper && path.generator && all(path.parameter_transformers) &&
                   all(path.object_transformers);
        };
        const bool has_toward = !statements_.lacks(StatementKind::toward);
        const bool as_stated = has_toward == parts.toward.has_value() || is_morph();
        return parts.look && whole(parts.eye) && all(parts.arrangers) && as_stated &&
               (!parts.toward || whole(*parts.toward)) &&
               (statements_.lacks(StatementKind::stereo) || parts.stereo) &&
               (statements_.lacks(StatementKind::lens) || parts.lens) &&
               (statements_.lacks(StatementKind::bend) || parts.bend) &&
               (statements_.lacks(StatementKind::time) || parts.time);
    }

    // ----------------------------------------------------------------------------------- morph

    // Also if the statement is broken.
    [[nodiscard]] bool is_morph() const {
        return std::any_of(camera_.statements.begin(), camera_.statements.end(),
                           [](const Statement& one) { return one.kind == StatementKind::morph; });
    }

    // The camera's moves, arrangers, lens and time apply to the camera that the morph makes.
    void morph(camera::Camera::Parts& parts) {
        for (const StatementKind kind :
             {StatementKind::map, StatementKind::eye, StatementKind::toward, StatementKind::warp,
              StatementKind::look}) {
            if (const Statement* other = statements_.find(kind)) {
                error(other->keyword,
                      fmt::format("a camera that morphs has no '{}' of its own", keyword(kind)),
                      "write it in one of the cameras of the morph");
            }
        }
        const Statement* statement = statements_.find(StatementKind::morph);
        if (statement == nullptr) {
            return;
        }
        MorphSettings settings;
        if (statements_.find(StatementKind::aspect) != nullptr) {
            settings.aspect = parts.aspect;
        }
        if (statements_.find(StatementKind::axes) != nullptr) {
            settings.axes = parts.axes;
        }
        auto made = build_morph(place_, *statement, settings, scope_, stages_, session_);
        if (!made) {
            return;
        }
        made->name = parts.name;
        made->inputs = parts.inputs;
        made->arrangers.insert(made->arrangers.begin(), parts.arrangers.begin(),
                               parts.arrangers.end());
        add_moves(made->eye);
        if (made->toward) {
            add_moves(*made->toward);
        }
        parts = std::move(*made);
    }

    void add_moves(camera::Path& path) {
        path.object_transformers.insert(path.object_transformers.end(),
                                        shared_.object_transformers.begin(),
                                        shared_.object_transformers.end());
    }

    // ----------------------------------------------------------------------------------- paths

    void paths(camera::Camera::Parts& parts) {
        const Statement* eye = statements_.find(StatementKind::eye);
        const Statement* toward = statements_.find(StatementKind::toward);
        if (statements_.lacks(StatementKind::eye)) {
            error(camera_.name.span,
                  fmt::format("the camera '{}' has no eye object", camera_.name.text),
                  "specify where rays start, for example eye sphere(1)");
        }
        bool eye_shares_map = false;
        bool toward_shares_map = false;
        if (eye != nullptr) {
            parts.eye = path(*eye, eye_shares_map);
        }
        if (toward != nullptr) {
            parts.toward = path(*toward, toward_shares_map);
            check_extent(*parts.toward, *toward);
        }
        if (statements_.lacks(StatementKind::map)) {
            if (eye_shares_map) {
                complete_map(parts.eye, parts.toward ? &*parts.toward : nullptr, *eye);
            }
            if (toward_shares_map) {
                complete_map(*parts.toward, &parts.eye, *toward);
            }
        }
        const Statement* map = statements_.find(StatementKind::map);
        if (map != nullptr && eye != nullptr && !eye_shares_map && !toward_shares_map) {
            reporter_.warning(tree_.at(map->keyword), "this map has no effect",
                              "every path of the camera has its own map");
        }
    }

    // A calibrated camera without a radius is one point, at which all rays would aim.
    void check_extent(const camera::Path& toward, const Statement& statement) {
        if (!toward.generator || !toward.generator->own_picture()) {
            return;
        }
        expr::Graph graph;
        camera::Emitter emit(graph);
        const camera::ObjectPoint p =
            toward.generator->generate({graph.fresh_variable(), graph.fresh_variable()}, emit);
        if (p.x.is_constant() && p.y.is_constant() && p.z.is_constant()) {
            error(statement.keyword, "all points of this direction object are one point",
                  "write it after eye, or give it a radius: radius = 1");
        }
    }

    // An object that is defined by a picture brings the map and the aspect that are not given.
    void own_picture(camera::Camera::Parts& parts) {
        const auto picture_of = [](const camera::ObjectGeneratorPointer& object) {
            return object ? object->own_picture() : std::nullopt;
        };
        auto shown = picture_of(parts.eye.generator);
        if (!shown && parts.toward) {
            shown = picture_of(parts.toward->generator);
        }
        if (shown && statements_.find(StatementKind::map) == nullptr &&
            statements_.lacks(StatementKind::aspect)) {
            parts.aspect =
                std::abs((shown->u_last - shown->u_first) / (shown->v_last - shown->v_first));
        }
    }

    // Without a map, a path has that of its object's own picture, or else of the other object's.
    void complete_map(camera::Path& path, const camera::Path* other, const Statement& statement) {
        path.mapper = own_map(path.generator);
        if (!path.mapper && other != nullptr) {
            path.mapper = own_map(other->generator);
        }
        // An object with an error might have brought a map.
        const bool all_objects = path.generator && (other == nullptr || other->generator);
        if (!path.mapper && all_objects) {
            require_map(statement);
        }
    }

    static camera::PictureMapperPointer own_map(const camera::ObjectGeneratorPointer& object) {
        const auto shown = object ? object->own_picture() : std::nullopt;
        if (!shown) {
            return nullptr;
        }
        return *camera::make_stage<camera::PictureMapper>("range", {{"u_first", shown->u_first},
                                                                    {"u_last", shown->u_last},
                                                                    {"v_first", shown->v_first},
                                                                    {"v_last", shown->v_last}});
    }

    // The path's own warps follow the camera's; its own moves precede the camera's.
    camera::Path path(const Statement& statement, bool& shares_map) {
        camera::Path made = shared_;
        if (!statement.stages().empty()) {
            made.generator = generator(statement.stages().front());
            shares_map = true;
            moves_[statement.kind] = statements_.stages(StatementKind::move);
            return made;
        }
        const Statements own(tree_, statement.block, reporter_);
        if (const Statement* object = own.find(StatementKind::object)) {
            made.generator = generator(object->stages().front());
        } else if (own.lacks(StatementKind::object)) {
            error(statement.keyword,
                  fmt::format("this '{}' has no object", keyword(statement.kind)),
                  "add one to its block, for example object sphere(1)");
        }
        if (own.lacks(StatementKind::map)) {
            shares_map = true;
        } else {
            made.mapper = build_map(own, tree_, stages_, reporter_);
        }
        const auto warps = list<camera::ParameterTransformer>(own, StatementKind::warp);
        made.parameter_transformers.insert(made.parameter_transformers.end(), warps.begin(),
                                           warps.end());
        const auto moves = list<camera::ObjectTransformer>(own, StatementKind::move);
        made.object_transformers.insert(made.object_transformers.begin(), moves.begin(),
                                        moves.end());
        std::vector<ExpressionId>& calls = moves_[statement.kind];
        calls = own.stages(StatementKind::move);
        const std::vector<ExpressionId> shared = statements_.stages(StatementKind::move);
        calls.insert(calls.end(), shared.begin(), shared.end());
        return made;
    }

    void require_map(const Statement& path) {
        if (!map_missed_) {
            map_missed_ = true;
            error(camera_.name.span,
                  fmt::format("the camera '{}' has no map for its '{}'", camera_.name.text,
                              keyword(path.kind)),
                  "specify which part of the object the picture shows, for example map u = -1 .. "
                  "1, v = square");
        }
    }

    camera::ObjectGeneratorPointer generator(ExpressionId call) {
        return stages_.make<camera::ObjectGenerator>(call);
    }

    // ------------------------------------------------------------------------------------ look

    void look(camera::Camera::Parts& parts) {
        const Statement* statement = statements_.find(StatementKind::look);
        const Statement* toward = statements_.find(StatementKind::toward);
        const Span span = statement != nullptr ? statement->span : camera_.name.span;
        if (statement != nullptr) {
            parts.look = stages_.make<camera::DirectionRule>(statement->stages().front());
        } else if (statements_.lacks(StatementKind::look) &&
                   (toward != nullptr || statements_.lacks(StatementKind::toward))) {
            parts.look = stages_.make<camera::DirectionRule>(
                toward != nullptr ? "relative" : "normal", std::span<const ExpressionId>(), span);
        }
    }

    void report_misfits(const camera::Camera::Parts& parts) {
        using Of = camera::Misfit::Of;
        const Statement* look = statements_.find(StatementKind::look);
        for (camera::Misfit& misfit : camera::misfits(parts)) {
            // A broken statement has been reported.
            if (misfit.of == Of::missing_toward && !statements_.lacks(StatementKind::toward)) {
                continue;
            }
            const Span span = misfit.of == Of::eye_move
                                  ? tree_[moves_[StatementKind::eye][misfit.move]].span
                              : misfit.of == Of::toward_move
                                  ? tree_[moves_[StatementKind::toward][misfit.move]].span
                              : look != nullptr ? look->span
                                                : camera_.name.span;
            misfit.diagnostic.span = tree_.at(span);
            reporter_.add(std::move(misfit.diagnostic));
        }
    }

    // -------------------------------------------------------------------- stereo, lens, bend, time

    void stereo(camera::Camera::Parts& parts) {
        if (const Statement* statement = statements_.find(StatementKind::stereo)) {
            parts.stereo = stages_.make<camera::StereoView>(statement->stages().front());
        }
    }

    void lens(camera::Camera::Parts& parts) {
        if (const Statement* statement = statements_.find(StatementKind::lens)) {
            parts.lens = stages_.make<camera::Lens>(statement->stages().front());
            parts.lens_span = tree_.at(statement->span);
        }
    }

    void bend(camera::Camera::Parts& parts) {
        if (const Statement* statement = statements_.find(StatementKind::bend)) {
            parts.bend = stages_.make<camera::Bend>(statement->stages().front());
            parts.bend_span = tree_.at(statement->span);
        }
    }

    void time(camera::Camera::Parts& parts) {
        if (const Statement* statement = statements_.find(StatementKind::time)) {
            parts.time = stages_.formula_of_picture(statement->value(), "the time of a camera");
        }
    }

    std::optional<camera::Camera> finish(camera::Camera::Parts parts) {
        Result<camera::Camera> made = camera::Camera::make(std::move(parts), session_.stop());
        for (Diagnostic& diagnostic : made.diagnostics) {
            if (!diagnostic.span.source) {
                diagnostic.span = tree_.at(camera_.name.span);
            }
            reporter_.add(std::move(diagnostic));
        }
        return made.value;
    }

    const LocatedDefinition place_;
    const SyntaxTree& tree_;
    const DefinitionSyntax& camera_;
    Scope& scope_;
    Session& session_;
    Reporter& reporter_;
    StageBuilder stages_;
    Statements statements_;
    camera::Path shared_;  // Statements at camera level.
    std::map<StatementKind, std::vector<ExpressionId>>
        moves_;  // Of the paths, by their statements.
    bool map_missed_ = false;
};

}  // namespace

std::optional<camera::Camera> build_camera(const LocatedDefinition& place,
                                           const GivenParameters& given, Session& session,
                                           bool warn_of_unused, std::vector<Value>* values) {
    const std::size_t errors_before = session.reporter().error_count();
    DefinitionScope scope(place, given, session);
    const std::vector<Value> parameters = scope.values();
    // Which names are used shows only while a camera is built.
    const Session::Built* made = warn_of_unused ? nullptr : session.built(place, parameters);
    if (made == nullptr) {
        made =
            &session.share(place, parameters, CameraBuilder(place, scope.names(), session).run());
    }
    if (session.reporter().error_count() > errors_before) {
        return std::nullopt;
    }
    if (warn_of_unused && session.reporter().error_count() == 0) {
        scope.warn_of_unused();
    }
    if (values != nullptr) {
        *values = parameters;
    }
    return *made ? std::optional(std::get<camera::Camera>(**made)) : std::nullopt;
}

}  // namespace balcony::lang
