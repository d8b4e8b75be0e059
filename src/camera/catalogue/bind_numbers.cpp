// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Values for the parameters of a stage: numbers and points, with their forms, units and ranges.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "camera/catalogue/binder.hpp"
#include "camera/catalogue/parameter_text.hpp"

namespace balcony::camera {

namespace {

constexpr std::size_t max_points = 65536;
// Stages made of points compute powers of their distances, which must not overflow.
constexpr double max_coordinate = 1e30;

bool is_plain_number(const Scalar& given) {
    return given.unit() == Unit::number && given.constant() != 0.0;
}

}  // namespace

bool is_angle(const Scalar& given) {
    return given.unit() == Unit::angle && given.constant() != 0.0;
}

void Binder::set(const NumberParameter& type) {
    if (const auto* number = one_number("a number")) {
        set_numbers(std::span(number, 1),
                    {type.unit, type.range, type.constant, false, type.default_value});
    }
}

void Binder::set(const CountParameter& type) {
    if (const auto* number = one_number("a number")) {
        set_numbers(std::span(number, 1),
                    {Unit::number, type.range, true, true, type.default_value});
    }
}

void Binder::set(const PairParameter& type) {
    const NumberRules rules{type.unit, type.range, type.constant, false, {}};
    if (const auto* one = given<Scalar>(); one != nullptr && type.one_for_both) {
        if (const auto number = checked(*one, rules)) {
            arguments_.set(parameter_->name, std::vector<Scalar>(2, *number));
        }
    } else if (const auto* two =
                   numbers(2, type.one_for_both ? "two numbers (a, b) or one number for both"
                                                : "two numbers (a, b)")) {
        set_numbers(*two, rules);
    }
}

void Binder::set(const TripleParameter& type) {
    if (const auto* word = given<std::string>(); word != nullptr && type.names_axes) {
        if (const auto axis = named_axis(*word)) {
            arguments_.set(parameter_->name, std::vector<Scalar>(axis->begin(), axis->end()));
            return;
        }
    }
    if (const auto* three = numbers(3, type.names_axes ? "three numbers (a, b, c) or x, y or z"
                                                       : "three numbers (a, b, c)")) {
        set_numbers(*three, {Unit::number, type.range, type.constant, false, {}});
    }
}

const Scalar* Binder::one_number(std::string_view form) {
    const auto* number = given<Scalar>();
    if (number == nullptr) {
        wrong_form(form);
    }
    return number;
}

const Tuple* Binder::numbers(std::size_t count, std::string_view form) {
    const auto* tuple = given<Tuple>();
    if (tuple == nullptr || tuple->size() != count) {
        wrong_form(form);
        return nullptr;
    }
    return tuple;
}

void Binder::wrong_form(std::string_view form) {
    const auto* tuple = given<Tuple>();
    report(Kind::wrong_form,
           fmt::format("{} takes {}, but {}", what(), form,
                       tuple != nullptr ? fmt::format("there are {}", tuple->size())
                                        : fmt::format("this is {}", described(given_[*at_].value))),
           form_remedy(*parameter_));
}

void Binder::set_numbers(std::span<const Scalar> numbers, const NumberRules& rules) {
    std::vector<Scalar> values;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers.size() > 1) {
            element_ = {i};
        }
        if (const auto value = checked(numbers[i], rules)) {
            values.push_back(*value);
        }
    }
    if (values.size() == numbers.size()) {
        arguments_.set(parameter_->name, std::move(values));
    }
}

std::optional<Scalar> Binder::checked(const Scalar& number, const NumberRules& rules) {
    if (!fits(number, rules.unit, rules.constant)) {
        return std::nullopt;
    }
    const std::optional<double> value = number.constant();
    if (!value) {
        return number.clamped(rules.range.minimum, rules.range.maximum);
    }
    return in_range(*value, rules) ? std::optional(number) : std::nullopt;
}

bool Binder::fits(const Scalar& number, Unit unit, bool constant) {
    if (unit == Unit::number && is_angle(number)) {
        report(Kind::angle_for_number,
               fmt::format("{} must be a plain number, but this is an angle", what()),
               "remove deg or rad, or divide the angle by 1rad");
        return false;
    }
    if (unit == Unit::angle && is_plain_number(number)) {
        report(Kind::number_for_angle,
               fmt::format("{} must be an angle, but this is a plain number", what()),
               "give it in degrees or radians");
        return false;
    }
    const std::optional<double> value = number.constant();
    if (constant && !value) {
        report(Kind::changes_with_time, fmt::format("{} cannot change with time", what()),
               "it determines the structure of the stage, which is the same for all times");
        return false;
    }
    if (value && !std::isfinite(*value)) {
        report(Kind::out_of_range, fmt::format("{} is not finite", what()), "give it a number");
        return false;
    }
    return true;
}

