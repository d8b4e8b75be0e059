// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "solve/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace balcony::solve {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The normal equations of the linearized problem.
struct Normal {
    MatrixXd matrix;
    VectorXd slope;  // Half the derivative of the sum of squares.

    explicit Normal(const Residuals& residuals)
        : matrix(residuals.by_unknown.transpose() * residuals.by_unknown),
          slope(residuals.by_unknown.transpose() * residuals.values) {}
};

// The damped step; 0 for unknowns at a limit that the sum of squares pushes against.
VectorXd step_of(const Normal& normal, double damping, const VectorXd& at, const Limits& limits) {
    MatrixXd matrix = normal.matrix;
    VectorXd slope = normal.slope;
    const double largest = matrix.diagonal().maxCoeff();
    for (Index i = 0; i < at.size(); ++i) {
        const bool held = (at[i] <= limits.lower[i] && slope[i] > 0.0) ||
                          (at[i] >= limits.upper[i] && slope[i] < 0.0);
        const double scale = std::max(matrix(i, i), 1e-16 * largest);
        if (held || !(scale > 0.0)) {
            matrix.row(i).setZero();
            matrix.col(i).setZero();
            matrix(i, i) = 1.0;
            slope[i] = 0.0;
        } else {
            matrix(i, i) += damping * scale;
        }
    }
    return -matrix.ldlt().solve(slope);
}

}  // namespace

std::optional<Minimum> minimize(const ResidualsAt& residuals_at, const VectorXd& start,
                                const Limits& limits, std::size_t most_iterations,
                                const std::stop_token& stop) {
    constexpr double first_damping = 1e-4;
    constexpr double most_damping = 1e16;
    constexpr double least_gain = 1e-14;  // Relative, of the sum of squares.
    constexpr double least_step = 1e-14;  // Relative, of an unknown.
    std::optional<Residuals> first = residuals_at(start);
    if (!first) {
        return std::nullopt;
    }
    Minimum best{start, std::move(*first)};
    double damping = first_damping;
    while (best.iterations < most_iterations && !best.converged) {
        if (stop.stop_requested()) {
            best.stopped = true;
            break;
        }
        ++best.iterations;
        const double squares = best.residuals.values.squaredNorm();
        const Normal normal(best.residuals);
        for (;;) {
            const VectorXd step = step_of(normal, damping, best.unknowns, limits);
            const VectorXd trial =
                (best.unknowns + step).cwiseMax(limits.lower).cwiseMin(limits.upper);
            const bool moves = ((trial - best.unknowns).array().abs() >
                                least_step * (1.0 + best.unknowns.array().abs()))
                                   .any();
            std::optional<Residuals> there = moves ? residuals_at(trial) : std::nullopt;
            if (there && there->values.squaredNorm() < squares) {
                best.converged = squares - there->values.squaredNorm() <= least_gain * squares;
                best.unknowns = trial;
                best.residuals = std::move(*there);
                damping = std::max(damping * 0.2, 1e-12);
                break;
            }
            damping *= 5.0;
            if (!moves || damping > most_damping) {
                best.converged = true;
                break;
            }
        }
    }
    return best;
}

Spread spread_of(const Residuals& residuals) {
    const Index count = residuals.by_unknown.cols();
    // In units in which each unknown alone has the same effect, so that they can be compared.
    VectorXd scale = residuals.by_unknown.colwise().norm();
    Spread made{MatrixXd::Zero(count, count), MatrixXd(count, 0),
                std::vector<bool>(static_cast<std::size_t>(count))};
    for (Index i = 0; i < count; ++i) {
        made.undetermined[static_cast<std::size_t>(i)] = !(scale[i] > 0.0);
        scale[i] = scale[i] > 0.0 ? scale[i] : 1.0;
    }
    const MatrixXd scaled = residuals.by_unknown * scale.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scaled.transpose() * scaled);
    // Singular values below 1e-7 of the largest are rounding: the matrix has their squares.
    const double least = 1e-14 * solver.eigenvalues().maxCoeff() * static_cast<double>(count);
    for (Index k = 0; k < count; ++k) {
        const VectorXd direction = solver.eigenvectors().col(k);
        if (solver.eigenvalues()[k] > least) {
            made.covariance += direction * direction.transpose() / solver.eigenvalues()[k];
            continue;
        }
        made.free.conservativeResize(count, made.free.cols() + 1);
        made.free.rightCols(1) = scale.cwiseInverse().cwiseProduct(direction);
        for (Index i = 0; i < count; ++i) {
            if (std::abs(direction[i]) > 1e-3) {
                made.undetermined[static_cast<std::size_t>(i)] = true;
            }
        }
    }
    made.covariance =
        scale.cwiseInverse().asDiagonal() * made.covariance * scale.cwiseInverse().asDiagonal();
    return made;
}

}  // namespace balcony::solve
