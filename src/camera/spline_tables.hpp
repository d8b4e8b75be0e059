// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What curves and surfaces from points have in common: their parameters in the catalogue, what is
// made of these, and the tables that hold their polynomials.

#include <string_view>
#include <vector>

#include "balcony/catalogue.hpp"
#include "camera/cell_position.hpp"
#include "camera/spline.hpp"

namespace balcony::camera {

using TablePointer = std::shared_ptr<const expr::Table>;

/// An axis over cells 0, 1, ...: what a CellPosition leads to.
[[nodiscard]] expr::Table::Axis cells_axis(std::size_t cells, std::size_t degree);
[[nodiscard]] TablePointer table_of(std::span<const expr::Table::Axis> axes,
                                    std::vector<double> coefficients);

/// 0, 1/n, 2/n, ..., 1.
[[nodiscard]] std::vector<double> equal_breaks(std::size_t cells);
/// What hinders a CellPosition.
[[nodiscard]] std::optional<Diagnostic> fault_of_breaks(std::span<const double> breaks);

/// The co-ordinate numbered k of every point.
[[nodiscard]] std::vector<double> coordinate(const PointList& points, std::size_t k);

/// Points times their weights, co-ordinate by co-ordinate, and the weights.
struct WeightedPoints {
    std::vector<std::vector<double>> coordinates;
    std::vector<double> weights;
};
/// From the parameters points and weights. Points of `with_weight` co-ordinates have theirs in the
/// last.
[[nodiscard]] Result<WeightedPoints> weighted_points(const Arguments& a, std::size_t with_weight);

[[nodiscard]] std::optional<std::size_t> optional_count(const Arguments& a, std::string_view name);
[[nodiscard]] std::span<const double> optional_numbers(const Arguments& a, std::string_view name);

/// Without a degree given, 3 or as much as there are points for.
[[nodiscard]] std::size_t degree_for(std::size_t points, std::optional<std::size_t> given);
[[nodiscard]] SplineEnds ends_of(std::string_view choice);
/// Without a degree given, one piece.
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
