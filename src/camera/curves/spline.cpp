// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/curves/spline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "balcony/expr.hpp"

namespace balcony::camera {

Spline::Spline(std::vector<double> breaks, std::size_t degree, bool closed)
    : breaks_(std::move(breaks)), degree_(degree), closed_(closed) {
    assert(breaks_.size() >= 2 && breaks_.front() == 0.0 && breaks_.back() == 1.0);
    assert(degree_ <= expr::Table::max_degree);
}

// --------------------------------------------------------------------------------- B-splines

namespace {

using Local = std::array<double, expr::Table::max_degree + 1>;  ///< Of one span.

/// The polynomial of the span that begins at knots[span], in polar form: symmetric and affine in
/// each argument, and the polynomial itself where all are equal (Ramshaw 1989). De Boor's algorithm
/// with one argument for each of its steps; the first degree + 1 of `points` belong to the span.
double blossom(std::span<const double> knots, std::size_t span, std::size_t degree, Local points,
               const Local& arguments) {
    for (std::size_t step = 1; step <= degree; ++step) {
        for (std::size_t i = degree; i >= step; --i) {
            const double from = knots[span - degree + i];
            const double to = knots[span + 1 + i - step];
            const double fraction = (arguments[step - 1] - from) / (to - from);
            points[i] = std::lerp(points[i - 1], points[i], fraction);
        }
    }
    return points[degree];
}

/// Powers of r from Bernstein coefficients on [0, 1]: binomials times forward differences.
Local powers_from_bernstein(Local b, std::size_t degree) {
    Local powers{};
    double binomial = 1.0;
    for (std::size_t power = 0; power <= degree; ++power) {
        powers[power] = binomial * b[0];
        for (std::size_t i = 0; i + power < degree; ++i) {
            b[i] = b[i + 1] - b[i];
        }
        binomial *= static_cast<double>(degree - power) / static_cast<double>(power + 1);
    }
    return powers;
}

class BSpline final : public Spline {
public:
    /// The spline is defined from knot number `degree` to the knot with the same number of knots
    /// after it; this range is mapped to [0, 1]. Points are used periodically, starting with that
    /// number.
    BSpline(std::vector<double> knots, std::size_t degree, bool closed, std::size_t first_point = 0)
        : Spline(breaks_of(knots, degree), degree, closed),
          knots_(std::move(knots)),
          first_point_(first_point) {}

    std::vector<double> coefficients(std::span<const double> values) const override {
        std::vector<double> made;
        made.reserve(cells() * (degree() + 1));
        for (std::size_t span = degree(); span + degree() + 1 < knots_.size(); ++span) {
            if (knots_[span] < knots_[span + 1]) {
                const Local cell = cell_coefficients(values, span);
                made.insert(made.end(), cell.begin(),
                            cell.begin() + static_cast<std::ptrdiff_t>(degree() + 1));
            }
        }
        return made;
    }

private:
    static std::vector<double> breaks_of(const std::vector<double>& knots, std::size_t degree) {
        const double first = knots[degree];
        const double last = knots[knots.size() - degree - 1];
        std::vector<double> breaks;
        for (std::size_t i = degree; i + degree < knots.size(); ++i) {
            if (breaks.empty() || knots[i] > knots[i - 1]) {
                breaks.push_back((knots[i] - first) / (last - first));
            }
        }
        return breaks;
    }

    // The Bernstein coefficients of a span are its blossom at all combinations of its two ends.
    Local cell_coefficients(std::span<const double> values, std::size_t span) const {
        Local points{};
        for (std::size_t i = 0; i <= degree(); ++i) {
            points[i] = values[(first_point_ + span - degree() + i) % values.size()];
        }
        Local arguments{};
        arguments.fill(knots_[span]);
        Local bernstein{};
        for (std::size_t i = 0; i <= degree(); ++i) {
            bernstein[i] = blossom(knots_, span, degree(), points, arguments);
            arguments[i] = knots_[span + 1];
        }
        return powers_from_bernstein(bernstein, degree());
    }

    std::vector<double> knots_;
    std::size_t first_point_;
};

/// The number of knots for an open spline.
std::size_t knot_count(std::size_t points, std::size_t degree) { return points + degree + 1; }

std::vector<double> equal_knots(std::size_t points, std::size_t degree, SplineEnds ends) {
    const std::size_t wrapped = ends == SplineEnds::closed ? degree : 0;
    std::vector<double> knots(knot_count(points + wrapped, degree));
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const std::size_t within = std::clamp(i, degree, points);
        knots[i] = static_cast<double>(ends == SplineEnds::clamped ? within : i);
    }
    return knots;
}

/// The error of knots given by a user, if any.
std::optional<Diagnostic> fault_of(std::span<const double> knots, std::size_t points,
                                   std::size_t degree) {
    const std::size_t count = knot_count(points, degree);
    if (knots.size() != count) {
        return error(fmt::format("{} points of degree {} need {} knots, not {}", points, degree,
                                 count, knots.size()),
                     {}, "the number of knots is the number of points plus the degree plus 1");
    }
    if (!std::is_sorted(knots.begin(), knots.end())) {
        return error("knots must not decrease", {}, "sort them");
    }
    for (std::size_t i = 1; i + degree + 1 < knots.size(); ++i) {
        if (knots[i] == knots[i + degree]) {
            return error(
                fmt::format("the knot {} occurs more than {} times, which would break the "
                            "spline there",
                            knots[i], degree),
                {},
                fmt::format("repeat a knot at most {} times, or once more at the ends", degree));
        }
    }
    return std::nullopt;
}

}  // namespace

