// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "solve/pose.hpp"

#include <Eigen/Geometry>

namespace balcony::solve {

namespace {

Eigen::Matrix3d matrix_of(const Eigen::Vector3d& rotation) {
    const double angle = rotation.norm();
    return angle > 0.0 ? Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix()
                       : Eigen::Matrix3d::Identity();
}

}  // namespace

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
    Eigen::Matrix3d made;
    made << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return made;
}

V3d Pose::operator*(const V3d& point) const {
    const Eigen::Vector3d turned = matrix_of(eigen(rotation)) * eigen(point);
    return V3d(turned.x(), turned.y(), turned.z()) + translation;
}

std::array<V3d, 6> pose_derivatives(const Pose& pose, const V3d& point) {
    const Eigen::Vector3d v = eigen(pose.rotation);
    const Eigen::Matrix3d turn = matrix_of(v);
    // Gallego and Yezzi, "A compact formula for the derivative of a 3-D rotation in exponential
    // coordinates", 2015: -R [p] (v v^T + (R^T - I) [v]) / v^2, and -[p] at v = 0.
    Eigen::Matrix3d by_rotation = -turn * cross_matrix(eigen(point));
    if (const double square = v.squaredNorm(); square > 1e-16) {
        by_rotation *= (v * v.transpose() +
                        (turn.transpose() - Eigen::Matrix3d::Identity()) * cross_matrix(v)) /
                       square;
    }
    std::array<V3d, 6> made;
    for (int k = 0; k < 3; ++k) {
        made[static_cast<std::size_t>(k)] = {by_rotation(0, k), by_rotation(1, k),
                                             by_rotation(2, k)};
        made[static_cast<std::size_t>(k) + 3] = V3d(k == 0, k == 1, k == 2);
    }
    return made;
}

}  // namespace balcony::solve
