// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "solve/first_pose.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "solve/pose.hpp"

namespace balcony::solve {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// The points of a target in the directions in which they spread most, in units of that spread.
struct Spread3 {
    Matrix3d axes;  // In the columns.
    Vector3d center = Vector3d::Zero();
    double scale = 0.0;
    bool is_plane = false;
    bool is_line = false;

    explicit Spread3(std::span<const V3d> points) {
        for (const V3d& point : points) {
            center += eigen(point) / static_cast<double>(points.size());
        }
        Matrix3d moments = Matrix3d::Zero();
        for (const V3d& point : points) {
            const Vector3d from = eigen(point) - center;
            moments += from * from.transpose() / static_cast<double>(points.size());
        }
        const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(moments);
        axes << solver.eigenvectors().col(2), solver.eigenvectors().col(1),
            solver.eigenvectors().col(2).cross(solver.eigenvectors().col(1));
        const Vector3d squares = solver.eigenvalues();
        constexpr double flat = 1e-6;  // Of squares: a thousandth of the length.
        scale = std::sqrt(std::max(squares[2], 0.0));
        is_line = !(squares[1] > flat * squares[2]);
        is_plane = !(squares[0] > flat * squares[2]);
    }
    [[nodiscard]] Vector3d operator()(const V3d& point) const {
        return axes.transpose() * (eigen(point) - center) / scale;
    }
};

// The matrix M with as many columns as the points have numbers for which all M p are along their
// directions d: d x M p = 0. Its sign is that with which most of them are in front.
MatrixXd transform_along(std::span<const rays::Ray> rays, const MatrixXd& points) {
    const Index columns = points.rows();
    MatrixXd normal = MatrixXd::Zero(3 * columns, 3 * columns);
    for (Index i = 0; i < points.cols(); ++i) {
        const Matrix3d cross = cross_matrix(eigen(rays[static_cast<std::size_t>(i)].direction));
        MatrixXd rows(3, 3 * columns);
        for (Index c = 0; c < columns; ++c) {
            rows.middleCols(3 * c, 3) = points(c, i) * cross;
        }
        normal += rows.transpose() * rows;
    }
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(normal);
    const VectorXd least = solver.eigenvectors().col(0);
    MatrixXd made = Eigen::Map<const MatrixXd>(least.data(), 3, columns);
    double in_front = 0.0;
    for (Index i = 0; i < points.cols(); ++i) {
        const Vector3d p = made * points.col(i);
        in_front += p.dot(eigen(rays[static_cast<std::size_t>(i)].direction)) > 0.0 ? 1.0 : -1.0;
    }
    return in_front < 0.0 ? MatrixXd(-made) : made;
}

}  // namespace

std::optional<Pose> first_pose(std::span<const rays::Ray> rays, std::span<const V3d> points) {
    constexpr std::size_t fewest_of_plane = 4;
    constexpr std::size_t fewest = 6;
    if (points.size() < fewest_of_plane ||
        std::any_of(rays.begin(), rays.end(), [](const rays::Ray& ray) { return !ray.valid; })) {
        return std::nullopt;
    }
    const Spread3 spread(points);
    const bool is_plane = spread.is_plane || points.size() < fewest;
    if (spread.is_line || (is_plane && !spread.is_plane)) {
        return std::nullopt;
    }
    const Index numbers = is_plane ? 3 : 4;
    MatrixXd normal_points(numbers, static_cast<Index>(points.size()));
    Vector3d eye = Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        normal_points.col(static_cast<Index>(i)) << spread(points[i]).head(numbers - 1), 1.0;
        eye += eigen(rays[i].origin) / static_cast<double>(points.size());
    }
    const MatrixXd transform = transform_along(rays, normal_points);
    Matrix3d turn;
    turn << transform.col(0), transform.col(1),
        (is_plane ? Vector3d(Vector3d(transform.col(0)).cross(Vector3d(transform.col(1))))
                  : Vector3d(transform.col(2)));
    const double size = 0.5 * (transform.col(0).norm() + transform.col(1).norm());
    if (!(size > 0.0)) {
        return std::nullopt;
    }
    if (is_plane) {
        turn.col(2) /= size;  // As long as the others.
    }
    // The nearest rotation.
    const Eigen::JacobiSVD<Matrix3d> svd(turn, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Matrix3d nearest = svd.matrixU() * svd.matrixV().transpose();
    if (nearest.determinant() < 0.0) {
        Matrix3d flipped = svd.matrixU();
        flipped.col(2) *= -1.0;
        nearest = flipped * svd.matrixV().transpose();
    }
    const Matrix3d rotation = nearest * spread.axes.transpose();
    const Eigen::AngleAxisd axis(rotation);
    const Vector3d turned = axis.angle() * axis.axis();
    const Vector3d moved =
        eye + transform.col(numbers - 1) * (spread.scale / size) - rotation * spread.center;
    return Pose{{turned.x(), turned.y(), turned.z()}, {moved.x(), moved.y(), moved.z()}};
}

}  // namespace balcony::solve