Result<SplinePointer> make_bspline(std::size_t points, std::size_t degree, SplineEnds ends,
                                   std::span<const double> knots) {
    assert(1 <= degree && degree <= expr::Table::max_degree);
    if (points <= degree) {
        return error(fmt::format("a spline of degree {} needs at least {} points, but has {}",
                                 degree, degree + 1, points),
                     {}, "add points or lower the degree");
    }
    const bool closed = ends == SplineEnds::closed;
    if (!knots.empty() && closed) {
        return error("a closed spline has equally spaced knots", {},
                     "remove the knots, or repeat the first points at the end and use ends = "
                     "open");
    }
    if (!knots.empty()) {
        if (std::optional<Diagnostic> fault = fault_of(knots, points, degree)) {
            return std::move(*fault);
        }
    }
    std::vector<double> all = knots.empty() ? equal_knots(points, degree, ends)
                                            : std::vector<double>(knots.begin(), knots.end());
    // A closed one starts where the first point has the largest weight, or the same as the second.
    const std::size_t first_point = closed ? points - (degree - 1) / 2 : 0;
    return SplinePointer(
        std::make_shared<const BSpline>(std::move(all), degree, closed, first_point));
}

// Bézier pieces are a B-spline in which the multiplicity of each knot is the degree.
Result<SplinePointer> make_bezier(std::size_t points, std::size_t degree, bool closed) {
    assert(1 <= degree && degree <= expr::Table::max_degree);
    const std::size_t steps = closed ? points : points - 1;
    if (points == 0 || steps == 0 || steps % degree != 0) {
        return error(fmt::format("{} points do not form {}Bézier pieces of degree {}", points,
                                 closed ? "closed " : "", degree),
                     {},
                     closed ? fmt::format("give a multiple of {} points", degree)
                            : fmt::format("give a multiple of {} points plus one", degree));
    }
    const std::size_t pieces = steps / degree;
    std::vector<double> knots{0.0};
    for (std::size_t i = 0; i <= pieces; ++i) {
        knots.insert(knots.end(), degree, static_cast<double>(i));
    }
    knots.push_back(static_cast<double>(pieces));
    return SplinePointer(std::make_shared<const BSpline>(std::move(knots), degree, closed));
}

// ----------------------------------------------------------------------------- interpolation

namespace {

/// Solves a system whose row i is lower[i], diagonal[i], upper[i] around the diagonal, by Gaussian
/// elimination without pivoting: the diagonal must dominate.
std::vector<double> solve_tridiagonal(std::span<const double> lower, std::vector<double> diagonal,
                                      std::span<const double> upper, std::vector<double> right) {
    const std::size_t n = right.size();
    for (std::size_t i = 1; i < n; ++i) {
        const double factor = lower[i] / diagonal[i - 1];
        diagonal[i] -= factor * upper[i - 1];
        right[i] -= factor * right[i - 1];
    }
    right[n - 1] /= diagonal[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) {
        right[i] = (right[i] - upper[i] * right[i + 1]) / diagonal[i];
    }
    return right;
}

/// The cyclic system: the first row also has lower[0] in the last column, and the last row
/// upper[n - 1] in the first column (by the Sherman-Morrison formula).
std::vector<double> solve_cyclic(std::span<const double> lower, std::vector<double> diagonal,
                                 std::span<const double> upper, const std::vector<double>& right) {
    const std::size_t n = right.size();
    const double gamma = -diagonal[0];
    const double corner = lower[0] / gamma;
    diagonal[0] -= gamma;
    diagonal[n - 1] -= upper[n - 1] * corner;
    std::vector<double> column(n, 0.0);
    column[0] = gamma;
    column[n - 1] = upper[n - 1];
    std::vector<double> x = solve_tridiagonal(lower, diagonal, upper, right);
    const std::vector<double> z = solve_tridiagonal(lower, diagonal, upper, column);
    const double factor = (x[0] + corner * x[n - 1]) / (1.0 + z[0] + corner * z[n - 1]);
    for (std::size_t i = 0; i < n; ++i) {
        x[i] -= factor * z[i];
    }
    return x;
}

/// The cells on both sides of each value: their widths and the slopes of their chords. The cell
/// before the first value of an open spline, and the one after the last, have no width.
struct Neighbours {
    std::vector<double> width_before, width_after, chord_before, chord_after;

