// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/curves/spline_tables.hpp"
#include "camera/catalogue/stage_parameters.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace balcony::camera {

expr::Table::Axis cells_axis(std::size_t cells, std::size_t degree) {
    return {0.0, static_cast<double>(cells), cells, degree};
}

TablePointer table_of(std::span<const expr::Table::Axis> axes, std::vector<double> coefficients) {
    return std::make_shared<const expr::Table>(
        expr::Table{{axes.begin(), axes.end()}, std::move(coefficients)});
}

std::vector<double> equal_breaks(std::size_t cells) {
    std::vector<double> breaks;
    for (std::size_t i = 0; i <= cells; ++i) {
        breaks.push_back(static_cast<double>(i) / static_cast<double>(cells));
    }
    return breaks;
}

std::optional<Diagnostic> fault_of_breaks(std::span<const double> breaks) {
    if (CellPosition::equally_spaced(breaks) ||
        CellPosition::narrowest(breaks) >= CellPosition::narrowest_cell) {
        return std::nullopt;
    }
    return error(fmt::format("one piece of the spline covers less than 1/{} of its parameter",
                             1.0 / CellPosition::narrowest_cell),
                 {}, "remove points that nearly coincide, or space points or knots more evenly");
}

std::vector<double> coordinate(const PointList& points, std::size_t k) {
    std::vector<double> values;
    values.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        values.push_back(points[i][k]);
    }
    return values;
}

Result<WeightedPoints> weighted_points(const Arguments& a, std::size_t with_weight) {
    const PointList& points = a.points("points");
    const bool among_points = points.coordinates == with_weight;
    if (among_points && a.has("weights")) {
        return error("weights are given both with the points and as a list", {},
                     "remove one of them");
    }
    WeightedPoints made;
    made.weights = a.has("weights") ? a.points("weights").values
                   : among_points   ? coordinate(points, with_weight - 1)
                                    : std::vector<double>(points.size(), 1.0);
    if (made.weights.size() != points.size()) {
        return error(
            fmt::format("{} points cannot have {} weights", points.size(), made.weights.size()), {},
            "give one weight for each point");
    }
    for (const double weight : made.weights) {
        if (!(weight > 0.0)) {
            return error(fmt::format("a weight must be above 0, not {}", weight), {},
                         "a point with a small weight has hardly any influence");
        }
    }
    for (std::size_t k = 0; k < points.coordinates - (among_points ? 1 : 0); ++k) {
        std::vector<double> values = coordinate(points, k);
        std::transform(values.begin(), values.end(), made.weights.begin(), values.begin(),
                       std::multiplies<>());
        made.coordinates.push_back(std::move(values));
    }
    return made;
}

std::optional<std::size_t> optional_count(const Arguments& a, std::string_view name) {
    return a.has(name) ? std::optional(a.count(name)) : std::nullopt;
}

std::span<const double> optional_numbers(const Arguments& a, std::string_view name) {
    return a.has(name) ? std::span<const double>(a.points(name).values) : std::span<const double>();
}

std::size_t degree_for(std::size_t points, std::optional<std::size_t> given) {
    return given.value_or(std::clamp<std::size_t>(points, 2, 4) - 1);
}

SplineEnds ends_of(std::string_view choice) {
    return choice == "closed" ? SplineEnds::closed
           : choice == "open" ? SplineEnds::open
                              : SplineEnds::clamped;
}

Result<SplinePointer> bezier_spline(std::size_t points, std::optional<std::size_t> degree,
                                    bool closed) {
    const std::size_t one_piece = closed ? points : points - 1;
    if (!degree && one_piece > expr::Table::max_degree) {
        return error(fmt::format("{} control points are too many for one piece", points), {},
                     fmt::format("give the degree of the pieces, such as degree = 3, or at "
                                 "most {} points",
                                 expr::Table::max_degree + (closed ? 0 : 1)));
    }
    return make_bezier(points, degree.value_or(std::max<std::size_t>(one_piece, 1)), closed);
}

StageParameter points_parameter(std::vector<std::size_t> coordinates, std::size_t minimum,
                                std::string_view meaning) {
    return {.name = "points",
            .type = PointsParameter{.coordinates = std::move(coordinates), .min_points = minimum},
            .meaning = meaning};
}

StageParameter weights_parameter() {
    return {.name = "weights",
            .type = PointsParameter{.coordinates = {1}},
            .optional = true,
            .meaning = "weight of each point, above 0; 1 by default"};
}

StageParameter knots_parameter(std::string_view name) {
    return {.name = name,
            .type = PointsParameter{.coordinates = {1}, .min_points = 4},
            .optional = true,
            .meaning =
                "the knots in order: the number of points plus the degree plus 1; the range "
                "where the spline is defined is mapped to 0 to 1"};
}

StageParameter optional_degree_parameter(std::string_view meaning, std::string_view name) {
    return {
        .name = name,
        .type = CountParameter{.range = {.minimum = 1.0,
                                         .maximum = static_cast<double>(expr::Table::max_degree)}},
        .optional = true,
        .meaning = meaning};
}

StageParameter ends_parameter(std::string_view name, std::string_view meaning) {
    return choice_parameter(name, {"clamped", "open", "closed"}, meaning);
}

StageParameter closed_parameter(std::string_view name, std::string_view meaning) {
    return choice_parameter(name, {"no", "yes"}, meaning);
}

}  // namespace balcony::camera
