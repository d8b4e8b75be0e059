// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/arc_length.hpp"

#include <array>
#include <cmath>

#include "balcony/expr.hpp"

namespace balcony::camera {

EndGrading::EndGrading(double crowding) : crowding_(crowding), reach_(std::atanh(crowding)) {}

double EndGrading::fraction(double position) const {
    if (crowding_ == 0.0) {
        return position;
    }
    return 0.5 * (1.0 + std::tanh(reach_ * (2.0 * position - 1.0)) / crowding_);
}

double EndGrading::slope(double position) const {
    if (crowding_ == 0.0) {
        return 1.0;
    }
    const double cosh = std::cosh(reach_ * (2.0 * position - 1.0));
    return reach_ / (crowding_ * cosh * cosh);
}

namespace {

// Gauss-Legendre quadrature with three points.
double integral(const std::function<double(double)>& f, double from, double to) {
    const double middle = 0.5 * (from + to);
    const double reach = 0.5 * (to - from);
    const double offset = reach * std::sqrt(0.6);
    return reach * (5.0 * f(middle - offset) + 8.0 * f(middle) + 5.0 * f(middle + offset)) / 9.0;
}

double fraction_of(std::size_t i, std::size_t count) {
    return static_cast<double>(i) / static_cast<double>(count);
}

}  // namespace

Knots parameter_by_length(const std::function<double(double)>& speed, double parameter_last,
                          const EndGrading& grading, std::size_t cells) {
    // The length at graded steps of the parameter, ...
    const std::size_t steps = 2 * cells;
    std::vector<double> parameter(steps + 1, 0.0);
    std::vector<double> length(steps + 1, 0.0);
    for (std::size_t i = 1; i <= steps; ++i) {
        parameter[i] = parameter_last * grading.fraction(fraction_of(i, steps));
        length[i] = length[i - 1] + integral(speed, parameter[i - 1], parameter[i]);
    }
    // ... turned round: in each step the parameter is a cubic in the length, whose slopes at the
    // ends are known, and the wanted knots are read off it.
    Knots knots;
    std::size_t i = 0;
    for (std::size_t knot = 0; knot <= cells; ++knot) {
        const double position = fraction_of(knot, cells);
        const double target = length[steps] * grading.fraction(position);
        while (i + 1 < steps && length[i + 1] < target) {
            ++i;
        }
        const std::array ends{parameter[i], parameter[i + 1]};
        const std::array end_slopes{1.0 / speed(ends[0]), 1.0 / speed(ends[1])};
        const expr::Table inverse = expr::hermite_table(length[i], length[i + 1], ends, end_slopes);
        knots.values.push_back(inverse(target));
        knots.slopes.push_back(length[steps] * grading.slope(position) /
                               speed(knots.values.back()));
    }
    return knots;
}

}  // namespace balcony::camera
