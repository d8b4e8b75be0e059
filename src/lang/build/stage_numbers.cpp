// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Number arguments of stages: their form, unit and range.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "lang/build/stages.hpp"
#include "lang/names/evaluate.hpp"

namespace balcony::lang {

namespace {

using camera::Arguments;
using camera::ParameterType;
using camera::Scalar;
using camera::StageEntry;
using camera::StageKind;
using camera::StageParameter;
using camera::Unit;

std::size_t count_of(ParameterType type) {
    switch (type) {
        case ParameterType::pair:
        case ParameterType::size: return 2;
        case ParameterType::triple:
        case ParameterType::axis: return 3;
        default: return 1;
    }
}

// A number in the notation of a user.
std::string written(double value, Unit unit) {
    if (unit == Unit::angle) {
        return fmt::format("{:.6g}deg", value * 180.0 / std::numbers::pi);
    }
    return fmt::format("{:.6g}", value);
}

bool must_be_constant(const StageParameter& parameter) {
    return parameter.constant || parameter.type == ParameterType::count ||
           parameter.type == ParameterType::points;
}

std::string range_text(const StageParameter& parameter) {
    const bool has_min = std::isfinite(parameter.minimum);
    const bool has_max = std::isfinite(parameter.maximum);
    const std::string minimum = written(parameter.minimum, parameter.unit);
    const std::string maximum = written(parameter.maximum, parameter.unit);
    const char* from = parameter.excludes_minimum ? "above" : "at least";
    if (has_min && has_max) {
        return parameter.excludes_minimum ? fmt::format("above {} and at most {}", minimum, maximum)
                                          : fmt::format("from {} to {}", minimum, maximum);
    }
    return has_min ? fmt::format("{} {}", from, minimum) : fmt::format("at most {}", maximum);
}

/// Clamps a value that changes with time to its range, because it cannot be checked in
/// advance.
expr::Expr within_range(const StageParameter& parameter, expr::Expr value) {
    expr::Graph& graph = value.graph();
    if (std::isfinite(parameter.minimum)) {
        value = max(value, graph.constant(parameter.minimum));
    }
    if (std::isfinite(parameter.maximum)) {
        value = min(value, graph.constant(parameter.maximum));
    }
    return value;
}

// The meaning of the parameter, and its default.
std::string purpose(const StageParameter& parameter) {
    const std::string left_out =
        parameter.default_value.size() == 1
            ? fmt::format("; the default is {}",
                          written(parameter.default_value.front(), parameter.unit))
            : "";
    return fmt::format("{}: {}{}", parameter.name, parameter.meaning, left_out);
}

// at = (1, 2, 3): an example of the syntax of a parameter, from its default.
std::string example_of(const StageParameter& parameter, std::size_t count) {
    const auto& built_in = parameter.default_value;
    const double rest = parameter.type == ParameterType::size ? 1.0 : 0.0;
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < count; ++i) {
        const double value = built_in.size() == count ? built_in[i] : i == 0 ? 1.0 : rest;
        numbers.push_back(written(value, parameter.unit));
    }
    return fmt::format("{} = ({})", parameter.name, fmt::join(numbers, ", "));
}

// The syntax of a parameter whose numbers were given in a wrong form.
std::string form_remedy(const StageParameter& parameter) {
    const std::size_t count = count_of(parameter.type);
    if (parameter.type == ParameterType::axis) {
        return fmt::format("write the name of an axis, such as z, or {}",
                           example_of(parameter, count));
    }
    return count == 1 ? purpose(parameter)
                      : fmt::format("for example {}", example_of(parameter, count));
}

}  // namespace

bool StageBuilder::set_default(const StageEntry& row, const StageParameter& parameter, Span call,
                               Arguments& arguments) {
    if (parameter.type == ParameterType::choice) {
        arguments.set(parameter.name, std::string(parameter.choices.front()));
        return true;
    }
    if (parameter.default_value.empty() && parameter.optional) {
        return true;
    }
    if (parameter.default_value.empty()) {
        error(call,
              fmt::format("'{}' needs its argument '{}' ({})", row.name, parameter.name,
                          parameter.meaning),
              fmt::format("the syntax is {}", signature(row)));
        return false;
    }
    std::vector<Scalar> values(parameter.default_value.begin(), parameter.default_value.end());
    values.resize(count_of(parameter.type), values.back());
    arguments.set(parameter.name, std::move(values));
    return true;
}

