// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The values that stages are given: numbers, tuples, words, points and nested stages.

#include <algorithm>

#include <fmt/format.h>

#include "lang/build/stages.hpp"
#include "lang/names/evaluate.hpp"
#include "lang/names/function_calls.hpp"

namespace balcony::lang {

namespace {

using camera::ArgumentValue;
using camera::Failed;
using camera::Unsuitable;

/// The function for the type of a parameter.
template <class... Functions>
struct OneOf : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
OneOf(Functions...) -> OneOf<Functions...>;

bool may_be_stage(const Expression& node) {
    return node.kind == ExpressionKind::name || node.kind == ExpressionKind::call ||
           node.kind == ExpressionKind::formula;
}

// An expression in the words of a message.
std::string_view described(const Expression& node) {
    switch (node.kind) {
        case ExpressionKind::tuple: return "a tuple";
        case ExpressionKind::list: return "a list";
        case ExpressionKind::text: return "a file name";
        case ExpressionKind::formula: return "a formula";
        default: return "a number";
    }
}

}  // namespace

StageBuilder::Located StageBuilder::value(const camera::StageParameter& parameter,
                                          std::span<const ExpressionId> given) {
    const ExpressionId first = given.front();
    const OneOf reader{
        [&](const camera::NumberParameter&) { return number(first); },
        [&](const camera::CountParameter&) { return number(first); },
        [&](const camera::PairParameter& type) { return numbers(first, type.one_for_both, false); },
        [&](const camera::TripleParameter& type) { return numbers(first, false, type.names_axes); },
        [&](const camera::ChoiceParameter&) { return word(first); },
        [&](const camera::PointsParameter& type) { return points(type, first); },
        [&](const camera::NestedStageParameter& type) { return stages(type, given); },
        [&](const camera::FormulaParameter& type) {
            return formula(parameter.name, type.shape, tree_[first]);
        },
        [&](const camera::NameParameter&) { return quoted(first); },
        [&](const camera::ImageParameter&) { return contents<data::read_grey_image>(first); },
        [&](const camera::MeshParameter&) { return contents<data::read_mesh>(first); },
        [&](const camera::MapParameter& type) {
            return type.content == camera::MapParameter::Content::rays
                       ? contents<data::read_ray_map>(first)
                       : contents<data::read_st_map>(first);
        },
        [&](const camera::CalibrationParameter&) {
            return contents<data::read_calibration>(first);
        },
        [&](const camera::PrescriptionParameter&) {
            return contents<data::read_prescription>(first);
        },
    };
    return std::visit(reader, parameter.type);
}

StageBuilder::Located StageBuilder::unsuitable(ExpressionId given) {
    const Expression& node = tree_[given];
    return {Unsuitable{std::string(described(node))}, {tree_.at(node.span)}};
}

// ------------------------------------------------------------------------------------- numbers

camera::Scalar StageBuilder::scalar(const Value& value) const {
    return {camera::Formula(graph_, {}, {value.expr}), value.unit};
}

camera::Tuple StageBuilder::tuple(const Value& value) const {
    camera::Tuple made;
    for (const Element& element : *value.elements) {
        made.push_back(scalar(element.value));
    }
    return made;
}

StageBuilder::Written StageBuilder::place_of(const Value& value, const SourceSpan& span) {
    Written made{span};
    if (value.elements) {
        for (const Element& element : *value.elements) {
            made.parts.push_back(place_of(element.value, element.place));
        }
    }
    return made;
}

StageBuilder::Located StageBuilder::located(const Value& value, const SourceSpan& span) const {
    if (value.failed()) {
        return {Failed{}, {span}};
    }
    switch (value.form) {
        case Value::Form::number: return {scalar(value), {span}};
        case Value::Form::tuple: return {tuple(value), place_of(value, span)};
        case Value::Form::list: break;
    }
    return {Unsuitable{"a list"}, {span}};
}

StageBuilder::Located StageBuilder::number(ExpressionId given) {
    return located(evaluate_any(tree_, given, scope_, session_.context()),
                   tree_.at(tree_[given].span));
}

StageBuilder::Located StageBuilder::numbers(ExpressionId given, bool one_for_all, bool names_axes) {
    const Expression& node = tree_[given];
    const SourceSpan span = tree_.at(node.span);
    if (const auto axis = names_axes ? named_axis(node) : std::nullopt) {
        return {*axis, {span}};
    }
    if (const auto several = evaluate_compound(tree_, given, scope_, session_.context())) {
        return located(*several, span);
    }
    if (one_for_all) {
        return number(given);
    }
    return unsuitable(given);
}

// x or -x.
std::optional<std::string> StageBuilder::named_axis(const Expression& node) {
    const bool negative = node.kind == ExpressionKind::operation && node.name.text == "-" &&
                          node.arguments.size() == 1;
    const Expression& named = negative ? tree_[node.arguments[0].value] : node;
    const bool is_axis =
        named.kind == ExpressionKind::name &&
        (named.name.text == "x" || named.name.text == "y" || named.name.text == "z");
    return is_axis ? std::optional(fmt::format("{}{}", negative ? "-" : "", named.name.text))
                   : std::nullopt;
}

// -------------------------------------------------------------------------------------- points

StageBuilder::Located StageBuilder::points(const camera::PointsParameter& type,
                                           ExpressionId given) {
    const Expression& node = tree_[given];
    const SourceSpan span = tree_.at(node.span);
    if (node.kind == ExpressionKind::text) {
        return table(type, given);
    }
    // An unknown name is reported as missing; anything that cannot be a value, as not being a list.
    if (node.kind != ExpressionKind::list && node.kind != ExpressionKind::name &&
        node.kind != ExpressionKind::element && !calls_let(node, scope_)) {
        return unsuitable(given);
    }
    const Value list = evaluate_any(tree_, given, scope_, session_.context());
    if (list.failed()) {
        return {Failed{}, {span}};
    }
    if (list.form != Value::Form::list) {
        return unsuitable(given);
    }
    camera::Points made;
    for (const Element& element : *list.elements) {
        made.push_back(element.value.elements ? tuple(element.value)
                                              : camera::Tuple{scalar(element.value)});
    }
    return {std::move(made), place_of(list, span)};
}

// ---------------------------------------------------------------------------- words and stages

StageBuilder::Located StageBuilder::word(ExpressionId given) {
    const Expression& node = tree_[given];
    return node.kind == ExpressionKind::name
               ? Located{std::string(node.name.text), {tree_.at(node.span)}}
               : unsuitable(given);
}

StageBuilder::Located StageBuilder::quoted(ExpressionId given) {
    const Expression& node = tree_[given];
    return node.kind == ExpressionKind::text
               ? Located{std::string(node.name.text), {tree_.at(node.span)}}
               : unsuitable(given);
}

// Whether an expression can only be a number where a stage or a number may stand.
bool StageBuilder::is_number(camera::StageKind kind, const Expression& node) {
    switch (node.kind) {
        case ExpressionKind::number:
        case ExpressionKind::operation:
        case ExpressionKind::element: return true;
        case ExpressionKind::name: return scope_.find(node.name.text) != nullptr;
        case ExpressionKind::call:
            return session_.catalogue().find(kind, node.name.text) == nullptr &&
                   (is_function(node.name.text) || scope_.find(node.name.text) != nullptr);
        default: return false;
    }
}

StageBuilder::Located StageBuilder::stages(const camera::NestedStageParameter& type,
                                           std::span<const ExpressionId> given) {
    if (!type.of_number.empty() && is_number(type.kind, tree_[given.front()])) {
        return number(given.front());
    }
    Located made{Failed{}, {tree_.at(tree_[given.front()].span)}};
    ArgumentValue::Stages stages;
    for (const ExpressionId id : given) {
        if (!may_be_stage(tree_[id])) {
            return unsuitable(id);
        }
        if (Stage stage = make_stage(type.kind, id)) {
            stages.push_back(std::move(stage));
        }
        made.place.parts.push_back({tree_.at(tree_[id].span)});
    }
    if (stages.size() < given.size()) {
        return made;
    }
    if (type.several) {
        made.value = std::move(stages);
    } else {
        made.value = std::move(stages.front());
    }
    return made;
}

// ------------------------------------------------------------------- numbers outside of stages

std::optional<double> StageBuilder::known_number(ExpressionId id) {
    const Value value = evaluate(tree_, id, scope_, session_.context());
    return value.is_constant() ? std::optional(value.constant()) : std::nullopt;
}

std::optional<double> StageBuilder::constant(ExpressionId id, std::string_view what) {
    const Value value = evaluate(tree_, id, scope_, session_.context());
    if (value.failed()) {
        return std::nullopt;
    }
    if (value.is_angle()) {
        error(tree_[id].span, fmt::format("{} must be a plain number, but this is an angle", what),
              "remove deg or rad, or divide the angle by 1rad");
        return std::nullopt;
    }
    if (!value.is_constant()) {
        error(tree_[id].span, fmt::format("{} cannot change with time", what),
              "write it without t: it is needed before the time is known");
        return std::nullopt;
    }
    return value.constant();
}

std::optional<StageBuilder::Aspect> StageBuilder::aspect(ExpressionId id, std::string_view owner) {
    const auto positive = [&](ExpressionId value, std::string_view name) {
        const std::string what = fmt::format("the {} of {}", name, owner);
        const std::optional<double> made = constant(value, what);
        if (made && !(*made > 0.0)) {
            error(tree_[value].span, fmt::format("{} must be above 0, but is {:.6g}", what, *made),
                  "the aspect is the width of the picture divided by its height, for example 16/9, "
                  "or both in scene units: (3, 2)");
            return std::optional<double>();
        }
        return made;
    };
    const Expression& written = tree_[id];
    if (written.kind != ExpressionKind::tuple || written.arguments.size() != 2) {
        const std::optional<double> ratio = positive(id, "aspect");
        return ratio ? std::optional(Aspect{*ratio}) : std::nullopt;
    }
    const std::optional<double> width = positive(written.arguments[0].value, "width");
    const std::optional<double> height = positive(written.arguments[1].value, "height");
    return width && height ? std::optional(Aspect{*width / *height, std::array{*width, *height}})
                           : std::nullopt;
}

}  // namespace balcony::lang
