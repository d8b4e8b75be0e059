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

// A number that cameras are made of, at either end of a range that is narrower than the step of a
// difference, or one number. The half width of the picture is tan(fov/2) times the distance.
TEST(CameraRays, DifferencesStayWithinNarrowRanges) {
    const CameraMaker make = [](std::span<const double> closed) -> Result<camera::Camera> {
        const auto camera = lang::Workspace().make_open_camera(
            "pinhole", "", {{"fov", lang::literal(closed[0], true)}}, {{"yaw"}});
        return camera ? Result<camera::Camera>(camera->camera) : camera.diagnostics;
    };
    constexpr double fov = 1.0;
    constexpr double narrow = 1e-5;
    const V2d edge(0.0, 0.5 * height);
    for (const camera::Range& range :
         {camera::Range{fov - narrow, fov}, camera::Range{fov, fov + narrow},
          camera::Range{fov - narrow, fov, true}, camera::Range{fov, fov}}) {
        Problem problem;
        problem.unknowns = {{"", fov, range, {}, "fov"},
                            {lang::parameter_input("yaw"), 0.0, {}, {}, "yaw"}};
        const auto rays = CameraRays::make(make, V2d(width, height), problem, {});
        ASSERT_TRUE(rays) << to_text(rays.diagnostics);
        const std::vector<InputRay> found = rays->at(std::array{edge}, std::array{fov, 0.0}, true);
        ASSERT_TRUE(found[0].ray.valid);
        ASSERT_EQ(found[0].by_input.size(), 2U);
        // The edge of the picture is at the angle fov/2 to the left; yaw turns it as it is.
        const V3d by_yaw(-std::sin(fov / 2), std::cos(fov / 2), 0.0);
        const V3d by_fov = range.minimum < range.maximum ? 0.5 * by_yaw : V3d(0.0);
        // A difference to one side is off by half of its width times the second derivative, 1/4.
        EXPECT_LT((found[0].by_input[0].direction - by_fov).length(), narrow / 7) << range.minimum;
        EXPECT_LT((found[0].by_input[1].direction - by_yaw).length(), 1e-12);
    }
}

}  // namespace balcony::solve::system_test