std::optional<std::vector<double>> StageBuilder::named_axis(const Expression& node) {
    const bool negative = node.kind == ExpressionKind::operation && node.name.text == "-" &&
                          node.arguments.size() == 1;
    const Expression& named = negative ? tree_[node.arguments[0].value] : node;
    const std::string_view axes = "xyz";
    if (named.kind != ExpressionKind::name || named.name.text.size() != 1 ||
        axes.find(named.name.text) == std::string_view::npos) {
        return std::nullopt;
    }
    std::vector<double> direction(3, 0.0);
    direction[axes.find(named.name.text)] = negative ? -1.0 : 1.0;
    return direction;
}

std::optional<std::vector<Scalar>> StageBuilder::numbers(const StageEntry& row,
                                                         const StageParameter& parameter,
                                                         ExpressionId given) {
    const Expression& node = tree_[given];
    const std::size_t count = count_of(parameter.type);
    if (parameter.type == ParameterType::axis) {
        if (const auto direction = named_axis(node)) {
            return std::vector<Scalar>(direction->begin(), direction->end());
        }
    }
    const auto several = evaluate_compound(tree_, given, scope_, *graph_, reporter_);
    if (several && several->failed()) {
        return std::nullopt;
    }
    if (!several && (count == 1 || parameter.type == ParameterType::size)) {
        const Value value = evaluate(tree_, given, scope_, *graph_, reporter_);
        const auto made = number(row, parameter, value, tree_.at(node.span));
        return made ? std::optional(std::vector<Scalar>(count, *made)) : std::nullopt;
    }
    const bool tuple = several && several->form == Value::Form::tuple;
    if (!tuple || several->elements->size() != count) {
        const std::string_view what = several ? "a list" : described(node);
        const std::string form = count == 1   ? "a number"
                                 : count == 2 ? "two numbers (a, b)"
                                              : "three numbers (a, b, c)";
        error(node.span,
              fmt::format("'{}' of '{}' takes {}{}{}, but {}", parameter.name, row.name, form,
                          parameter.type == ParameterType::axis ? " or x, y or z" : "",
                          parameter.type == ParameterType::size ? " or one number for both" : "",
                          tuple ? fmt::format("there are {}", several->elements->size())
                                : fmt::format("this is {}", what)),
              form_remedy(parameter));
        return std::nullopt;
    }
    const Naming naming(*this, node);
    std::vector<Scalar> values;
    for (const Element& element : *several->elements) {
        if (const auto value = number(row, parameter, element.value, element.place)) {
            values.push_back(*value);
        }
    }
    return values.size() == count ? std::optional(std::move(values)) : std::nullopt;
}

std::optional<Scalar> StageBuilder::number(const StageEntry& row, const StageParameter& parameter,
                                           const Value& value, const SourceSpan& place) {
    if (value.failed() || !fits(row, parameter, value, place)) {
        return std::nullopt;
    }
    if (value.is_constant()) {
        return Scalar(value.constant());
    }
    return Scalar(camera::Formula(graph_, {}, {within_range(parameter, value.expr)}));
}

bool StageBuilder::fits(const StageEntry& row, const StageParameter& parameter, const Value& value,
                        const SourceSpan& place) {
    const std::string what = fmt::format("'{}' of '{}'", parameter.name, row.name);
    if (parameter.unit == Unit::number && value.is_angle()) {
        error(place, fmt::format("{} must be a plain number, but this is an angle", what),
              "remove deg or rad, or divide the angle by 1rad");
        return false;
    }
    if (parameter.unit == Unit::angle && value.is_plain_number()) {
        const std::string_view written =
            place.source->text().substr(place.begin, place.end - place.begin);
        const bool literal = written.find_first_not_of("0123456789.") == std::string::npos;
        error(place, fmt::format("{} must be an angle, but this is a plain number", what),
              literal ? fmt::format("write {0}deg or {0}rad", written)
                      : "multiply it by 1rad if it is in radians, or by 1deg if it is in degrees");
        return false;
    }
    if (value.is_constant()) {
        return in_range(row, parameter, value.constant(), place);
    }
    if (must_be_constant(parameter)) {
        error(place, fmt::format("{} cannot change with time", what),
              "it determines the structure of the stage, which is the same for all times");
        return false;
    }
    return true;
}

