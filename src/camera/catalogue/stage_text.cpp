// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/catalogue/stage_text.hpp"

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace balcony::camera {

namespace {

// Radians as degrees for people.
std::string value_text(Unit unit, double value) {
    return unit == Unit::angle && value != 0.0
               ? fmt::format("{:.6g}deg", value * 180.0 / std::numbers::pi)
               : fmt::format("{}", value);
}

std::string coordinates_text(const PointsParameter& type) {
    std::vector<std::string> kinds;
    for (const std::size_t coordinates : type.coordinates) {
        constexpr const char* tuples[] = {"numbers", "(a, b)", "(a, b, c)", "(a, b, c, d)"};
        kinds.push_back(coordinates >= 1 && coordinates <= std::size(tuples)
                            ? tuples[coordinates - 1]
                            : fmt::format("{} numbers each", coordinates));
    }
    return kinds.empty() ? "" : fmt::format(" of {}", fmt::join(kinds, " or "));
}

// "weight(u, v) = [w]" from the meaning of a formula parameter, otherwise its name.
std::string formula_text(const StageParameter& parameter) {
    const std::size_t begin = parameter.meaning.find(fmt::format("{}(", parameter.name));
    const std::size_t end = parameter.meaning.find(']', begin);
    return std::string(end == std::string_view::npos
                           ? parameter.name
                           : parameter.meaning.substr(begin, end + 1 - begin));
}

std::string of_range(const Range& range, Unit unit) {
    const bool has_min = std::isfinite(range.minimum);
    const bool has_max = std::isfinite(range.maximum);
    const std::string minimum = value_text(unit, range.minimum);
    const std::string maximum = value_text(unit, range.maximum);
    if (has_min && has_max) {
        return fmt::format("{}{} to {}", range.excludes_minimum ? "above " : "", minimum, maximum);
    }
    return has_min   ? fmt::format("{}{}", range.excludes_minimum ? "above " : "from ", minimum)
           : has_max ? fmt::format("to {}", maximum)
                     : "";
}

std::string_view unit_text(Unit unit) { return unit == Unit::angle ? "angle" : "number"; }

struct TypeText {
    std::string operator()(const NumberParameter& type) const {
        return std::string(unit_text(type.unit));
    }
    std::string operator()(const CountParameter&) const { return "whole number"; }
    std::string operator()(const PairParameter& type) const {
        return type.one_for_both ? fmt::format("{} or (a, b)", unit_text(type.unit)) : "(a, b)";
    }
    std::string operator()(const TripleParameter& type) const {
        return type.names_axes ? "x, y, z or (a, b, c)" : "(a, b, c)";
    }
    std::string operator()(const ChoiceParameter& type) const {
        return fmt::format("{}", fmt::join(type.choices, " | "));
    }
    std::string operator()(const PointsParameter& type) const {
        return fmt::format("points{} or \"table.csv\"", coordinates_text(type));
    }
    std::string operator()(const NestedStageParameter& type) const {
        return type.dimension == 1      ? "curve"
               : type.several           ? plural_of(type.kind)
               : type.of_number.empty() ? std::string(name_of(type.kind))
                                        : fmt::format("number or {}", name_of(type.kind));
    }
    std::string operator()(const FormulaParameter&) const { return "formula"; }
    std::string operator()(const NameParameter&) const { return "\"name\""; }
    std::string operator()(const ImageParameter&) const { return "\"image.png\""; }
    std::string operator()(const MeshParameter&) const { return "\"mesh.obj\""; }
    std::string operator()(const MapParameter&) const { return "\"map.exr\""; }
    std::string operator()(const CalibrationParameter&) const { return "\"calibration.yml\""; }
    std::string operator()(const PrescriptionParameter&) const { return "\"lens.dat\""; }
};

struct DefaultText {
    std::string operator()(const NumberParameter& type) const {
        return type.default_value ? value_text(type.unit, *type.default_value) : "";
    }
    std::string operator()(const CountParameter& type) const {
        return type.default_value ? value_text(Unit::number, *type.default_value) : "";
    }
    std::string operator()(const PairParameter& type) const {
        return type.default_value ? tuple(*type.default_value, type.unit) : "";
    }
    std::string operator()(const TripleParameter& type) const {
        return type.default_value ? tuple(*type.default_value, Unit::number) : "";
    }
    std::string operator()(const ChoiceParameter& type) const {
        return std::string(type.choices.front());
    }
    template <class Other>
    std::string operator()(const Other&) const {
        return {};
    }

private:
    static std::string tuple(std::span<const double> numbers, Unit unit) {
        std::vector<std::string> values;
        for (const double value : numbers) {
            values.push_back(value_text(unit, value));
        }
        return fmt::format("({})", fmt::join(values, ", "));
    }
};

struct RangeText {
    std::string operator()(const NumberParameter& type) const {
        return of_range(type.range, type.unit);
    }
    std::string operator()(const CountParameter& type) const {
        return of_range(type.range, Unit::number);
    }
    std::string operator()(const PairParameter& type) const {
        return of_range(type.range, type.unit);
    }
    std::string operator()(const TripleParameter& type) const {
        return of_range(type.range, Unit::number);
    }
    std::string operator()(const PointsParameter& type) const {
        return type.min_points > 1 ? fmt::format("{} or more", type.min_points) : "";
    }
    template <class Other>
    std::string operator()(const Other&) const {
        return {};
    }
};

}  // namespace

std::string type_text(const StageParameter& parameter) {
    return std::visit(TypeText{}, parameter.type);
}

std::string default_text(const StageParameter& parameter) {
    return std::visit(DefaultText{}, parameter.type);
}

std::string range_text(const StageParameter& parameter) {
    return std::visit(RangeText{}, parameter.type);
}

std::string_view stage_formula(const StageEntry& row) {
    const std::size_t begin = row.formula.find_first_not_of('\n');
    return begin == std::string_view::npos
               ? std::string_view()
               : row.formula.substr(begin, row.formula.find_last_not_of('\n') + 1 - begin);
}

std::string call_text(const StageEntry& row) {
    if (row.shape) {
        return std::string(row.meaning.substr(row.meaning.find(fmt::format("{}(", row.name))));
    }
    std::vector<std::string> names;
    for (const StageParameter& parameter : row.parameters) {
        names.push_back(parameter.as<FormulaParameter>() != nullptr ? formula_text(parameter)
                                                                    : std::string(parameter.name));
    }
    return names.empty() ? std::string(row.name)
                         : fmt::format("{}({})", row.name, fmt::join(names, ", "));
}

}  // namespace balcony::camera
