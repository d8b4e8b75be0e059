// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/stage_text.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

namespace balcony::cli {

using camera::ParameterType;
using camera::StageParameter;

namespace {

// Shows radians as degrees.
std::string value_text(const StageParameter& parameter, double value) {
    return parameter.unit == camera::Unit::angle && value != 0.0
               ? fmt::format("{:.6g}deg", value * 180.0 / std::numbers::pi)
               : fmt::format("{}", value);
}

std::string coordinates_text(const StageParameter& parameter) {
    std::vector<std::string> kinds;
    for (const std::size_t coordinates : parameter.coordinates) {
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

}  // namespace

std::string type_text(const StageParameter& parameter) {
    const char* unit = parameter.unit == camera::Unit::angle ? "angle" : "number";
    switch (parameter.type) {
        case ParameterType::number: return unit;
        case ParameterType::count: return "whole number";
        case ParameterType::pair: return "(a, b)";
        case ParameterType::size: return fmt::format("{} or (a, b)", unit);
        case ParameterType::triple: return "(a, b, c)";
        case ParameterType::axis: return "x, y, z or (a, b, c)";
        case ParameterType::choice: return fmt::format("{}", fmt::join(parameter.choices, " | "));
        case ParameterType::points:
            return fmt::format("points{} or \"table.csv\"", coordinates_text(parameter));
        case ParameterType::curve: return "curve";
        case ParameterType::stage: return std::string(camera::name_of(parameter.stage_kind));
        case ParameterType::stages:
            return fmt::format("{}s", camera::name_of(parameter.stage_kind));
        case ParameterType::formula: return "formula";
        case ParameterType::image: return "\"image.png\"";
        case ParameterType::mesh: return "\"mesh.obj\"";
    }
    return {};
}

std::string default_text(const StageParameter& parameter) {
    if (!parameter.choices.empty()) {
        return std::string(parameter.choices.front());
    }
    std::vector<std::string> values;
    for (const double value : parameter.default_value) {
        values.push_back(value_text(parameter, value));
    }
    return values.size() == 1 ? values.front()
           : values.empty()   ? ""
                              : fmt::format("({})", fmt::join(values, ", "));
}

std::string range_text(const StageParameter& parameter) {
    if (parameter.type == ParameterType::points) {
        return parameter.min_points > 1 ? fmt::format("{} or more", parameter.min_points) : "";
    }
    const bool has_min = std::isfinite(parameter.minimum);
    const bool has_max = std::isfinite(parameter.maximum);
    const std::string minimum = value_text(parameter, parameter.minimum);
    const std::string maximum = value_text(parameter, parameter.maximum);
    if (has_min && has_max) {
        return fmt::format("{}{} to {}", parameter.excludes_minimum ? "above " : "", minimum,
                           maximum);
    }
    return has_min   ? fmt::format("{}{}", parameter.excludes_minimum ? "above " : "from ", minimum)
           : has_max ? fmt::format("to {}", maximum)
                     : "";
}

std::string call_text(const camera::StageEntry& row) {
    if (row.formula) {
        return std::string(row.meaning.substr(row.meaning.find(fmt::format("{}(", row.name))));
    }
    std::vector<std::string> names;
    for (const StageParameter& parameter : row.parameters) {
        names.push_back(parameter.type == ParameterType::formula ? formula_text(parameter)
                                                                 : std::string(parameter.name));
    }
    return names.empty() ? std::string(row.name)
                         : fmt::format("{}({})", row.name, fmt::join(names, ", "));
}

}  // namespace balcony::cli
