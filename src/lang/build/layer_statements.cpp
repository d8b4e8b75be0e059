// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/build/layer_statements.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "lang/build/statements.hpp"
#include "lang/syntax/statement_rows.hpp"

namespace balcony::lang {

namespace {

using camera::NumberParameter;
using camera::PairParameter;
using camera::StageEntry;
using camera::StageParameter;
using camera::TripleParameter;

// Rows for what layers are told as numbers, to be checked as the arguments of stages are.

StageParameter number_from_0_to_1(std::string_view name, std::string_view meaning) {
    return {.name = name,
            .type = NumberParameter{.range = {.minimum = 0.0, .maximum = 1.0}},
            .optional = true,
            .meaning = meaning};
}

const StageEntry& layer_row() {
    static const StageEntry row{
        .name = "layer",
        .parameters = {number_from_0_to_1("soft", "width of the clip's soft edge"),
                       number_from_0_to_1("alpha", "opacity")}};
    return row;
}

const StageEntry& frame_row() {
    static const StageEntry row{
        .name = "frame",
        .parameters = {{.name = "width",
                        .type = NumberParameter{.default_value = 0.004,
                                                .range = {.minimum = 0.0, .maximum = 1.0}},
                        .meaning = "as a fraction of the picture's height"},
                       {.name = "color",
                        .type = TripleParameter{.default_value = std::array{1.0, 1.0, 1.0},
                                                .range = {.minimum = 0.0}},
                        .meaning = "red, green and blue in linear light"}}};
    return row;
}

const StageEntry& scale_bar_row() {
    static const StageEntry row{
        .name = "scale_bar",
        .parameters = {
            {.name = "length",
             .type = NumberParameter{.range = {.minimum = 0.0, .excludes_minimum = true}},
             .meaning = "in scene units"},
            {.name = "at",
             .type = PairParameter{.default_value = std::array{0.03, 0.95}},
             .meaning = "the middle of its left end, as fractions of the layer's own "
                        "picture from its top left corner"},
            {.name = "height",
             .type =
                 NumberParameter{.default_value = 0.015, .range = {.minimum = 0.0, .maximum = 1.0}},
             .meaning = "as a fraction of this picture's height"}}};
    return row;
}

StageParameter weights(std::string_view name, std::array<double, 3> own) {
    return {.name = name,
            .type = TripleParameter{.default_value = own, .constant = true},
            .meaning = "weights of the layer's red, green and blue"};
}

const StageEntry& channels_row() {
    static const StageEntry row{
        .name = "channels",
        .parameters = {weights("red", {1.0, 0.0, 0.0}), weights("green", {0.0, 1.0, 0.0}),
                       weights("blue", {0.0, 0.0, 1.0})}};
    return row;
}

const StageEntry& region_row() {
    static const StageEntry row{
        .name = "region",
        .parameters = {{.name = "from", .type = PairParameter{}, .meaning = "top left corner"},
                       {.name = "to", .type = PairParameter{}, .meaning = "bottom right corner"}}};
    return row;
}

class LayerReader {
public:
    LayerReader(const Module& module, const Statement& layer, Scope& names, Session& session)
        : tree_(module.tree),
          reporter_(session.reporter()),
          stages_(module, names, session),
          block_(layer.block),
          own_(tree_, layer.block, reporter_) {}

    bool read(camera::Layer& made) {
        const std::size_t errors_before = reporter_.error_count();
        made.arrangers = make_arrangers(block_, {StatementKind::place}, stages_);
        made.inner_arrangers = make_arrangers(block_, {StatementKind::arrange}, stages_);
        const Statement* clip = own_.find(StatementKind::clip);
        if (clip != nullptr) {
            made.clip = stages_.make<camera::ClipShape>(clip->stages().front());
        }
        numbers(made);
        channels(made);
        blend(made);
        fit(made);
        show(made);
        strokes(made);
        const bool good_view = stereo(made);
        const auto has_all = [](const auto& arrangers) {
            return std::find(arrangers.begin(), arrangers.end(), nullptr) == arrangers.end();
        };
        // What is null has been reported, perhaps at an earlier use.
        return reporter_.error_count() == errors_before && has_all(made.arrangers) &&
               has_all(made.inner_arrangers) && (clip == nullptr || made.clip) && good_view;
    }

private:
    void error(Span span, std::string message, std::string remedy = {}) {
        reporter_.error(tree_.at(span), std::move(message), std::move(remedy));
    }