    Neighbours(std::span<const double> breaks, std::span<const double> values, bool closed) {
        const std::size_t n = values.size();
        const std::size_t cells = breaks.size() - 1;
        for (std::size_t i = 0; i < n; ++i) {
            const bool has_before = closed || i > 0;
            const bool has_after = closed || i < cells;
            const std::size_t before = (i + cells - 1) % cells;
            const auto width = [&](std::size_t cell) { return breaks[cell + 1] - breaks[cell]; };
            const auto chord = [&](std::size_t cell) {
                return (values[(cell + 1) % n] - values[cell]) / width(cell);
            };
            width_before.push_back(has_before ? width(before) : 0.0);
            width_after.push_back(has_after ? width(i) : 0.0);
            chord_before.push_back(has_before ? chord(before) : 0.0);
            chord_after.push_back(has_after ? chord(i) : 0.0);
        }
    }
};

/// The slope of the parabola through each value and its two neighbours (Barry and Goldman 1988 for
/// unequal steps); at an open end, of the parabola that ends there.
std::vector<double> catmull_rom_slopes(const Neighbours& at, bool closed, const EndSlopes& ends) {
    const std::size_t n = at.width_after.size();
    std::vector<double> slopes(n);
    for (std::size_t i = 0; i < n; ++i) {
        slopes[i] =
            (at.width_after[i] * at.chord_before[i] + at.width_before[i] * at.chord_after[i]) /
            (at.width_before[i] + at.width_after[i]);
    }
    if (!closed) {
        const bool straight = n == 2;
        slopes[0] =
            ends.first.value_or(straight ? at.chord_after[0] : 2.0 * at.chord_after[0] - slopes[1]);
        slopes[n - 1] = ends.last.value_or(straight ? at.chord_before[n - 1]
                                                    : 2.0 * at.chord_before[n - 1] - slopes[n - 2]);
    }
    return slopes;
}

/// The slopes that make the second derivative continuous.
std::vector<double> natural_slopes(const Neighbours& at, bool closed, const EndSlopes& ends) {
    const std::size_t n = at.width_after.size();
    std::vector<double> lower(n), diagonal(n), upper(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        // At an open end the missing cell has no terms, which leaves the natural condition.
        lower[i] = at.width_before[i] > 0.0 ? 1.0 / at.width_before[i] : 0.0;
        upper[i] = at.width_after[i] > 0.0 ? 1.0 / at.width_after[i] : 0.0;
        diagonal[i] = 2.0 * (lower[i] + upper[i]);
        right[i] = 3.0 * (lower[i] * at.chord_before[i] + upper[i] * at.chord_after[i]);
    }
    if (closed) {
        return solve_cyclic(lower, diagonal, upper, right);
    }
    const auto prescribe = [&](std::size_t i, const std::optional<double>& slope) {
        if (slope) {
            lower[i] = upper[i] = 0.0;
            diagonal[i] = 1.0;
            right[i] = *slope;
        }
    };
    prescribe(0, ends.first);
    prescribe(n - 1, ends.last);
    return solve_tridiagonal(lower, diagonal, upper, right);
}

}  // namespace

InterpolatingSpline::InterpolatingSpline(Interpolation interpolation, std::vector<double> breaks,
                                         bool closed)
    : Spline(std::move(breaks), 3, closed), interpolation_(interpolation) {
    assert(!closed || cells() >= 2);
}

std::vector<double> InterpolatingSpline::coefficients(std::span<const double> values,
                                                      const EndSlopes& ends) const {
    const Neighbours neighbours(breaks(), values, closed());
    const auto slopes_by =
        interpolation_ == Interpolation::natural ? natural_slopes : catmull_rom_slopes;
    return hermite_coefficients(breaks(), values, slopes_by(neighbours, closed(), ends));
}

std::vector<double> hermite_coefficients(std::span<const double> breaks,
                                         std::span<const double> values,
                                         std::span<const double> slopes) {
    std::vector<double> made;
    made.reserve(4 * (breaks.size() - 1));
    for (std::size_t cell = 0; cell + 1 < breaks.size(); ++cell) {
        const std::size_t next = (cell + 1) % values.size();
        const double width = breaks[cell + 1] - breaks[cell];
        const double rise = values[next] - values[cell];
        const double m0 = slopes[cell] * width;
        const double m1 = slopes[next] * width;
        made.insert(made.end(),
                    {values[cell], m0, 3.0 * rise - 2.0 * m0 - m1, m0 + m1 - 2.0 * rise});
    }
    return made;
}

}  // namespace balcony::camera
