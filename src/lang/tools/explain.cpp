// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Describes a camera or a picture: its statements in the order in which they apply to a picture
// point, with the meaning of each stage from the catalogue.

#include "lang/tools/explain.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/catalogue.hpp"
#include "lang/build/layers.hpp"
#include "lang/build/resolved_layer.hpp"
#include "lang/syntax/statement_rows.hpp"

namespace balcony::lang {

namespace {

using camera::StageKind;

// The source text, with single spaces and without comments.
std::string one_line(const SyntaxTree& tree, Span span) {
    std::string line;
    auto comment = std::partition_point(tree.comments.begin(), tree.comments.end(),
                                        [span](const Span& one) { return one.begin < span.begin; });
    for (std::size_t i = span.begin; i < span.end; ++i) {
        if (comment != tree.comments.end() && comment->begin == i) {
            i = comment->end - 1;
            ++comment;
            continue;
        }
        const char c = tree.source->text()[i];
        const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
        if (!blank) {
            line += c;
        } else if (!line.empty() && line.back() != ' ') {
            line += ' ';
        }
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

// ----------------------------------------------------------------------- meaning of a statement

using Meanings = std::vector<std::string>;

// The file to explain, and the stages that it may name.
struct Source {
    const SyntaxTree& tree;
    const camera::Catalogue& catalogue;
};

std::string meaning(const camera::StageEntry& row) {
    return fmt::format("{}: {}", row.name, row.meaning);
}

// The kind of stage that an argument of a stage is; none if it is something else, as a choice and a
// number are that have the name of a stage.
std::optional<StageKind> nested_kind(const camera::StageEntry& row, const Argument& argument) {
    for (const camera::StageParameter& parameter : row.parameters) {
        const auto* nested = parameter.as<camera::NestedStageParameter>();
        if (nested != nullptr && (!argument.name || argument.name->text == parameter.name)) {
            return nested->kind;
        }
    }
    return std::nullopt;
}

// The catalogue's meanings of a call and of the stages inside it, each once.
void add_stages(const Source& place, ExpressionId call, StageKind kind, Meanings& found) {
    const Expression& node = place.tree[call];
    const bool may_be_stage = node.kind == ExpressionKind::call ||
                              node.kind == ExpressionKind::name ||
                              node.kind == ExpressionKind::formula;
    const camera::StageEntry* row =
        may_be_stage ? place.catalogue.find(kind, node.name.text) : nullptr;
    if (row == nullptr) {
        return;
    }
    if (std::find(found.begin(), found.end(), meaning(*row)) == found.end()) {
        found.push_back(meaning(*row));
    }
    if (node.kind == ExpressionKind::formula) {
        return;
    }
    for (const Argument& argument : node.arguments) {
        if (const std::optional<StageKind> nested = nested_kind(*row, argument)) {
            add_stages(place, argument.value, *nested, found);
        }
    }
}

Meanings of_ranges(const Statement& statement) {
    Meanings found;
    for (const MapRange& range : statement.ranges()) {
        const bool u = range.coordinate.text == "u";
        found.push_back(
            range.first.valid()
                ? fmt::format("{} runs from the {} edge of the picture to the {}",
                              range.coordinate.text, u ? "left" : "bottom", u ? "right" : "top")
                : fmt::format("{} is 0 in the centre, with square pixels", range.coordinate.text));
    }
    return found;
}

Meanings of_blend(const SyntaxTree& tree, const Statement& statement) {
    if (!statement.stages().empty()) {
        return {tree[statement.stages().front()].name.text == "depth"
                    ? "depth: the nearest of such layers along the rays of the master camera, that "
                      "of the layer behind them, is in front"
                    : "weight: its part of the sum of the weights of such layers that follow each "
                      "other"};
    }
    const std::string_view name = statement.word().text;
    const auto mode = camera::blend_modes().find(name).value_or(camera::BlendMode::normal);
    return {fmt::format("{}: {}", name, camera::blend_modes()[mode].meaning)};
}

Meanings meanings(const Source& place, const StatementRow& row, const Statement& statement) {
    if (!row.meaning.empty()) {
        return {std::string(row.meaning)};
    }
    if (row.shape == Shape::ranges) {
        return of_ranges(statement);
    }
    if (row.shape == Shape::blend) {
        return of_blend(place.tree, statement);
    }
    Meanings found;
    for (const ExpressionId call : statement.stages()) {
        add_stages(place, call, *row.stage_kind, found);
    }
    return found;
}

void add_steps(const Source& place, const std::vector<Statement>& statements, std::size_t depth,
               std::vector<Explanation::Step>& made) {
    std::vector<std::pair<const StatementRow*, const Statement*>> ordered;
    for (const Statement& statement : statements) {
        const StatementRow* row = row_of(statement.kind);
        if (row != nullptr && row->phase) {
            ordered.emplace_back(row, &statement);
        }
    }
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const auto& a, const auto& b) { return a.first->phase < b.first->phase; });
    for (const auto& [row, statement] : ordered) {
        Explanation::Step step;
        step.depth = depth;
        step.statement = std::string(row->keyword);
        if (statement->block.empty()) {
            step.written = one_line(place.tree, {statement->keyword.end, statement->span.end});
        }
        step.meanings = meanings(place, *row, *statement);
        made.push_back(std::move(step));
        add_steps(place, statement->block, depth + 1, made);
    }
}

// --------------------------------------------------------------------------------- the whole

// The lets of a camera or picture, and those of its file that it uses, in the order of the file.
std::vector<std::string> definitions_of(const SyntaxTree& tree, const DefinitionSyntax& of) {
    std::set<std::string_view> used;
    for (const Expression& node : tree.expressions) {
        if (of.span.begin <= node.span.begin && node.span.end <= of.span.end) {
            used.insert(node.name.text);
        }
    }
    std::vector<std::string> found;
    const auto add = [&](const Statement& let) {
        found.push_back(one_line(tree, {let.keyword.end, let.span.end}));
    };
    for (auto statement = of.statements.rbegin(); statement != of.statements.rend(); ++statement) {
        if (statement->kind == StatementKind::let) {
            add(*statement);
        }
    }
    for (auto item = tree.items.rbegin(); item != tree.items.rend(); ++item) {
        const auto* let = std::get_if<Statement>(&*item);
        if (let == nullptr || !used.contains(let->let().name.text)) {
            continue;
        }
        add(*let);
        const ExpressionId value = let->let().value;
        for (std::size_t i = tree[value].first.value(); i <= value.value(); ++i) {
            used.insert(tree.expressions[i].name.text);
        }
    }
    std::reverse(found.begin(), found.end());
    return found;
}

// The origins and directions of the rays in one sentence.
std::string summary_of(const camera::Camera& camera) {
    const auto place = [](int dimension) {
        return dimension == 0 ? "at a point" : dimension == 1 ? "on a curve" : "on a surface";
    };
    const camera::Camera::Parts& parts = camera.parts();
    std::string text = fmt::format("Rays start {}{}", place(parts.eye.generator->dimension()),
                                   parts.stereo ? ", moved aside to an eye of a pair" : "");
    if (parts.toward) {
        const int dimension = parts.toward->generator->dimension();
        text += fmt::format("; a {} contributes to their directions", dimension == 0   ? "point"
                                                                      : dimension == 1 ? "curve"
                                                                                       : "surface");
    } else {
        text += "; the same object determines their directions";
    }
    return text + ".";
}

std::string summary_of(const camera::Picture& picture) {
    const camera::Picture::Parts& parts = picture.parts();
    const std::string layers =
        fmt::format("{} layer{}", parts.layers.size(), parts.layers.size() == 1 ? "" : "s");
    return parts.size ? fmt::format("A picture of {} x {} pixels in {}.", (*parts.size)[0],
                                    (*parts.size)[1], layers)
                      : fmt::format("A picture in {}, with an aspect ratio of {:.4g}.", layers,
                                    picture.aspect());
}

class Explainer {
public:
    explicit Explainer(Session& session) : session_(session) {}

