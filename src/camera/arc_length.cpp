// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/arc_length.hpp"

#include <cmath>
#include <vector>

namespace balcony::camera {

namespace {

// Gauss-Legendre quadrature with three points.
double integral(const std::function<double(double)>& f, double from, double to) {
    const double middle = 0.5 * (from + to);
    const double reach = 0.5 * (to - from);
    const double offset = reach * std::sqrt(0.6);
    return reach * (5.0 * f(middle - offset) + 8.0 * f(middle) + 5.0 * f(middle + offset)) / 9.0;
}

}  // namespace

expr::Table parameter_by_length(const std::function<double(double)>& speed, double parameter_last,
                                double u_last, std::size_t cells) {
    // The length at equal steps of the parameter, ...
    const std::size_t steps = 2 * cells;
    const double step = parameter_last / static_cast<double>(steps);
    std::vector<double> length(steps + 1, 0.0);
    for (std::size_t i = 0; i < steps; ++i) {
        const double from = step * static_cast<double>(i);
        length[i + 1] = length[i] + integral(speed, from, from + step);
    }
    // ... turned round: in each step the parameter is a cubic in the length, whose slopes at the
    // ends are known, and the wanted knots are read off it.
    const double unit = length[steps] / u_last;
    std::vector<double> parameter(cells + 1);
    std::vector<double> slope(cells + 1);
    std::size_t i = 0;
    for (std::size_t knot = 0; knot <= cells; ++knot) {
        const double target =
            length[steps] * static_cast<double>(knot) / static_cast<double>(cells);
        while (i + 1 < steps && length[i + 1] < target) {
            ++i;
        }
        const double from = step * static_cast<double>(i);
        const std::array ends{from, from + step};
        const std::array end_slopes{1.0 / speed(ends[0]), 1.0 / speed(ends[1])};
        const expr::Table inverse =
            expr::hermite_table(length[i], length[i + 1], ends, end_slopes);
        parameter[knot] = inverse(target);
        slope[knot] = unit / speed(parameter[knot]);
    }
    return expr::hermite_table(0.0, u_last, parameter, slope);
}

}  // namespace balcony::camera