    void numbers(camera::Layer& made) {
        std::array<ExpressionId, 2> values;
        Span span;
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
            const Statement* statement =
                own_.find(i == 0 ? StatementKind::soft : StatementKind::alpha);
            if (statement != nullptr) {
                values[i] = statement->value();
                span = statement->span;
            }
        }
        if (const auto given = stages_.arguments(layer_row(), values, span)) {
            made.softness = given->has("soft") ? given->number("soft") : made.softness;
            made.alpha = given->has("alpha") ? given->number("alpha") : made.alpha;
        }
    }

    void channels(camera::Layer& made) {
        const Statement* statement = own_.find(StatementKind::channels);
        if (statement == nullptr) {
            return;
        }
        if (const auto given =
                stages_.arguments(channels_row(), tree_[statement->stages().front()])) {
            const auto row = [&given](std::string_view name) {
                const std::array<camera::Scalar, 3> weights = given->triple(name);
                return std::array{*weights[0].constant(), *weights[1].constant(),
                                  *weights[2].constant()};
            };
            made.channels = camera::ColorMatrix{row("red"), row("green"), row("blue")};
        }
    }

    // False if the view or the layer's content has an error, which is reported.
    bool stereo(camera::Layer& made) {
        const Statement* statement = own_.find(StatementKind::stereo);
        if (statement == nullptr) {
            return true;
        }
        const auto view = stages_.make<camera::StereoView>(statement->stages().front());
        const auto* picture = std::get_if<std::shared_ptr<const camera::Picture>>(&made.content);
        if (!view || (picture != nullptr && !*picture)) {
            return false;
        }
        auto seen = camera::with_stereo(made.content, view);
        for (Diagnostic& diagnostic : seen.diagnostics) {
            diagnostic.span = tree_.at(statement->keyword);
            reporter_.add(std::move(diagnostic));
        }
        if (seen) {
            made.content = std::move(*seen);
        }
        return seen.value.has_value();
    }

    void blend(camera::Layer& made) {
        const Statement* statement = own_.find(StatementKind::blend);
        if (statement == nullptr) {
            return;
        }
        if (!statement->stages().empty()) {
            blend_by(tree_[statement->stages().front()], made);
            return;
        }
        const auto mode = camera::blend_modes().find(statement->word().text);
        if (!mode) {
            error(statement->word().span,
                  fmt::format("unknown blend mode '{}'", statement->word().text),
                  suggestion(statement->word().text, camera::blend_modes().all(),
                             "the blend modes are"));
        }
        made.blend = mode.value_or(camera::BlendMode::normal);
    }

    void blend_by(const Expression& what, camera::Layer& made) {
        if (what.kind == ExpressionKind::name && what.name.text == "depth") {
            made.compositing = camera::Compositing::depth;
        } else if (what.kind == ExpressionKind::call && what.name.text == "weight" &&
                   what.arguments.size() == 1 && !what.arguments.front().name) {
            made.compositing = camera::Compositing::weight;
            made.weight =
                stages_.formula_of_picture(what.arguments.front().value, "the weight of a layer");
        } else {
            error(what.span, fmt::format("layers cannot be blended by '{}'", tree_.text(what.span)),
                  "write blend by depth, blend by weight(1 - x), or a blend mode");
        }
    }

    // The region, and the objects that are shown and hidden.
    void show(camera::Layer& made) {
        const Statement* earlier = nullptr;
        for (const Statement& one : block_) {
            const bool shows = one.kind == StatementKind::show;
            if (one.broken || (!shows && one.kind != StatementKind::hide)) {
                continue;
            }
            if (one.corners() == nullptr) {
                made.objects.push_back(objects(tree_[one.stages().front()], shows));
            } else if (earlier != nullptr) {
                reporter_.add(occurs_again("show", tree_, one.keyword, earlier->keyword));
            } else {
                earlier = &one;
                made.show = region(*one.corners());
            }
        }
    }