    Explanation camera(const LocatedDefinition& place, const camera::Camera& camera,
                       const GivenParameters& given) {
        DefinitionScope scope(place, given, session_);
        Explanation made = heading(place, scope, summary_of(camera));
        add_steps({place.module->tree, session_.catalogue()}, place.camera->statements, 0,
                  made.steps);
        const auto has = [&](std::string_view statement) {
            return std::any_of(
                made.steps.begin(), made.steps.end(),
                [statement](const Explanation::Step& step) { return step.statement == statement; });
        };
        if (has("morph")) {
            made.summary = "Rays are those of a camera between two others.";
            add_morphed(place, scope.names(), made.steps);
        } else if (!has("look")) {
            const std::string_view rule = camera.parts().toward ? "relative" : "normal";
            const auto* row = session_.catalogue().find(StageKind::direction_rule, rule);
            made.steps.push_back({"look", std::string(rule), {meaning(*row)}, 0});
        }
        return made;
    }

    Explanation picture(const LocatedDefinition& place, const camera::Picture& picture,
                        const GivenParameters& given) {
        DefinitionScope scope(place, given, session_);
        Explanation made = heading(place, scope, summary_of(picture));
        const SyntaxTree& tree = place.module->tree;
        visit_layers(place, scope.names(), session_, [&](const LayerPlace& layer) {
            const Expression& call = tree[layer.statement.stages().front()];
            const std::string where = layer.where.empty() ? "" : fmt::format(" ({})", layer.where);
            Explanation::Layer told{one_line(tree, call.span) + where, {}, 0};
            add_steps({tree, session_.catalogue()}, layer.statement.block, 0, told.steps);
            if (const auto content = resolve_layer(place, call, layer.names, session_)) {
                told.shows = show(*content, picture.parts().layers[made.layers.size()]);
            }
            made.layers.push_back(std::move(told));
            return true;
        });
        return made;
    }

