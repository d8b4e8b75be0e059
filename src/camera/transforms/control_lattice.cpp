// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/transforms/control_lattice.hpp"

#include <cassert>

namespace balcony::camera {

namespace {

/// The cells along one axis and the degree of their polynomials.
struct Cells {
    std::size_t count = 1;
    std::size_t degree = 3;
    [[nodiscard]] std::size_t coefficients() const { return count * (degree + 1); }
};

Cells cells_of(const LatticeAxis& axis, LatticeBasis basis) {
    switch (basis) {
        case LatticeBasis::bernstein: return {1, axis.points - 1};
        case LatticeBasis::quadratic: return {axis.points - 2, 2};
        default: return {axis.points - 1, 3};
    }
}

/// The coefficients, by cell, of the uniform cubic B-spline with the given control values; those
/// before the first and after the last are extrapolated linearly, so that the ends are
/// interpolated.
std::vector<double> b_spline(std::span<const double> control) {
    const std::size_t last = control.size() - 1;
    std::vector<double> powers;
    for (std::size_t i = 0; i < last; ++i) {
        const double b = control[i];
        const double c = control[i + 1];
        const double a = i > 0 ? control[i - 1] : 2.0 * b - c;
        const double d = i + 2 <= last ? control[i + 2] : 2.0 * c - b;
        for (const double power : {(a + 4.0 * b + c) / 6.0, (c - a) / 2.0, (a - 2.0 * b + c) / 2.0,
                                   (d - 3.0 * c + 3.0 * b - a) / 6.0}) {
            powers.push_back(power);
        }
    }
    return powers;
}

/// The same of a quadratic B-spline, without what is beyond the middles between the first two and
/// between the last two values.
std::vector<double> quadratic_b_spline(std::span<const double> control) {
    std::vector<double> powers;
    for (std::size_t i = 0; i + 2 < control.size(); ++i) {
        const double a = control[i];
        const double b = control[i + 1];
        const double c = control[i + 2];
        for (const double power : {(a + b) / 2.0, b - a, (a - 2.0 * b + c) / 2.0}) {
            powers.push_back(power);
        }
    }
    return powers;
}

/// The control values whose B-spline interpolates the values: (c[i-1] + 4 c[i] + c[i+1])/6 = v[i],
/// with c = v at the ends. Gaussian elimination of the tridiagonal system.
std::vector<double> interpolating_control(std::span<const double> values) {
    const std::size_t last = values.size() - 1;
    std::vector<double> control(values.begin(), values.end());
    std::vector<double> diagonal(values.size(), 4.0);
    for (std::size_t i = 1; i < last; ++i) {
        control[i] = 6.0 * values[i] - (i + 1 == last ? values[last] : 0.0);
        if (i == 1) {
            control[i] -= values[0];
        } else {
            diagonal[i] -= 1.0 / diagonal[i - 1];
            control[i] -= control[i - 1] / diagonal[i - 1];
        }
    }
    for (std::size_t i = last; i-- > 1;) {
        const double behind = i + 1 == last ? 0.0 : control[i + 1];
        control[i] = (control[i] - behind) / diagonal[i];
    }
    return control;
}

/// The coefficients of the Bernstein polynomial with the given control values: binomial(degree, k)
/// times their k-th differences at the first.
std::vector<double> bernstein(std::span<const double> control) {
    std::vector<double> difference(control.begin(), control.end());
    const std::size_t degree = control.size() - 1;
    std::vector<double> powers;
    double binomial = 1.0;
    for (std::size_t k = 0; k <= degree; ++k) {
        powers.push_back(binomial * difference[0]);
        for (std::size_t i = 0; i + k < degree; ++i) {
            difference[i] = difference[i + 1] - difference[i];
        }
        binomial *= static_cast<double>(degree - k) / static_cast<double>(k + 1);
    }
    return powers;
}

std::vector<double> powers_along(std::span<const double> line, LatticeBasis basis) {
    switch (basis) {
        case LatticeBasis::b_spline: return b_spline(line);
        case LatticeBasis::quadratic: return quadratic_b_spline(line);
        case LatticeBasis::interpolating: return b_spline(interpolating_control(line));
        case LatticeBasis::bernstein: break;
    }
    return bernstein(line);
}

/// Replaces every line along the last axis by its coefficients, and makes that axis the first. Once
/// for each axis processes all axes and restores their order.
std::vector<double> expand_last_axis(std::span<const double> values, std::size_t points,
                                     LatticeBasis basis) {
    const std::size_t lines = values.size() / points;
    std::vector<double> expanded;
    for (std::size_t line = 0; line < lines; ++line) {
        const std::vector<double> powers =
            powers_along(values.subspan(line * points, points), basis);
        expanded.resize(powers.size() * lines);
        for (std::size_t k = 0; k < powers.size(); ++k) {
            expanded[k * lines + line] = powers[k];
        }
    }
    return expanded;
}

/// From (cell, power) per axis to all cells first, then all powers, as in a table.
std::vector<double> cells_first(std::span<const double> expanded, std::span<const Cells> cells) {
    std::vector<double> sorted(expanded.size());
    for (std::size_t from = 0; from < expanded.size(); ++from) {
        std::size_t rest = from;
        std::size_t cell = 0;
        std::size_t power = 0;
        std::size_t cell_step = 1;
        std::size_t power_step = 1;
        for (std::size_t axis = cells.size(); axis-- > 0;) {
            const std::size_t place = rest % cells[axis].coefficients();
            rest /= cells[axis].coefficients();
            cell += cell_step * (place / (cells[axis].degree + 1));
            power += power_step * (place % (cells[axis].degree + 1));
            cell_step *= cells[axis].count;
            power_step *= cells[axis].degree + 1;
        }
        sorted[cell * power_step + power] = expanded[from];
    }
    return sorted;
}

}  // namespace

std::size_t coefficient_count(std::span<const LatticeAxis> axes, LatticeBasis basis) {
    std::size_t count = 1;
    for (const LatticeAxis& axis : axes) {
        count *= cells_of(axis, basis).coefficients();
    }
    return count;
}

expr::Table lattice_table(std::span<const LatticeAxis> axes, std::vector<double> values,
                          LatticeBasis basis) {
    expr::Table table;
    std::vector<Cells> cells;
    for (const LatticeAxis& axis : axes) {
        assert(axis.points >= (basis == LatticeBasis::quadratic ? 3 : 2));
        cells.push_back(cells_of(axis, basis));
        const double within =
            basis == LatticeBasis::quadratic
                ? 0.5 * (axis.last - axis.first) / static_cast<double>(axis.points - 1)
                : 0.0;
        table.axes.push_back(
            {axis.first + within, axis.last - within, cells.back().count, cells.back().degree});
    }
    for (std::size_t axis = axes.size(); axis-- > 0;) {
        values = expand_last_axis(values, axes[axis].points, basis);
    }
    table.coefficients = cells_first(values, cells);
    return table;
}

}  // namespace balcony::camera
