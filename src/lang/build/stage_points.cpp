// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Point arguments of stages, such as control points: [(0, 0), (1, 2)], or [0, 0.5, 1].

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "lang/build/stages.hpp"
#include "lang/names/evaluate.hpp"

namespace balcony::lang {

namespace {

using camera::PointList;
using camera::StageEntry;
using camera::StageParameter;

constexpr std::size_t max_points = 65536;
// Stages compute powers of the distances of points, which must not overflow.
constexpr double max_coordinate = 1e30;

// 2 or 3; 1, 2 or 3.
std::string numbers_in_words(const std::vector<std::size_t>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        text += fmt::format("{}{}",
                            i == 0                    ? ""
                            : i + 1 == numbers.size() ? " or "
                                                      : ", ",
                            numbers[i]);
    }
    return text;
}

// [0, 1, 2] or [(0, 0), (1, 1), (2, 2)], with the minimum number of points, but at most 3.
std::string example_of(const StageParameter& parameter) {
    const std::size_t coordinates = parameter.coordinates.front();
    std::string text;
    for (std::size_t i = 0; i < std::clamp<std::size_t>(parameter.min_points, 2, 3); ++i) {
        text += i == 0 ? "" : ", ";
        text += coordinates > 1 ? "(" : "";
        for (std::size_t k = 0; k < coordinates; ++k) {
            text += fmt::format("{}{}", k == 0 ? "" : ", ", i);
        }
        text += coordinates > 1 ? ")" : "";
    }
    return fmt::format("[{}]", text);
}

bool is_list_of_numbers(const StageParameter& parameter) {
    return parameter.coordinates == std::vector<std::size_t>{1};
}

}  // namespace

std::optional<PointList> StageBuilder::points(const StageEntry& row,
                                              const StageParameter& parameter, ExpressionId given) {
    const Expression& node = tree_[given];
    if (node.kind == ExpressionKind::text) {
        return table(row, parameter, given);
    }
    // Reports an unknown name as unknown, and anything that is not a value as not a list.
    const bool may_be_list = node.kind == ExpressionKind::list || node.kind == ExpressionKind::name;
    const Value list =
        may_be_list ? evaluate_any(tree_, given, scope_, *graph_, reporter_) : Value();
    if (may_be_list && list.failed()) {
        return std::nullopt;
    }
    if (list.form != Value::Form::list) {
        error(node.span,
              fmt::format("'{}' of '{}' takes a list of {}", parameter.name, row.name,
                          is_list_of_numbers(parameter) ? "numbers" : "points"),
              fmt::format(
                  "write it in brackets, for example {}, or name a table, such as \"table.csv\"",
                  example_of(parameter)));
        return std::nullopt;
    }
    if (!enough_points(row, parameter, list.elements->size(), node.span)) {
        return std::nullopt;
    }
    const Naming naming(*this, node);
    PointList made;
    bool good = true;
    for (const Element& element : *list.elements) {
        const bool tuple = element.value.form == Value::Form::tuple;
        const auto coordinates =
            tuple ? std::span(*element.value.elements) : std::span(&element, 1);
        good = add_point(row, parameter, element.place, coordinates, made) && good;
        if (reporter_.full()) {
            return std::nullopt;
        }
    }
    return good ? std::optional(std::move(made)) : std::nullopt;
}

bool StageBuilder::enough_points(const StageEntry& row, const StageParameter& parameter,
                                 std::size_t count, Span span) {
    const bool few = count < parameter.min_points;
    if (!few && count <= max_points) {
        return true;
    }
    const std::size_t bound = few ? parameter.min_points : max_points;
    const std::string_view noun = is_list_of_numbers(parameter) ? "number" : "point";
    error(span,
          fmt::format("'{}' of '{}' needs at {} {} {}{}, but has {}", parameter.name, row.name,
                      few ? "least" : "most", bound, noun, bound == 1 ? "" : "s", count),
          few ? fmt::format("{}: {}; add {} more", parameter.name, parameter.meaning, bound - count)
              : fmt::format("keep one {} out of {}", noun, (count + max_points - 1) / max_points));
    return false;
}

bool StageBuilder::add_point(const StageEntry& row, const StageParameter& parameter,
                             const SourceSpan& place, std::span<const Element> coordinates,
                             PointList& points) {
    if (!has_coordinates(row, parameter, coordinates.size(), place, points)) {
        return false;
    }
    points.coordinates = coordinates.size();
    bool good = true;
    for (const Element& coordinate : coordinates) {
        if (!fits(row, parameter, coordinate.value, coordinate.place)) {
            good = false;
        } else if (std::abs(coordinate.value.constant()) > max_coordinate) {
            reporter_.error(coordinate.place,
                            fmt::format("a coordinate of '{}' must be between -{} and {}",
                                        parameter.name, max_coordinate, max_coordinate),
                            "write the points in a larger unit, and enlarge the object with scale");
            good = false;
        } else {
            points.values.push_back(coordinate.value.constant());
        }
    }
    return good;
}

bool StageBuilder::has_coordinates(const StageEntry& row, const StageParameter& parameter,
                                   std::size_t count, const SourceSpan& place,
                                   const PointList& points) {
    const auto& allowed = parameter.coordinates;
    if (std::find(allowed.begin(), allowed.end(), count) == allowed.end()) {
        error(place,
              fmt::format("a point of '{}' of '{}' has {} number{}, but this has {}",
                          parameter.name, row.name, numbers_in_words(allowed),
                          is_list_of_numbers(parameter) ? "" : "s", count),
              place.source == tree_.source
                  ? fmt::format("for example {} = {}", parameter.name, example_of(parameter))
                  : "each line of a table is a point; remove other columns");
        return false;
    }
    if (points.coordinates != 0 && points.coordinates != count) {
        error(place,
              fmt::format("this point has {} number{}, but the first has {}", count,
                          count == 1 ? "" : "s", points.coordinates),
              fmt::format("give all points {} numbers", points.coordinates));
        return false;
    }
    return true;
}

}  // namespace balcony::lang
