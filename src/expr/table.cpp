// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "balcony/expr.hpp"

namespace balcony::expr {

namespace {

std::size_t coefficients_in_cell(std::span<const Table::Axis> axes) {
    std::size_t count = 1;
    for (const Table::Axis& axis : axes) {
        count *= axis.degree + 1;
    }
    return count;
}

}  // namespace

double Table::operator()(std::span<const double> at) const {
    assert(at.size() == axes.size());
    std::size_t cell_number = 0;
    std::array<double, max_axes> s{};
    std::array<std::size_t, max_axes> degree{};
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const auto count = static_cast<double>(axes[i].cells);
        const double position = (at[i] - axes[i].first) * (count / (axes[i].last - axes[i].first));
        // A NaN selects cell 0 and remains NaN through s.
        const double floored = std::floor(position);
        const double cell = floored > 0.0 ? std::min(floored, count - 1.0) : 0.0;
        s[i] = position - cell;
        degree[i] = axes[i].degree;
        cell_number = cell_number * axes[i].cells + static_cast<std::size_t>(cell);
    }
    // Horner's rule along each axis; missing axes have degree 0.
    const double* c = coefficients.data() + cell_number * coefficients_in_cell(axes);
    const auto along_2 = [&](const double* row) {
        double value = row[degree[2]];
        for (std::size_t k = degree[2]; k-- > 0;) {
            value = value * s[2] + row[k];
        }
        return value;
    };
    const auto along_1 = [&](const double* plane) {
        const std::size_t step = degree[2] + 1;
        double value = along_2(plane + degree[1] * step);
        for (std::size_t j = degree[1]; j-- > 0;) {
            value = value * s[1] + along_2(plane + j * step);
        }
        return value;
    };
    const std::size_t step = (degree[1] + 1) * (degree[2] + 1);
    double value = along_1(c + degree[0] * step);
    for (std::size_t i = degree[0]; i-- > 0;) {
        value = value * s[0] + along_1(c + i * step);
    }
    return value;
}

Table Table::derivative(std::size_t axis) const {
    const Axis& by = axes[axis];
    Table slopes{axes, {}};
    slopes.axes[axis].degree = by.degree == 0 ? 0 : by.degree - 1;
    const double scale = static_cast<double>(by.cells) / (by.last - by.first);
    // The coefficients are a list of blocks, each with the powers of this axis in
    // sequence, each power a run over the following axes.
    const std::size_t run = coefficients_in_cell(std::span(axes).subspan(axis + 1));
    const std::size_t block = (by.degree + 1) * run;
    for (std::size_t begin = 0; begin < coefficients.size(); begin += block) {
        for (std::size_t power = by.degree == 0 ? 0 : 1; power <= by.degree; ++power) {
            const double factor = static_cast<double>(power) * scale;
            for (std::size_t i = 0; i < run; ++i) {
                slopes.coefficients.push_back(factor * coefficients[begin + power * run + i]);
            }
        }
    }
    return slopes;
}

Table hermite_table(double first, double last, std::span<const double> values,
                    std::span<const double> slopes) {
    assert(values.size() >= 2 && values.size() == slopes.size());
    const std::size_t count = values.size() - 1;
    Table table{{{first, last, count, 3}}, {}};
    const double width = (last - first) / static_cast<double>(count);
    table.coefficients.reserve(4 * count);
    for (std::size_t i = 0; i < count; ++i) {
        const double rise = values[i + 1] - values[i];
        const double m0 = slopes[i] * width;
        const double m1 = slopes[i + 1] * width;
        const std::array cell{values[i], m0, 3.0 * rise - 2.0 * m0 - m1, m0 + m1 - 2.0 * rise};
        table.coefficients.insert(table.coefficients.end(), cell.begin(), cell.end());
    }
    return table;
}

}  // namespace balcony::expr
