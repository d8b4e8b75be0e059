// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The points that stages are given, such as control points: [(0, 0), (1, 2)], or [0, 0.5, 1].

#include <algorithm>

#include <fmt/format.h>

#include "lang/evaluate.hpp"
#include "lang/stages.hpp"

namespace balcony::lang {

namespace {

using camera::PointList;
using camera::StageEntry;
using camera::StageParameter;

constexpr std::size_t most_points = 65536;

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

// [0, 1, 2] or [(0, 0), (1, 1), (2, 2)], as long as the parameter needs but no longer than 3.
std::string example_of(const StageParameter& parameter) {
    const std::size_t coordinates = parameter.coordinates.front();
    std::string text;
    for (std::size_t i = 0; i < std::clamp<std::size_t>(parameter.points_least, 2, 3); ++i) {
        text += i == 0 ? "" : ", ";
        text += coordinates > 1 ? "(" : "";
        for (std::size_t k = 0; k < coordinates; ++k) {
            text += fmt::format("{}{}", k == 0 ? "" : ", ", i);
        }
        text += coordinates > 1 ? ")" : "";
    }
    return fmt::format("[{}]", text);
}

}  // namespace

std::optional<PointList> StageBuilder::points(const StageEntry& row,
                                              const StageParameter& parameter, ExpressionId given) {
    const Expression& list = tree_[given];
    const std::string what = fmt::format("'{}' of '{}'", parameter.name, row.name);
    const bool numbers = parameter.coordinates == std::vector<std::size_t>{1};
    const char* noun = numbers ? "number" : "point";
    if (list.kind != ExpressionKind::list) {
        error(list.span, fmt::format("{} is a list of {}s", what, noun),
              fmt::format("write it in brackets, such as {}", example_of(parameter)));
        return std::nullopt;
    }
    const std::size_t count = list.arguments.size();
    if (count < parameter.points_least || count > most_points) {
        const bool few = count < parameter.points_least;
        const std::size_t bound = few ? parameter.points_least : most_points;
        error(list.span,
              fmt::format("{} needs at {} {} {}{}, but has {}", what, few ? "least" : "most", bound,
                          noun, bound == 1 ? "" : "s", count));
        return std::nullopt;
    }
    PointList made;
    bool good = true;
    for (const Argument& element : list.arguments) {
        const Expression& node = tree_[element.value];
        std::vector<ExpressionId> coordinates;
        if (node.kind == ExpressionKind::tuple) {
            for (const Argument& coordinate : node.arguments) {
                coordinates.push_back(coordinate.value);
            }
        } else {
            coordinates.push_back(element.value);
        }
        good = add_point(row, parameter, node, coordinates, made) && good;
        if (reporter_.full()) {
            return std::nullopt;
        }
    }
    return good ? std::optional(std::move(made)) : std::nullopt;
}

bool StageBuilder::add_point(const StageEntry& row, const StageParameter& parameter,
                             const Expression& node, std::span<const ExpressionId> coordinates,
                             PointList& points) {
    const std::size_t count = coordinates.size();
    const auto numbers = [](std::size_t n) {
        return fmt::format("{} number{}", n, n == 1 ? "" : "s");
    };
    const auto& allowed = parameter.coordinates;
    if (std::find(allowed.begin(), allowed.end(), count) == allowed.end()) {
        error(node.span, fmt::format("a point of '{}' of '{}' has {} number{}, but this has {}",
                                     parameter.name, row.name, numbers_in_words(allowed),
                                     allowed == std::vector<std::size_t>{1} ? "" : "s", count));
        return false;
    }
    if (points.coordinates != 0 && points.coordinates != count) {
        error(node.span, fmt::format("this point has {}, but the first has {}", numbers(count),
                                     points.coordinates));
        return false;
    }
    points.coordinates = count;
    bool good = true;
    for (const ExpressionId coordinate : coordinates) {
        const Value value = evaluate(tree_, coordinate, scope_, *graph_, reporter_);
        if (value.failed() || !fits(row, parameter, value, tree_[coordinate].span)) {
            good = false;
            continue;
        }
        points.values.push_back(value.constant());
    }
    return good;
}

}  // namespace balcony::lang
