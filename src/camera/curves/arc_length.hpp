// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace balcony::camera {

/// A smooth map of [0, 1] onto itself that expands the parts near both ends, so that equal steps of
/// the position are finest there: position = (1 + atanh(k (2 fraction - 1)) / atanh(k)) / 2 with
/// the crowding k in [0, 1); 0 gives the identity.
class EndGrading {
public:
    explicit EndGrading(double crowding);

    [[nodiscard]] double crowding() const { return crowding_; }
    /// atanh(crowding).
    [[nodiscard]] double reach() const { return reach_; }
    [[nodiscard]] double fraction(double position) const;
    /// d fraction / d position.
    [[nodiscard]] double slope(double position) const;

private:
    double crowding_;
    double reach_;
};

/// Values and slopes of a function of a position in [0, 1] at equal steps of the position.
struct Knots {
    std::vector<double> values;
    std::vector<double> slopes;
};

/// The speeds |dC/dparameter| of a curve at many parameters, none negative.
using Speeds = std::function<std::vector<double>(std::span<const double> parameters)>;

/// The parameter in [0, parameter_last] of a curve with the given speeds, as a
/// monotonic function of the graded fraction of its length. Where the speed is
/// smooth and not 0, the error decreases with the fourth power of the number of cells; at the ends
/// the speed may be singular if the grading concentrates there.
[[nodiscard]] Knots parameter_by_length(const Speeds& speeds, double parameter_last,
                                        const EndGrading& grading, std::size_t cells);

}  // namespace balcony::camera
