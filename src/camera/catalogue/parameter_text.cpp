// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/catalogue/parameter_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/make_stage.hpp"
#include "balcony/names.hpp"

namespace balcony::camera {

namespace {

// at = (1, 2, 3): how the numbers of a parameter are written, from its default.
template <std::size_t count>
std::string example_of(std::string_view name,
                       const std::optional<std::array<double, count>>& default_value, double rest,
                       Unit unit) {
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < count; ++i) {
        const double value = default_value ? (*default_value)[i] : i == 0 ? 1.0 : rest;
        numbers.push_back(number_text(value, unit));
    }
    return fmt::format("{} = ({})", name, fmt::join(numbers, ", "));
}

}  // namespace

std::string number_text(double value, Unit unit) {
    return unit == Unit::angle ? fmt::format("{:.6g}deg", value * 180.0 / std::numbers::pi)
                               : fmt::format("{:.6g}", value);
}

std::string range_text(const Range& range, Unit unit) {
    const bool has_min = std::isfinite(range.minimum);
    const bool has_max = std::isfinite(range.maximum);
    const std::string minimum = number_text(range.minimum, unit);
    const std::string maximum = number_text(range.maximum, unit);
    if (has_min && has_max) {
        return range.excludes_minimum ? fmt::format("above {} and at most {}", minimum, maximum)
                                      : fmt::format("from {} to {}", minimum, maximum);
    }
    return has_min ? fmt::format("{} {}", range.excludes_minimum ? "above" : "at least", minimum)
                   : fmt::format("at most {}", maximum);
}

std::string counts_text(const std::vector<std::size_t>& counts) {
    std::string text;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const bool last = i + 1 == counts.size();
        text += fmt::format("{}{}", i == 0 ? "" : last ? " or " : ", ", counts[i]);
    }
    return text;
}

std::string example_of(const PointsParameter& type) {
    const std::size_t coordinates = type.coordinates.front();
    std::vector<std::string> points;
    for (std::size_t i = 0; i < std::clamp<std::size_t>(type.min_points, 2, 3); ++i) {
        const std::string numbers = fmt::format("{}", fmt::join(std::vector(coordinates, i), ", "));
        points.push_back(coordinates > 1 ? fmt::format("({})", numbers) : numbers);
    }
    return fmt::format("[{}]", fmt::join(points, ", "));
}

std::string purpose(const StageParameter& parameter, std::optional<double> default_value,
                    Unit unit) {
    return fmt::format(
        "{}: {}{}", parameter.name, parameter.meaning,
        default_value ? fmt::format("; the default is {}", number_text(*default_value, unit)) : "");
}

std::string form_remedy(const StageParameter& parameter) {
    if (const auto* number = parameter.as<NumberParameter>()) {
        return purpose(parameter, number->default_value, number->unit);
    }
    if (const auto* count = parameter.as<CountParameter>()) {
        return purpose(parameter, count->default_value, Unit::number);
    }
    if (const auto* pair = parameter.as<PairParameter>()) {
        return "for example " + example_of(parameter.name, pair->default_value,
                                           pair->one_for_both ? 1.0 : 0.0, pair->unit);
    }
    const auto* triple = parameter.as<TripleParameter>();
    assert(triple != nullptr && "other types are no numbers");
    return (triple->names_axes ? "write the name of an axis, such as z, or " : "for example ") +
           example_of(parameter.name, triple->default_value, 0.0, Unit::number);
}

std::string_view noun_of(const NestedStageParameter& type) {
    return type.dimension ? object_noun(*type.dimension) : name_of(type.kind);
}

std::string_view object_noun(int dimension) {
    return dimension == 0 ? "point" : dimension == 1 ? "curve" : "surface";
}

std::string stage_remedy(const NestedStageParameter& type) {
    if (type.dimension == 1) {
        return "write a curve, for example circle(1) or curve(u) = [cos(u), sin(u)]";
    }
    if (!type.of_number.empty()) {
        std::vector<std::string> stages;
        for (const StageEntry& one : catalogue()) {
            if (one.kind == type.kind) {
                stages.push_back(signature(one));
            }
        }
        return fmt::format("write a number, or {}", one_of(stages));
    }
    const auto row =
        std::find_if(catalogue().begin(), catalogue().end(), [&type](const StageEntry& one) {
            return one.kind == type.kind && !one.shape &&
                   (!type.dimension || one.dimension == *type.dimension);
        });
    assert(row != catalogue().end() && "there is a built-in stage of every kind");
    return fmt::format("write {}, for example {}", with_article(noun_of(type)), signature(*row));
}

std::optional<std::array<double, 3>> named_axis(std::string_view word) {
    const bool negative = word.starts_with('-');
    word.remove_prefix(negative ? 1 : 0);
    constexpr std::string_view axes = "xyz";
    if (word.size() != 1 || axes.find(word) == std::string_view::npos) {
        return std::nullopt;
    }
    std::array<double, 3> direction{};
    direction[axes.find(word)] = negative ? -1.0 : 1.0;
    return direction;
}

}  // namespace balcony::camera
