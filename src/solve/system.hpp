// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The constraints of a problem as residuals of its unknowns.

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "solve/camera_rays.hpp"
#include "solve/least_squares.hpp"

namespace balcony::solve {

/// Where a mark appears, with the derivatives by the unknowns in the columns.
struct SeenMark {
    bool reached = false;  ///< A ray meets it there; otherwise a ray passes it, to first order.
    V2d at{0.0};
    Eigen::Matrix<double, 2, Eigen::Dynamic> by_unknown;
};

/// The unknowns of a problem in one vector: inputs, then three numbers of the rotation and three of
/// the translation of each target. Belongs to one thread.
class System {
public:
    /// All of these must outlive it. The targets have starts. `near` says for each mark where the
    /// search for it begins.
    System(const CameraRays& rays, const Problem& problem, const V2d& size, std::vector<V2d> near);

    [[nodiscard]] Eigen::VectorXd start() const;
    [[nodiscard]] Limits limits() const;
    [[nodiscard]] std::vector<double> inputs_of(const Eigen::VectorXd& unknowns) const;
    [[nodiscard]] std::vector<Pose> poses_of(const Eigen::VectorXd& unknowns) const;

    /// Nothing if a mark that has no position of its own is not seen, a shape has no value, or the
    /// sum of squares is not finite.
    [[nodiscard]] std::optional<Residuals> residuals(const Eigen::VectorXd& unknowns);
    /// Where the marks appear.
    [[nodiscard]] std::vector<std::optional<SeenMark>> seen(const Eigen::VectorXd& unknowns) const;
    /// What each constraint misses.
    [[nodiscard]] std::optional<std::vector<Miss>> misses(const Eigen::VectorXd& unknowns) const;

private:
    struct Row;
    [[nodiscard]] std::optional<std::vector<Row>> rows(
        const Eigen::VectorXd& unknowns, const std::vector<std::optional<SeenMark>>& marks) const;
    [[nodiscard]] std::optional<Row> row_of_marks(
        const Constraint& constraint, const std::vector<std::optional<SeenMark>>& marks) const;
    [[nodiscard]] V3d place_of(const Mark& mark, std::span<const Pose> poses) const;
    void follow(const std::vector<double>& inputs, std::span<const Pose> poses,
                std::vector<V2d>& at, std::vector<bool>& reached) const;

    const CameraRays& rays_;
    const Problem& problem_;
    V2d size_;
    std::size_t count_;  ///< Of unknowns.
    /// Where the marks were seen with the least sum of squares of residuals yet, from which the
    /// search for them goes on: one that is refused may have them where the next has no ray.
    std::vector<V2d> near_;
    double least_squares_ = std::numeric_limits<double>::infinity();
};

}  // namespace balcony::solve