    std::vector<Explanation> take_shown() { return std::move(shown_); }

private:
    static Explanation heading(const LocatedDefinition& place, DefinitionScope& scope,
                               std::string summary) {
        Explanation made;
        made.name = std::string(place.name());
        made.is_picture = place.camera->is_picture;
        made.summary = std::move(summary);
        const std::vector<Value> values = scope.values();
        for (std::size_t i = 0; i < values.size(); ++i) {
            made.parameters.push_back(
                {std::string(place.camera->parameters[i].name.text), value_text(values[i])});
        }
        made.definitions = definitions_of(place.module->tree, *place.camera);
        return made;
    }

    // The statements of both cameras, behind that of the morph.
    void add_morphed(const LocatedDefinition& place, Scope& names,
                     std::vector<Explanation::Step>& steps) {
        const auto morph =
            std::find_if(place.camera->statements.begin(), place.camera->statements.end(),
                         [](const Statement& one) { return one.kind == StatementKind::morph; });
        const SyntaxTree& tree = place.module->tree;
        const std::vector<Argument>& arguments = tree[morph->stages().front()].arguments;
        std::vector<Explanation::Step> both;
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
            const Expression& call = tree[arguments[i].value];
            const auto found = resolve_layer(place, call, names, session_);
            if (!found) {
                continue;
            }
            both.push_back({i == 0 ? "from" : "to",
                            one_line(tree, call.span),
                            {fmt::format("the camera where the amount is {}", i)},
                            1});
            add_steps({found->place.module->tree, session_.catalogue()},
                      found->place.camera->statements, 2, both);
        }
        const auto at = std::find_if(steps.begin(), steps.end(), [](const Explanation::Step& step) {
            return step.statement == "morph";
        });
        steps.insert(at + 1, both.begin(), both.end());
    }

    // The index of a layer's camera or picture, which is explained at its first occurrence.
    std::size_t show(const ResolvedLayer& content, const camera::Layer& layer) {
        const auto* nested = std::get_if<std::shared_ptr<const camera::Picture>>(&layer.content);
        const auto* single = std::get_if<camera::Camera>(&layer.content);
        const void* identity = nested != nullptr ? static_cast<const void*>(nested->get())
                                                 : static_cast<const void*>(&single->parts());
        if (const auto known = numbers_.find(identity); known != numbers_.end()) {
            return known->second;
        }
        Explanation made = nested != nullptr ? picture(content.place, **nested, content.given)
                                             : camera(content.place, *single, content.given);
        numbers_.emplace(identity, shown_.size());
        shown_.push_back(std::move(made));
        return shown_.size() - 1;
    }

    Session& session_;
    std::map<const void*, std::size_t> numbers_;
    std::vector<Explanation> shown_;
};

}  // namespace

Explanation explain(const LocatedDefinition& place, const camera::Picture& picture,
                    const GivenParameters& given, Session& session) {
    Explainer explainer(session);
    if (const camera::Camera* camera = picture.only_camera()) {
        return explainer.camera(place, *camera, given);
    }
    Explanation made = explainer.picture(place, picture, given);
    made.shown = explainer.take_shown();
    return made;
}

}  // namespace balcony::lang
