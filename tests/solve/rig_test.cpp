// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Rigs: cameras with their pictures side by side, which see the same targets from several places.

#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "support.hpp"

namespace balcony::solve::rig_test {

using namespace test;

namespace {

// A picture of 320 x 360 pixels, so many pixels from the left side of one of 640 x 360, and two of
// these.
const std::string stereo = R"(
    camera one(f = 300 above 0, left = 0, py = 0, yaw = 0deg) {
        aspect 16/9
        map    u = (160 + left)/f .. (left - 480)/f, v = -180/f .. 180/f
        eye    point
        toward plane((1, 0, 0))
        move   rotate(z, yaw), translate(0, py, 0)
    }
    camera rig(f = 300 above 0, py = -0.2, yaw = 0deg) {
        morph one(f = f) .. one(f = f, left = 320, py = py, yaw = yaw),
              amount = if(x < 0.5, 0, 1), by = rays
    })";

const std::array<double, 3> truth{310.0, -0.23, 4.0 * degree};  // f, py, yaw

lang::OpenCamera rig() {
    return open(std::make_shared<const SourceText>("rig.cam", stereo), "rig", {"f", "py", "yaw"});
}

V2d position(const V3d& point, bool is_right) {
    const double c = std::cos(is_right ? truth[2] : 0.0);
    const double s = std::sin(is_right ? truth[2] : 0.0);
    const double y = point.y - (is_right ? truth[1] : 0.0);
    const V2d across(c * point.x + s * y, c * y - s * point.x);
    return {(is_right ? 480.0 : 160.0) - truth[0] * across.y / across.x,
            180.0 - truth[0] * point.z / across.x};
}

// Four boards that both pictures show, without a start.
Problem boards_of(const lang::OpenCamera& camera, double deviation) {
    Problem problem = problem_of(camera);
    const std::array<Pose, 4> poses{
        Pose{{0.2, 0.5, 0.1}, {1.5, 0.05, 0.1}}, Pose{{-0.3, -0.4, 0.8}, {1.2, -0.1, -0.1}},
        Pose{{0.1, 0.3, -0.5}, {2.0, -0.2, 0.3}}, Pose{{0.4, -0.5, 0.0}, {1.4, -0.15, 0.0}}};
    for (const Pose& pose : poses) {
        problem.targets.emplace_back();
        for (const bool is_right : {false, true}) {
            for (int i = 0; i < 20; ++i) {
                Mark mark{V3d(0.0, 0.1 * (i % 5) - 0.2, 0.1 * (i / 5) - 0.15)};
                mark.target = problem.targets.size() - 1;
                Constraint constraint{ConstraintKind::at, {problem.marks.size()}};
                constraint.position = position(pose * mark.place, is_right);
                constraint.deviation = deviation;
                EXPECT_GT(constraint.position.x, is_right ? 320.0 : 0.0);
                EXPECT_LT(constraint.position.x, is_right ? 640.0 : 320.0);
                problem.marks.push_back(mark);
                problem.constraints.push_back(constraint);
            }
        }
    }
    return problem;
}

}  // namespace

TEST(Rig, IsFoundFromWhatItsPicturesShow) {
    const lang::OpenCamera camera = rig();
    const Solution solution = solved(camera, boards_of(camera, 1.0));
    for (std::size_t i = 0; i < truth.size(); ++i) {
        EXPECT_NEAR(solution.values[i], truth[i], 1e-8 * std::abs(truth[i]));
    }
    EXPECT_NEAR(solution.poses[2].translation.x, 2.0, 1e-8);
}

// With noise, errors in units of the covariance are chi-squared with 3 degrees of freedom: the mean
// of n of them is 3, and within 4 sqrt(6 / n) of it in all but 1 of 10,000 cases.
TEST(Rig, HasTheCovarianceOfItsErrors) {
    const lang::OpenCamera camera = rig();
    constexpr double noise = 0.4;
    constexpr int runs = 60;
    const Problem exact = boards_of(camera, noise);
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0.0, noise);
    double squares = 0.0;
    for (int run = 0; run < runs; ++run) {
        Problem noisy = exact;
        for (Constraint& constraint : noisy.constraints) {
            constraint.position += V2d(normal(random), normal(random));
        }
        const Solution solution = solved(camera, noisy);
        Eigen::Vector3d error;
        for (int i = 0; i < 3; ++i) {
            const auto k = static_cast<std::size_t>(i);
            error[i] = solution.values[k] - truth[k];
        }
        const Eigen::Map<const Eigen::Matrix3d> covariance(solution.covariance.data());
        squares += error.dot(covariance.ldlt().solve(error));
        EXPECT_LT(solution.deviations[1], 0.01 * std::abs(truth[1])) << "of the baseline";
    }
    EXPECT_NEAR(squares / runs, 3.0, 4.0 * std::sqrt(6.0 / runs));
}

// The mean of two views from different places is no view: a target that both show has the pose in
// which one of them shows it. From there, a search that begins 16 degrees away arrives.
TEST(Rig, AFirstPoseIsThatOfOnePicture) {
    const lang::OpenCamera camera = rig();
    Problem problem = boards_of(camera, 1.0);
    problem.unknowns[2].value = 20.0 * degree;
    for (const double py : {-0.2, 0.3, 0.8}) {
        problem.unknowns[1].value = py;
        EXPECT_NEAR(solved(camera, problem).values[1], truth[1], 1e-8) << py;
    }
}

}  // namespace balcony::solve::rig_test