    camera::ObjectChoice objects(const Expression& call, bool shows) {
        camera::ObjectChoice made{shows, {}};
        for (const Argument& argument : call.arguments) {
            const Expression& name = tree_[argument.value];
            if (argument.name || name.kind != ExpressionKind::text || name.name.text.empty()) {
                error(name.span, "expected the name of an object of the scene",
                      "write names in quotation marks: objects(\"vase*\", \"table\")");
                continue;
            }
            made.patterns.push_back({std::string(name.name.text), tree_.at(name.name.span)});
        }
        if (call.arguments.empty()) {
            error(call.span, "no objects are named",
                  "write names in quotation marks: objects(\"vase*\", \"table\")");
        }
        return made;
    }

    // fit, fill or stretch.
    void fit(camera::Layer& made) {
        const Statement* earlier = nullptr;
        for (const Statement& one : block_) {
            const auto fit = camera::fits().find(keyword(one.kind));
            if (!fit || one.broken) {
                continue;
            }
            if (earlier != nullptr && earlier->kind != one.kind) {
                Diagnostic diagnostic = balcony::error(
                    fmt::format("'{}' contradicts '{}'", keyword(one.kind), keyword(earlier->kind)),
                    tree_.at(one.keyword), "remove one of them");
                diagnostic.notes.push_back({tree_.at(earlier->keyword), "the other one"});
                reporter_.add(std::move(diagnostic));
            }
            earlier = &one;
            made.fit = *fit;
        }
    }

    std::optional<camera::PictureRegion> region(const Corners& corners) {
        const auto given =
            stages_.arguments(region_row(), std::array{corners.first, corners.last}, corners.span);
        if (!given) {
            return std::nullopt;
        }
        camera::PictureRegion made{given->pair("from"), given->pair("to")};
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
            const auto first = made.from[i].constant();
            const auto last = made.to[i].constant();
            if (first && last && *last <= *first) {
                error(corners.span, "this region has no area",
                      "write its top left corner first, then its bottom right corner");
                return std::nullopt;
            }
        }
        return made;
    }

    // Leader lines are drawn as the frame is.
    void strokes(camera::Layer& made) {
        camera::Stroke stroke;
        if (const Statement* frame = own_.find(StatementKind::frame)) {
            if (const auto given = stages_.arguments(frame_row(), tree_[frame->stages().front()])) {
                stroke = {given->number("width"), given->triple("color")};
            }
            made.frame = stroke;
        }
        if (const Statement* bar = own_.find(StatementKind::scale_bar)) {
            if (const auto given =
                    stages_.arguments(scale_bar_row(), tree_[bar->stages().front()])) {
                made.scale_bar = {given->number("length"), given->pair("at"),
                                  given->number("height")};
            }
        }
        for (const Statement& one : block_) {
            if (one.kind != StatementKind::leader || one.broken) {
                continue;
            }
            if (const Corners* corners = one.corners()) {
                if (auto to = leader_region(*corners)) {
                    made.leaders.push_back({std::move(to), stroke});
                }
            } else if (!made.show && !is_broken(StatementKind::show)) {
                error(one.span, "this leader has no corners, and its layer has no 'show'",
                      "write leader (0.2, 0.1) .. (0.4, 0.3) for a region of the picture, or show "
                      "a region of the layer");
            } else {
                made.leaders.push_back({std::nullopt, stroke});
            }
        }
    }

    [[nodiscard]] bool is_broken(StatementKind kind) const {
        return own_.find(kind) == nullptr && !own_.lacks(kind);
    }

    std::optional<camera::PictureRegion> leader_region(const Corners& corners) {
        const auto given =
            stages_.arguments(region_row(), std::array{corners.first, corners.last}, corners.span);
        return given ? std::optional(camera::PictureRegion{given->pair("from"), given->pair("to")})
                     : std::nullopt;
    }

    const SyntaxTree& tree_;
    Reporter& reporter_;
    StageBuilder stages_;
    const std::vector<Statement>& block_;
    const Statements own_;
};

}  // namespace

bool read_layer(const Module& module, const Statement& layer, Scope& names, Session& session,
                camera::Layer& made) {
    return LayerReader(module, layer, names, session).read(made);
}

}  // namespace balcony::lang
