// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The residuals of a problem: their derivatives by finite differences.

#include "solve/system.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "balcony/lang.hpp"

namespace balcony::solve::system_test {
namespace {

constexpr double width = 640.0;
constexpr double height = 360.0;

}  // namespace

TEST(System, HasTheDerivativesOfItsResiduals) {
    const auto camera =
        lang::Workspace().make_open_camera("pinhole", "", {}, {{"fov", "px", "yaw", "roll"}});
    Problem problem;
    std::vector<std::string> inputs;
    for (const lang::OpenParameter& parameter : camera->open) {
        inputs.push_back(lang::parameter_input(parameter.name));
        problem.unknowns.push_back({inputs.back(), parameter.value + 0.05, {}, 0.5});
    }
    problem.targets = {{Pose{{0.2, -0.3, 0.1}, {3.0, 0.1, 0.2}}}};
    problem.marks = {{{4.0, 0.5, 0.3}},
                     {{1.0, -0.2, 0.1}, true},
                     {{0.1, 0.2, -0.3}, false, 0},
                     {{5.0, -0.5, -0.6}}};
    problem.constraints = {{ConstraintKind::at, {0}, V2d(300.0, 100.0)},
                           {ConstraintKind::at, {2}, V2d(280.0, 200.0), 0.0, {}, 2.0, 1.5},
                           {ConstraintKind::straight, {0, 1, 3}},
                           {ConstraintKind::ratio, {0, 1, 2, 3}, {}, 1.5},
                           {ConstraintKind::magnification, {}, V2d(100.0, 50.0), 400.0, 3.0, 0.1},
                           {ConstraintKind::isotropic, {}, V2d(600.0, 300.0), 0.0, 2.0},
                           {ConstraintKind::unfolded, {}, V2d(600.0, 300.0), 1.0}};
    const CameraMaker make = [&](std::span<const double>) { return camera->camera; };
    const auto rays = CameraRays::make(make, V2d(width, height), problem, {});
    ASSERT_TRUE(rays);
    System system(*rays, problem, V2d(width, height), std::vector<V2d>(4, V2d(320.0, 180.0)));
    const Eigen::VectorXd at = system.start();
    const auto residuals = system.residuals(at);
    ASSERT_TRUE(residuals);
    constexpr double h = 1e-6;
    for (Eigen::Index k = 0; k < at.size(); ++k) {
        Eigen::VectorXd before = at;
        Eigen::VectorXd after = at;
        before[k] -= h;
        after[k] += h;
        const Eigen::VectorXd slope =
            (system.residuals(after)->values - system.residuals(before)->values) / (2.0 * h);
        for (Eigen::Index r = 0; r < slope.size(); ++r) {
            // Positions have rounding errors of 1e-12 pixels or so, which the difference divides
            // by 2 h.
            EXPECT_NEAR(residuals->by_unknown(r, k), slope[r], 1e-6 * std::abs(slope[r]) + 1e-5)
                << "residual " << r << " by unknown " << k;
        }
    }
}

}  // namespace balcony::solve::system_test
