// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/curves/arc_length.hpp"

#include <algorithm>
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

double fraction_of(std::size_t i, std::size_t count) {
    return static_cast<double>(i) / static_cast<double>(count);
}

// The length up to each of the parameters, by Gauss-Legendre quadrature with three points a step.
std::vector<double> lengths_up_to(const Speeds& speeds, std::span<const double> parameters) {
    constexpr std::array weights{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    const double offset = 0.5 * std::sqrt(0.6);
    std::vector<double> nodes;
    for (std::size_t i = 0; i + 1 < parameters.size(); ++i) {
        for (const double fraction : {0.5 - offset, 0.5, 0.5 + offset}) {
            nodes.push_back(std::lerp(parameters[i], parameters[i + 1], fraction));
        }
    }
    const std::vector<double> speed = speeds(nodes);
    std::vector<double> lengths{0.0};
    for (std::size_t i = 0; i + 1 < parameters.size(); ++i) {
        double mean = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            mean += weights[k] * speed[3 * i + k];
        }
        lengths.push_back(lengths.back() + mean * (parameters[i + 1] - parameters[i]));
    }
    return lengths;
}

// Limits a slope so that a cubic increases over a cell of that mean slope (Fritsch and Carlson
// 1980); it may have been infinite.
double monotone(double slope, double mean_slope) { return std::min(slope, 3.0 * mean_slope); }

}  // namespace

Knots parameter_by_length(const Speeds& speeds, double parameter_last, const EndGrading& grading,
                          std::size_t cells) {
    // The length at graded steps of the parameter, ...
    const std::size_t steps = 2 * cells;
    std::vector<double> parameter(steps + 1);
    for (std::size_t i = 0; i <= steps; ++i) {
        parameter[i] = parameter_last * grading.fraction(fraction_of(i, steps));
    }
    const std::vector<double> length = lengths_up_to(speeds, parameter);
    const std::vector<double> speed = speeds(parameter);
    // ... inverted: in each step the parameter is a cubic in the length, whose slopes at the
    // ends are known. The requested knots are evaluated from it.
    Knots knots;
    std::size_t i = 0;
    for (std::size_t knot = 0; knot <= cells; ++knot) {
        const double target = length[steps] * grading.fraction(fraction_of(knot, cells));
        while (i + 1 < steps && length[i + 1] < target) {
            ++i;
        }
        const std::array ends{parameter[i], parameter[i + 1]};
        const double mean = (ends[1] - ends[0]) / (length[i + 1] - length[i]);
        const std::array end_slopes{monotone(1.0 / speed[i], mean),
                                    monotone(1.0 / speed[i + 1], mean)};
        const expr::Table inverse = expr::hermite_table(length[i], length[i + 1], ends, end_slopes);
        knots.values.push_back(inverse(target));
    }
    const std::vector<double> knot_speed = speeds(knots.values);
    for (std::size_t knot = 0; knot <= cells; ++knot) {
        double slope = length[steps] * grading.slope(fraction_of(knot, cells)) / knot_speed[knot];
        for (const std::size_t cell : {knot - 1, knot}) {
            if (cell < cells) {
                const double rise = knots.values[cell + 1] - knots.values[cell];
                slope = monotone(slope, rise * static_cast<double>(cells));
            }
        }
        knots.slopes.push_back(slope);
    }
    return knots;
}

}  // namespace balcony::camera
