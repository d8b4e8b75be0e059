// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Targets whose pose is unknown, and the uncertainty of projections, which they bear on.

#include <cmath>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::solve::targets_test {

using namespace test;

TEST(SolveTargets, PosesNeedNoStart) {
    // Boards that look away by up to 60 degrees, and a body that is no plane.
    const lang::OpenCamera camera = aimed_camera({"yaw", "fov"});
    Problem problem = problem_of(camera);
    const std::vector<Pose> poses{{{0.3, 1.0, -0.1}, {4.0, 0.5, 0.2}},
                                  {{-0.5, 0.1, 2.4}, {3.0, -0.4, 0.1}},
                                  {{0.1, -0.6, 0.2}, {5.0, 0.0, -0.5}}};
    const double half = std::tan(35 * degree);
    for (std::size_t k = 0; k < poses.size(); ++k) {
        problem.targets.emplace_back();
        for (int i = 0; i < 20; ++i) {
            const V3d point(k == 2 ? 0.1 * (i % 3) : 0.7, 0.2 * (i % 5) + 3.0, 0.2 * (i / 5) - 1.0);
            const V3d center(0.7, 3.4, -0.7);
            const Pose pose{poses[k].rotation,
                            poses[k].translation - Pose{poses[k].rotation, V3d(0.0)} * center};
            const V3d seen = pose * point;
            const V2d at(width / 2 * (1.0 - seen.y / seen.x / half),
                         height / 2 - width / 2 * seen.z / seen.x / half);
            problem.constraints.push_back({ConstraintKind::at, {problem.marks.size()}, at});
            problem.marks.push_back({point, false, k});
        }
    }
    problem.unknowns[0].deviation = 1e-3;  // Otherwise everything may turn together.
    const Solution solution = solved(camera, problem);
    EXPECT_NEAR(solution.values[0], 0.0, 1e-8);
    EXPECT_NEAR(solution.values[1], 70 * degree, 1e-8);
    EXPECT_LT(solution.cost, 1e-12);
}

TEST(SolveTargets, SaysThatAPoseHasNoStart) {
    const lang::OpenCamera camera = aimed_camera({"fov"});
    Problem problem = problem_of(camera);
    problem.targets = {{{}, "board"}};
    for (int i = 0; i < 5; ++i) {  // On a line.
        problem.marks.push_back({{0.0, 0.1 * i, 0.0}, false, 0});
        problem.constraints.push_back(
            {ConstraintKind::at, {problem.marks.size() - 1}, V2d(300.0 + 10.0 * i, 100.0)});
    }
    EXPECT_EQ(first_message(solve(camera.camera, width, height, problem)),
              "where the target 'board' is cannot be seen from its marks");
}

TEST(SolveTargets, FindsPosesOfATarget) {
    const lang::OpenCamera camera = aimed_camera({"fov"});
    Problem problem = problem_of(camera);
    const std::vector<Pose> poses{{{0.3, 0.2, -0.1}, {4.0, 0.5, 0.2}},
                                  {{-0.5, 0.1, 0.4}, {3.0, -0.4, 0.1}},
                                  {{0.1, -0.6, 0.2}, {5.0, 0.0, -0.5}}};
    const double half = std::tan(35 * degree);
    for (std::size_t k = 0; k < poses.size(); ++k) {
        problem.targets.push_back({Pose{{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}}});
        for (int i = 0; i < 20; ++i) {
            const V3d point(0.0, 0.3 * (i % 5 - 2), 0.3 * (i / 5 - 2));
            const V3d seen = poses[k] * point;
            const V2d at(width / 2 * (1.0 - seen.y / seen.x / half),
                         height / 2 - width / 2 * seen.z / seen.x / half);
            problem.constraints.push_back({ConstraintKind::at, {problem.marks.size()}, at});
            problem.marks.push_back({point, false, k});
        }
    }
    const Solution solution = solved(camera, problem);
    EXPECT_NEAR(solution.values[0], 70 * degree, 1e-8);
    for (std::size_t k = 0; k < poses.size(); ++k) {
        EXPECT_LT((solution.poses[k].rotation - poses[k].rotation).length(), 1e-7);
        EXPECT_LT((solution.poses[k].translation - poses[k].translation).length(), 1e-6);
    }
}

TEST(SolveTargets, ErrorsOfProjectionsAreThoseOfTheUnknowns) {
    // A turn by the standard deviation moves the middle of the picture by that times the focal
    // length in pixels, and other places by 1 + x^2 times this across and x y up, for the distances
    // x and y from the middle in focal lengths.
    const lang::OpenCamera camera = aimed_camera({"yaw"});
    Problem problem = problem_of(camera);
    problem.marks = {{{1, 0, 0}, true}};
    problem.constraints = {{ConstraintKind::at, {0}, V2d(width / 2, height / 2)}};
    problem.constraints.front().deviation = 0.5;
    Options options;
    options.errors = ErrorGrid{3, 3, {}};
    const Solution solution = solved(camera, problem, options);
    const double focal = width / 2 / std::tan(30 * degree);
    ASSERT_EQ(solution.errors.size(), 9U);
    EXPECT_NEAR(*solution.errors[4], 0.5, 1e-9);
    EXPECT_NEAR(solution.deviations[0], 0.5 / focal, 1e-12);
    const double x = width / 3 / focal;
    const double y = height / 3 / focal;
    EXPECT_NEAR(*solution.errors[5], 0.5 * (1.0 + x * x), 1e-9);
    EXPECT_NEAR(*solution.errors[0], 0.5 * std::hypot(1.0 + x * x, x * y), 1e-9);
}

TEST(SolveTargets, ErrorsOfProjectionsLeaveOutWhatTurnsWithTheTargets) {
    // The camera and its board may turn together: the yaw is not determined, but where the picture
    // shows what is fixed to the board is. A field of view that nothing determines is another
    // matter.
    const lang::OpenCamera camera = aimed_camera({"yaw", "fov"});
    Problem problem = problem_of(camera);
    problem.targets.push_back({Pose{{0.3, 0.4, -0.1}, {4.0, 0.5, 0.2}}});
    const double half = std::tan(30 * degree);
    for (int i = 0; i < 20; ++i) {
        const V3d point(0.0, 0.3 * (i % 5 - 2), 0.3 * (i / 5 - 2));
        const V3d seen = *problem.targets.front().start * point;
        const V2d at(width / 2 * (1.0 - seen.y / seen.x / half),
                     height / 2 - width / 2 * seen.z / seen.x / half);
        problem.constraints.push_back({ConstraintKind::at, {problem.marks.size()}, at});
        problem.marks.push_back({point, false, 0});
    }
    Options options;
    options.errors = ErrorGrid{2, 2, 4.0};
    const auto solution = solve(camera.camera, width, height, problem, options);
    ASSERT_TRUE(solution);
    EXPECT_TRUE(std::isinf(solution->deviations[0]));
    for (const auto& error : solution->errors) {
        EXPECT_GT(*error, 0.0);
        EXPECT_LT(*error, 10.0);
    }
    // Of a single point of the board, nothing is determined.
    problem.marks.resize(1);
    problem.constraints.resize(1);
    const auto less = solve(camera.camera, width, height, problem, options);
    for (const auto& error : less->errors) {
        EXPECT_TRUE(std::isinf(*error));
    }
}

}  // namespace balcony::solve::targets_test
