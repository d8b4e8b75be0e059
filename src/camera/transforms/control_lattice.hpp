// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "balcony/expr.hpp"

namespace balcony::camera {

/// How values at the points of a lattice define a function; each basis reproduces a constant
/// and a linear function. With cubic ones, which are twice continuously differentiable, the
/// second derivative across the border of the box is 0.
enum class LatticeBasis : std::uint8_t {
    b_spline,       ///< Uniform cubic B-splines: approximate the values, interpolate the corners.
    quadratic,      ///< Uniform quadratic B-splines, whose values are in the middle of their cells:
                    ///< the box ends half a step within the first and the last value.
    interpolating,  ///< Natural cubic splines: interpolate all values.
    bernstein,      ///< One polynomial, a Bézier patch: interpolates the corners.
};

/// `points` equally spaced positions from `first` to `last`, both included; at least two.
struct LatticeAxis {
    double first = 0.0;
    double last = 1.0;
    std::size_t points = 2;
};

/// The maximum number of points along an axis of a Bernstein lattice.
inline constexpr std::size_t max_bernstein_points = expr::Table::max_degree + 1;

/// The number of coefficients of a lattice's table.
[[nodiscard]] std::size_t coefficient_count(std::span<const LatticeAxis> axes, LatticeBasis basis);

/// The function over the box of the axes that belongs to the values, of which those along the last
/// axis stand next to each other.
[[nodiscard]] expr::Table lattice_table(std::span<const LatticeAxis> axes,
                                        std::vector<double> values, LatticeBasis basis);

}  // namespace balcony::camera