bool StageBuilder::in_range(const StageEntry& row, const StageParameter& parameter, double value,
                            const SourceSpan& place) {
    const std::string what = fmt::format("'{}' of '{}'", parameter.name, row.name);
    if (parameter.type == ParameterType::count && std::floor(value) != value) {
        const double below = std::max(std::floor(value), parameter.minimum);
        const double above = std::min(std::floor(value) + 1.0, parameter.maximum);
        error(place,
              fmt::format("{} must be a whole number, but is {}", what,
                          written(value, parameter.unit)),
              below < above ? fmt::format("write {:.17g} or {:.17g}", below, above)
                            : fmt::format("write {:.17g}", std::min(below, above)));
        return false;
    }
    const bool too_small =
        parameter.excludes_minimum ? value <= parameter.minimum : value < parameter.minimum;
    if (too_small || value > parameter.maximum) {
        error(place,
              fmt::format("{} must be {}, but is {}", what, range_text(parameter),
                          written(value, parameter.unit)),
              purpose(parameter));
        return false;
    }
    return true;
}

std::optional<Arguments> StageBuilder::arguments(const StageEntry& row,
                                                 std::span<const ExpressionId> values) {
    assert(values.size() <= row.parameters.size());
    Arguments arguments;
    bool good = true;
    for (std::size_t i = 0; i < values.size(); ++i) {
        good = set_argument(row, row.parameters[i], values.subspan(i, 1), arguments) && good;
    }
    return good ? std::optional(std::move(arguments)) : std::nullopt;
}

std::optional<Arguments> StageBuilder::argument(const StageEntry& row, std::string_view parameter,
                                                ExpressionId value) {
    const auto found =
        std::find_if(row.parameters.begin(), row.parameters.end(),
                     [parameter](const StageParameter& one) { return one.name == parameter; });
    assert(found != row.parameters.end());
    Arguments arguments;
    return set_argument(row, *found, std::array{value}, arguments)
               ? std::optional(std::move(arguments))
               : std::nullopt;
}

camera::PictureArrangerPointer StageBuilder::make_place(const MapRange& corners) {
    const StageEntry* row = camera::find_stage(StageKind::picture_arranger, "place");
    assert(row != nullptr);
    const auto given = arguments(*row, std::array{corners.first, corners.last});
    return given ? std::static_pointer_cast<const camera::PictureArranger>(
                       make_from_row(*row, *given, corners.span))
                 : nullptr;
}

camera::PictureMapperPointer StageBuilder::make_mapper(std::string_view name,
                                                       std::span<const ExpressionId> values,
                                                       Span span) {
    const StageEntry* row = camera::find_stage(StageKind::picture_mapper, name);
    assert(row != nullptr && row->parameters.size() == values.size());
    const std::optional<Arguments> given = arguments(*row, values);
    if (!given) {
        return nullptr;
    }
    for (std::size_t i = 0; i + 1 < values.size(); i += 2) {
        const auto first = given->number(row->parameters[i].name).constant();
        const auto last = given->number(row->parameters[i + 1].name).constant();
        if (first && last && *first == *last) {
            const Span range = {tree_[values[i]].span.begin, tree_[values[i + 1]].span.end};
            reporter_.warning(tree_.at(range), "this range starts and ends at the same value",
                              "the picture does not change in this direction");
        }
    }
    return std::static_pointer_cast<const camera::PictureMapper>(make_from_row(*row, *given, span));
}

camera::DirectionRulePointer StageBuilder::make_default_rule(std::string_view name, Span span) {
    const StageEntry* row = camera::find_stage(StageKind::direction_rule, name);
    assert(row != nullptr);
    Arguments arguments;
    bool good = true;
    for (const StageParameter& parameter : row->parameters) {
        good = set_default(*row, parameter, span, arguments) && good;
    }
    return good ? std::static_pointer_cast<const camera::DirectionRule>(
                      make_from_row(*row, arguments, span))
                : nullptr;
}

std::optional<double> StageBuilder::constant(ExpressionId id, std::string_view what) {
    const Value value = evaluate(tree_, id, scope_, *graph_, reporter_);
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

std::optional<double> StageBuilder::aspect(ExpressionId id, std::string_view owner) {
    const std::string what = fmt::format("the aspect of {}", owner);
    const std::optional<double> value = constant(id, what);
    if (value && !(*value > 0.0)) {
        error(tree_[id].span, fmt::format("{} must be above 0, but is {:.6g}", what, *value),
              "the aspect is the width of the picture divided by its height, for example 16/9");
        return std::nullopt;
    }
    return value;
}

}  // namespace balcony::lang
