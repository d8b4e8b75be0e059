// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A camera in words: its statements in the order in which a picture point goes through them, with
// what the catalogue says of each stage.

#include "lang/explain.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/format.h>

#include "balcony/catalogue.hpp"
#include "lang/camera_scope.hpp"
#include "lang/keywords.hpp"

namespace balcony::lang {

namespace {

using camera::StageKind;

// The statements that are made of stages, in the order of the abstract camera machine.
struct PipelineRow {
    StatementKind statement;
    StageKind stage;
};
constexpr std::array pipeline = {
    PipelineRow{StatementKind::place, StageKind::picture_arranger},
    PipelineRow{StatementKind::arrange, StageKind::picture_arranger},
    PipelineRow{StatementKind::map, StageKind::picture_mapper},
    PipelineRow{StatementKind::warp, StageKind::parameter_transformer},
    PipelineRow{StatementKind::object, StageKind::object_generator},
    PipelineRow{StatementKind::eye, StageKind::object_generator},
    PipelineRow{StatementKind::toward, StageKind::object_generator},
    PipelineRow{StatementKind::move, StageKind::object_transformer},
    PipelineRow{StatementKind::look, StageKind::direction_rule},
};

std::string value_text(const Value& value) {
    if (value.elements) {
        std::vector<std::string> texts;
        for (const Element& element : *value.elements) {
            texts.push_back(value_text(element.value));
        }
        const bool list = value.form == Value::Form::list;
        return fmt::format("{}{}{}", list ? "[" : "(", fmt::join(texts, ", "), list ? "]" : ")");
    }
    if (!value.is_constant()) {
        return "changes with time";
    }
    return value.is_angle() ? fmt::format("{:.6g}deg", value.constant() * 180.0 / std::numbers::pi)
                            : fmt::format("{:.6g}", value.constant());
}

class Explainer {
public:
    Explainer(const SyntaxTree& tree, Explanation& made) : tree_(tree), made_(made) {}

    void statements(const std::vector<Statement>& all, std::size_t depth) {
        for (const PipelineRow& row : pipeline) {
            for (const Statement& statement : all) {
                if (statement.kind == row.statement) {
                    this->statement(statement, row.stage, depth);
                }
            }
        }
    }

private:
    void statement(const Statement& statement, StageKind kind, std::size_t depth) {
        Explanation::Step step;
        step.depth = depth;
        step.statement = std::string(keyword(statement.kind));
        if (statement.block.empty()) {
            step.written = one_line({statement.keyword.end, statement.span.end});
        }
        if (statement.kind == StatementKind::map) {
            step.meanings = map_meanings(statement);
        } else if (statement.kind == StatementKind::place) {
            const camera::StageEntry& row = *find_row(kind, "place");
            step.meanings.push_back(fmt::format("{}: {}", row.name, row.meaning));
        }
        for (const ExpressionId call : statement.stages) {
            stage_meanings(call, kind, step.meanings);
        }
        made_.steps.push_back(std::move(step));
        statements(statement.block, depth + 1);
    }

    static std::vector<std::string> map_meanings(const Statement& statement) {
        std::vector<std::string> said;
        for (const MapRange& range : statement.ranges) {
            const bool u = range.coordinate.text == "u";
            said.push_back(range.first.valid()
                               ? fmt::format("{} goes from the {} edge of the picture to the {}",
                                             range.coordinate.text, u ? "left" : "bottom",
                                             u ? "right" : "top")
                               : fmt::format("{} is 0 in the middle, with square pixels",
                                             range.coordinate.text));
        }
        return said;
    }

    // What the catalogue says of a call and of the stages inside it, each name once.
    void stage_meanings(ExpressionId call, StageKind kind, std::vector<std::string>& said) const {
        for (std::size_t i = call.value() + 1; i-- > tree_[call].first.value();) {
            const Expression& node = tree_[ExpressionId(i)];
            const bool may_be_stage = node.kind == ExpressionKind::call ||
                                      node.kind == ExpressionKind::name ||
                                      node.kind == ExpressionKind::formula;
            const camera::StageEntry* row = may_be_stage ? find_row(kind, node.name.text) : nullptr;
            if (row != nullptr) {
                std::string meaning = fmt::format("{}: {}", row->name, row->meaning);
                if (std::find(said.begin(), said.end(), meaning) == said.end()) {
                    said.push_back(std::move(meaning));
                }
            }
        }
    }

    // A stage inside another is mostly of its kind.
    static const camera::StageEntry* find_row(StageKind kind, std::string_view name) {
        if (const camera::StageEntry* row = camera::find_stage(kind, name)) {
            return row;
        }
        for (const camera::StageEntry& row : camera::catalogue()) {
            if (row.name == name) {
                return &row;
            }
        }
        return nullptr;
    }

    // What is written, with single spaces and without comments.
    [[nodiscard]] std::string one_line(Span span) const {
        std::string line;
        for (std::size_t i = span.begin; i < span.end; ++i) {
            const auto comment = std::find_if(tree_.comments.begin(), tree_.comments.end(),
                                              [i](const Span& one) { return one.begin == i; });
            if (comment != tree_.comments.end()) {
                i = comment->end - 1;
                continue;
            }
            const char c = tree_.source->text()[i];
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

    const SyntaxTree& tree_;
    Explanation& made_;
};

// Where rays start and where they go, in one sentence.
std::string summary_of(const camera::Camera& camera) {
    const auto place = [](int dimension) {
        return dimension == 0 ? "at a point" : dimension == 1 ? "on a curve" : "on a surface";
    };
    const camera::Camera::Parts& parts = camera.parts();
    std::string text = fmt::format("Rays start {}", place(parts.eye.generator->dimension()));
    if (parts.toward) {
        const int dimension = parts.toward->generator->dimension();
        text += fmt::format("; a {} helps to give their directions", dimension == 0   ? "point"
                                                                     : dimension == 1 ? "curve"
                                                                                      : "surface");
    } else {
        text += "; the same object gives their directions";
    }
    return text + ".";
}

}  // namespace

Explanation explain_camera(const CameraPlace& place, const camera::Camera& camera,
                           const std::vector<Override>& overrides, Session& session) {
    Explanation made;
    made.name = camera.name();
    made.summary = summary_of(camera);
    CameraScope scope(place, {overrides, {}}, session);
    for (const CameraParameter& parameter : place.camera->parameters) {
        made.parameters.push_back({std::string(parameter.name.text),
                                   value_text(scope.names().find(parameter.name.text)->value)});
    }
    Explainer(place.module->tree, made).statements(place.camera->statements, 0);
    const bool has_look =
        std::any_of(made.steps.begin(), made.steps.end(),
                    [](const Explanation::Step& step) { return step.statement == "look"; });
    if (!has_look) {
        const std::string_view rule = camera.parts().toward ? "relative" : "normal";
        const auto* row = camera::find_stage(StageKind::direction_rule, rule);
        made.steps.push_back(
            {"look", std::string(rule), {fmt::format("{}: {}", rule, row->meaning)}, 0});
    }
    return made;
}

}  // namespace balcony::lang