bool Binder::in_range(double value, const NumberRules& rules) {
    const Range& range = rules.range;
    if (rules.whole && std::floor(value) != value) {
        const double below = std::max(std::floor(value), range.minimum);
        const double above = std::min(std::floor(value) + 1.0, range.maximum);
        report(Kind::out_of_range,
               fmt::format("{} must be a whole number, but is {}", what(),
                           number_text(value, rules.unit)),
               below < above ? fmt::format("write {:.17g} or {:.17g}", below, above)
                             : fmt::format("write {:.17g}", std::min(below, above)));
        return false;
    }
    if (contains(range, value)) {
        return true;
    }
    report(Kind::out_of_range,
           fmt::format("{} must be {}, but is {}", what(), range_text(range, rules.unit),
                       number_text(value, rules.unit)),
           purpose(*parameter_, rules.default_value, rules.unit));
    return false;
}

void Binder::set(const PointsParameter& type) {
    const auto* list = given<Points>();
    if (list == nullptr) {
        report(
            Kind::wrong_form,
            fmt::format("{} takes a list of {}", what(), is_numbers(type) ? "numbers" : "points"),
            fmt::format(
                "write it in brackets, for example {}, or name a table, such as \"table.csv\"",
                example_of(type)));
        return;
    }
    if (!enough_points(type, list->size())) {
        return;
    }
    const std::size_t errors_before = errors_.size();
    PointList made;
    for (std::size_t i = 0; i < list->size() && errors_.size() < max_errors; ++i) {
        element_ = {i};
        add_point(type, (*list)[i], made);
    }
    if (errors_.size() == errors_before) {
        arguments_.set(parameter_->name, std::move(made));
    }
}

bool Binder::enough_points(const PointsParameter& type, std::size_t count) {
    const bool few = count < type.min_points;
    if (!few && count <= max_points) {
        return true;
    }
    const std::size_t bound = few ? type.min_points : max_points;
    const std::string_view noun = is_numbers(type) ? "number" : "point";
    report(Kind::out_of_range,
           fmt::format("{} needs at {} {} {}{}, but has {}", what(), few ? "least" : "most", bound,
                       noun, bound == 1 ? "" : "s", count),
           few ? fmt::format("{}: {}; add {} more", parameter_->name, parameter_->meaning,
                             bound - count)
               : fmt::format("keep one {} out of {}", noun, (count + max_points - 1) / max_points));
    return false;
}

void Binder::add_point(const PointsParameter& type, const Tuple& point, PointList& points) {
    if (!has_coordinates(type, point.size(), points)) {
        return;
    }
    points.coordinates = point.size();
    for (std::size_t k = 0; k < point.size(); ++k) {
        element_.resize(1);
        element_.push_back(k);
        if (!fits(point[k], type.unit, true)) {
            continue;
        }
        const double value = *point[k].constant();
        if (std::abs(value) > max_coordinate) {
            report(Kind::out_of_range,
                   fmt::format("a coordinate of '{}' must be between -{} and {}", parameter_->name,
                               max_coordinate, max_coordinate),
                   "write the points in a larger unit, and enlarge the object with scale");
        }
        points.values.push_back(value);
    }
}

bool Binder::has_coordinates(const PointsParameter& type, std::size_t count,
                             const PointList& points) {
    const auto& allowed = type.coordinates;
    if (std::find(allowed.begin(), allowed.end(), count) == allowed.end()) {
        report(Kind::wrong_coordinates,
               fmt::format("a point of {} has {} number{}, but this has {}", what(),
                           counts_text(allowed), is_numbers(type) ? "" : "s", count),
               fmt::format("for example {} = {}", parameter_->name, example_of(type)));
        return false;
    }
    if (points.coordinates != 0 && points.coordinates != count) {
        report(Kind::wrong_form,
               fmt::format("this point has {} number{}, but the first has {}", count,
                           count == 1 ? "" : "s", points.coordinates),
               fmt::format("give all points {} numbers", points.coordinates));
        return false;
    }
    return true;
}

}  // namespace balcony::camera
