// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The method of Levenberg and Marquardt for least squares with limits.

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include <Eigen/Core>

namespace balcony::solve {

/// Numbers whose squares are summed, and their derivatives by the unknowns, one column for each.
struct Residuals {
    Eigen::VectorXd values;
    Eigen::MatrixXd by_unknown;
};

struct Limits {
    Eigen::VectorXd lower, upper;
};

/// The residuals at some values of the unknowns; nothing where they have no finite value.
using ResidualsAt = std::function<std::optional<Residuals>(const Eigen::VectorXd&)>;

struct Minimum {
    Eigen::VectorXd unknowns;
    Residuals residuals;
    std::size_t iterations = 0;
    bool converged = false;
    bool stopped = false;
};

/// A local minimum of the sum of squares within the limits, from a start within them; nothing if
/// there are no residuals at the start.
[[nodiscard]] std::optional<Minimum> minimize(const ResidualsAt& residuals_at,
                                              const Eigen::VectorXd& start, const Limits& limits,
                                              std::size_t most_iterations,
                                              const std::stop_token& stop);

/// What the residuals say about the unknowns, to first order.
struct Spread {
    Eigen::MatrixXd covariance;  ///< Without the directions that are not determined.
    Eigen::MatrixXd free;        ///< These directions, in the columns.
    /// By unknown: it can change without a residual that does.
    std::vector<bool> undetermined;
};
[[nodiscard]] Spread spread_of(const Residuals& residuals);

}  // namespace balcony::solve
