// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Splines in one variable, for curves and, applied along both axes of a net, for surfaces. A spline
// is linear in its control values, so one spline is used for all coordinates of its points.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/expr.hpp"

namespace balcony::camera {

/// A linear map from control values to a piecewise polynomial on [0, 1]. Immutable.
class Spline {
public:
    Spline(std::vector<double> breaks, std::size_t degree, bool closed);
    Spline(const Spline&) = delete;
    Spline& operator=(const Spline&) = delete;
    virtual ~Spline() = default;

    /// The limits of the cells: increasing, from 0 to 1, at least two.
    [[nodiscard]] const std::vector<double>& breaks() const { return breaks_; }
    [[nodiscard]] std::size_t cells() const { return breaks_.size() - 1; }
    [[nodiscard]] std::size_t degree() const { return degree_; }
    /// Whether it has period 1.
    [[nodiscard]] bool closed() const { return closed_; }

    /// The polynomials, by cell and power of r, which runs from 0 to 1 in
    /// every cell.
    [[nodiscard]] virtual std::vector<double> coefficients(
        std::span<const double> values) const = 0;

private:
    std::vector<double> breaks_;
    std::size_t degree_;
    bool closed_;
};

using SplinePointer = std::shared_ptr<const Spline>;

/// The ends of a B-spline: it interpolates the end points; it does not reach them, because
/// every knot is single; it is periodic.
enum class SplineEnds : std::uint8_t { clamped, open, closed };

/// The B-spline of a degree from 1 to Table::max_degree for a number of points above the degree.
/// Without knots they are equally spaced.
[[nodiscard]] Result<SplinePointer> make_bspline(std::size_t points, std::size_t degree,
                                                 SplineEnds ends,
                                                 std::span<const double> knots = {});

/// Bézier pieces of a degree, each starting at the last point of the previous one; a closed one
/// ends with the first point, which is not repeated.
[[nodiscard]] Result<SplinePointer> make_bezier(std::size_t points, std::size_t degree,
                                                bool closed);

/// The slopes of an interpolating cubic: from each point's neighbours,
/// or such that its second derivative is continuous, and 0 at open ends.
enum class Interpolation : std::uint8_t { catmull_rom, natural };

/// The slopes of a spline at its open ends, with respect to the parameter.
struct EndSlopes {
    std::optional<double> first{};
    std::optional<double> last{};
};

/// The cubic through at least two given values at its breaks. A closed one has one break more
/// than values, because it returns to the first.
class InterpolatingSpline final : public Spline {
public:
    InterpolatingSpline(Interpolation interpolation, std::vector<double> breaks, bool closed);
    [[nodiscard]] std::vector<double> coefficients(std::span<const double> values) const override {
        return coefficients(values, {});
    }
    [[nodiscard]] std::vector<double> coefficients(std::span<const double> values,
                                                   const EndSlopes& ends) const;

private:
    Interpolation interpolation_;
};

/// The cubic with given values and slopes by the parameter at its breaks.
[[nodiscard]] std::vector<double> hermite_coefficients(std::span<const double> breaks,
                                                       std::span<const double> values,
                                                       std::span<const double> slopes);

}  // namespace balcony::camera
