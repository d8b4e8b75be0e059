// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Common parts of curves and surfaces from points: their parameters in the catalogue, the values
// made of these, and the tables of their polynomials.

#include <string_view>
#include <vector>

#include "balcony/catalogue.hpp"
#include "camera/curves/spline.hpp"
#include "camera/tables/cell_position.hpp"

namespace balcony::camera {

using TablePointer = std::shared_ptr<const expr::Table>;

/// An axis over cells 0, 1, ...: the result of a CellPosition.
[[nodiscard]] expr::Table::Axis cells_axis(std::size_t cells, std::size_t degree);
[[nodiscard]] TablePointer table_of(std::span<const expr::Table::Axis> axes,
                                    std::vector<double> coefficients);

/// 0, 1/n, 2/n, ..., 1.
[[nodiscard]] std::vector<double> equal_breaks(std::size_t cells);
/// The error that prevents a CellPosition, if any.
[[nodiscard]] std::optional<Diagnostic> fault_of_breaks(std::span<const double> breaks);

/// The coordinate numbered k of every point.
[[nodiscard]] std::vector<double> coordinate(const PointList& points, std::size_t k);

/// Points times their weights, by coordinate, and the weights.
struct WeightedPoints {
    std::vector<std::vector<double>> coordinates;
    std::vector<double> weights;
};
/// From the parameters points and weights. Points of `with_weight` coordinates have theirs in the
/// last.
[[nodiscard]] Result<WeightedPoints> weighted_points(const Arguments& a, std::size_t with_weight);

[[nodiscard]] std::optional<std::size_t> optional_count(const Arguments& a, std::string_view name);
[[nodiscard]] std::span<const double> optional_numbers(const Arguments& a, std::string_view name);

/// By default 3, or the maximum for the number of points.
[[nodiscard]] std::size_t degree_for(std::size_t points, std::optional<std::size_t> given);
[[nodiscard]] SplineEnds ends_of(std::string_view choice);
/// By default, one piece.
[[nodiscard]] Result<SplinePointer> bezier_spline(std::size_t points,
                                                  std::optional<std::size_t> degree, bool closed);

[[nodiscard]] StageParameter points_parameter(std::vector<std::size_t> coordinates,
                                              std::size_t minimum, std::string_view meaning);
[[nodiscard]] StageParameter weights_parameter();
[[nodiscard]] StageParameter knots_parameter(std::string_view name);
[[nodiscard]] StageParameter optional_degree_parameter(std::string_view meaning,
                                                       std::string_view name = "degree");
[[nodiscard]] StageParameter ends_parameter(std::string_view name, std::string_view meaning);
[[nodiscard]] StageParameter closed_parameter(std::string_view name, std::string_view meaning);

}  // namespace balcony::camera
