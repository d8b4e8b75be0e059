// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Solving by its law, that the camera which made the demands is found again, and by demands whose
// answer can be calculated.

#include "balcony/solve.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::solve::solve_test {

using namespace test;

TEST(Solve, FindsTheCameraThatMadeTheDemands) {
    struct Case {
        const char* camera;
        std::vector<std::string> parameters;
        std::vector<double> values;  // Angles in radians.
    };
    const std::vector<Case> cases{
        {"pinhole", {"fov", "yaw", "pitch"}, {50 * degree, 20 * degree, -8 * degree}},
        {"panorama", {"yaw", "px", "pz"}, {15 * degree, 0.2, -0.1}},
        {"little_planet", {"px", "py"}, {0.1, -0.2}},
        {"superelliptic", {"px", "py", "seam"}, {0.5, -0.3, 32 * degree}},
    };
    for (const Case& one : cases) {
        SCOPED_TRACE(one.camera);
        const lang::OpenCamera camera = open(one.camera, "", one.parameters);
        Problem problem = problem_of(camera);
        std::vector<double> values;
        for (const lang::OpenParameter& parameter : camera.open) {
            const auto at = std::find(one.parameters.begin(), one.parameters.end(), parameter.name);
            values.push_back(one.values[static_cast<std::size_t>(at - one.parameters.begin())]);
        }
        demand_grid(problem, camera, values, 8);
        const Solution solution = solved(camera, problem);
        for (std::size_t i = 0; i < values.size(); ++i) {
            EXPECT_NEAR(solution.values[i], values[i], 1e-7 * (1.0 + std::abs(values[i])))
                << camera.open[i].name;
        }
        EXPECT_LT(solution.cost, 1e-12);
        EXPECT_TRUE(solution.converged);
    }
}

TEST(Solve, DeviationsAreThoseOfTheNoise) {
    // Solutions of demands with independent noise scatter as one of them says.
    const lang::OpenCamera camera = aimed_camera({"yaw", "fov"});
    const std::vector<double> values{5 * degree, 70 * degree};
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0.0, 0.5);
    Problem exact = problem_of(camera);
    demand_grid(exact, camera, values, 6, 1e-9);
    std::array<double, 2> squares{};
    Solution last;
    constexpr int runs = 400;
    for (int run = 0; run < runs; ++run) {
        Problem noisy = exact;
        for (Constraint& constraint : noisy.constraints) {
            constraint.position += V2d(normal(random), normal(random));
            constraint.deviation = 0.5;
        }
        last = solved(camera, noisy);
        for (std::size_t i = 0; i < 2; ++i) {
            squares[i] += std::pow(last.values[i] - values[i], 2);
        }
    }
    for (std::size_t i = 0; i < 2; ++i) {
        // A deviation that is estimated from n values is itself within 3 / sqrt(2 n) of it, 11 %.
        EXPECT_NEAR(std::sqrt(squares[i] / runs) / last.deviations[i], 1.0, 0.11) << i;
    }
}

TEST(Solve, RefusesBentRays) {
    const lang::OpenCamera camera =
        open(std::make_shared<const SourceText>(
                 "bent.cam",
                 "camera bent(turn = 0deg) { map u = 1 .. -1, v = square  eye point  "
                 "toward plane((1, 0, 0))  move rotate(z, turn)  "
                 "bend pinholes([(10, 0, 0), (10, 20, 0)]) }"),
             "", {"turn"});
    Problem problem = problem_of(camera);
    problem.marks = {{{1, 0.3, 0}, true}, {{1, -0.3, 0}, true}};
    problem.constraints = {{ConstraintKind::level, {0, 1}}};
    const auto made = solve(camera.camera, width, height, problem);
    EXPECT_FALSE(made);
    EXPECT_NE(to_text(made.diagnostics).find("the rays of camera 'bent' are bent"),
              std::string::npos);
}

TEST(Solve, AHorizonIsLevel) {
    const lang::OpenCamera camera = aimed_camera({"roll"});
    Problem problem = problem_of(camera);
    problem.unknowns[0].value = 12 * degree;
    problem.marks = {{{1, 0.3, 0}, true}, {{1, -0.3, 0}, true}};
    problem.constraints = {{ConstraintKind::level, {0, 1}}};
    const Solution solution = solved(camera, problem);
    EXPECT_NEAR(solution.values[0], 0.0, 1e-9);
    EXPECT_NEAR(solution.seen[0]->y, height / 2, 1e-6);
}

TEST(Solve, TwoThingsAreAsLargeAsDemanded) {
    const lang::OpenCamera camera = aimed_camera({"fov"});
    Problem problem = problem_of(camera);
    problem.marks = {{{5, 1, 0}}, {{5, -1, 0}}};
    problem.constraints = {{ConstraintKind::length, {0, 1}, V2d(0.0), 100.0}};
    const Solution solution = solved(camera, problem);
    // 100 pixels of 640 show 0.4 at distance 1, so half of all shows 1.28.
    EXPECT_NEAR(std::tan(solution.values[0] / 2), 1.28, 1e-9);
}

TEST(Solve, AStepThatGoesTooFarLosesNoMark) {
    // The first step leads to 15 degrees. There the marks are 2,600 pixels from the middle, where
    // wider cameras, which the next steps lead to, have no rays.
    const lang::OpenCamera camera = open("fisheye", "", {"fov"});
    Problem problem = problem_of(camera);
    problem.unknowns[0].value = 150 * degree;
    problem.unknowns[0].range.minimum = 15 * degree;
    const auto direction = [](double angle) { return V3d(std::cos(angle), std::sin(angle), 0.0); };
    problem.marks = {{direction(40 * degree), true}, {direction(60 * degree), true}};
    problem.constraints = {{ConstraintKind::length, {0, 1}, V2d(0.0), width / 2}};
    const Solution solution = solved(camera, problem);
    ASSERT_EQ(solution.misses.size(), 1U);
    EXPECT_LT(solution.misses.front().deviations, 1e-6);
}

TEST(Solve, MagnificationIsAsDemanded) {
    const lang::OpenCamera camera = aimed_camera({"fov"});
    Problem problem = problem_of(camera);
    problem.constraints = {{ConstraintKind::magnification, {}, V2d(width / 2, height / 2), 500.0}};
    EXPECT_NEAR(std::tan(solved(camera, problem).values[0] / 2), 320.0 / 500.0, 1e-9);
    problem.constraints.front().distance = 2.0;
    EXPECT_NEAR(std::tan(solved(camera, problem).values[0] / 2), 320.0 / 1000.0, 1e-9);
}

TEST(Solve, CirclesStayCircles) {
    const auto text = std::make_shared<const SourceText>("stretched.cam", R"(
        camera stretched(k = 2, s = 0.3) {
            aspect 16/9
            map    u = k .. -k, v = -0.5625 .. 0.5625
            eye    point(0, 0, 0)
            toward plane((1, 0, 0), along_u = (0, 1, s))
        })");
    const lang::OpenCamera camera = open(text, "", {"k", "s"});
    Problem problem = problem_of(camera);
    problem.constraints = {{ConstraintKind::isotropic, {}, V2d(width / 2, height / 2)}};
    const Solution solution = solved(camera, problem);
    EXPECT_NEAR(solution.values[0], 1.0, 1e-7);
    EXPECT_NEAR(solution.values[1], 0.0, 1e-7);
}

TEST(Solve, AMirroredPictureTurnsRound) {
    const auto text = std::make_shared<const SourceText>("mirrored.cam", R"(
        camera mirrored(k = -0.2 from -1 to 1) {
            map    u = k .. -k, v = square
            eye    point(0, 0, 0)
            toward plane((1, 0, 0))
        })");
    const lang::OpenCamera camera = open(text, "", {"k"});
    Problem problem = problem_of(camera);
    Constraint unfolded{ConstraintKind::unfolded, {}, V2d(width / 2, height / 2), 0.5};
    problem.constraints = {unfolded};
    Options options;
    options.starts = 4;
    EXPECT_GT(solve(camera.camera, width, height, problem, options)->values[0], 0.0);
}

TEST(Solve, StaysNearIfItIsTold) {
    const lang::OpenCamera camera = aimed_camera({"yaw", "pitch"});
    Problem problem = problem_of(camera);
    for (Unknown& unknown : problem.unknowns) {
        unknown.deviation = 1.0;
    }
    problem.marks = {{{1, 0.2, 0}, true}};
    problem.constraints = {{ConstraintKind::at, {0}, V2d(width / 2, height / 2)}};
    problem.constraints.front().deviation = 1e-6;
    const Solution solution = solved(camera, problem);
    EXPECT_NEAR(solution.values[0], std::atan(0.2), 1e-6);
    EXPECT_NEAR(solution.values[1], 0.0, 1e-6);
}

TEST(Solve, KeepsToLimits) {
    const lang::OpenCamera camera = aimed_camera({"fov"});
    Problem problem = problem_of(camera);
    problem.marks = {{{5, 1, 0}}, {{5, -1, 0}}};
    problem.constraints = {{ConstraintKind::length, {0, 1}, V2d(0.0), 1.0}};
    EXPECT_EQ(solved(camera, problem).values[0], 150 * degree);
}

TEST(Solve, AnOutlierCountsLittle) {
    const lang::OpenCamera camera = aimed_camera({"yaw", "fov"});
    const std::vector<double> values{5 * degree, 70 * degree};
    Problem problem = problem_of(camera);
    demand_grid(problem, camera, values, 6);
    problem.constraints[3].position += V2d(80.0, 40.0);
    const double plain = std::abs(solved(camera, problem).values[0] - values[0]);
    for (Constraint& constraint : problem.constraints) {
        constraint.tolerance = 1.0;
    }
    // An outlier of s = 89 deviations pulls like one of s / (1 + s^2), 8,000 times less.
    EXPECT_LT(std::abs(solved(camera, problem).values[0] - values[0]), 1e-3 * plain);
}

TEST(Solve, NumbersThatACameraIsMadeOfAreFoundLikeInputs) {
    const std::vector<double> values{5 * degree, 70 * degree};
    const lang::OpenCamera open_both = aimed_camera({"yaw", "fov"});
    Problem problem = problem_of(open_both);
    demand_grid(problem, open_both, values, 6, 0.3);
    problem.constraints.push_back(
        {ConstraintKind::magnification, {}, V2d(100.0, 200.0), 400.0, {}, 0.1});
    Options options;
    options.errors = ErrorGrid{2, 2, {}};
    const Solution with_inputs = solved(open_both, problem, options);

    problem.unknowns[1].input.clear();
    problem.unknowns[1].name = "fov";
    std::size_t made = 0;
    const CameraMaker make = [&](std::span<const double> closed) -> Result<camera::Camera> {
        ++made;
        const auto source = std::make_shared<const SourceText>("aimed.cam", aimed);
        return lang::Workspace()
            .make_open_camera(source, "", {{"fov", lang::literal(closed[0], true)}}, {{"yaw"}})
            ->camera;
    };
    const auto made_anew = solve(make, width, height, problem, options);
    ASSERT_TRUE(made_anew) << first_message(made_anew);
    EXPECT_GT(made, 3U);
    // Differences of central steps of 1e-4 are good to the square of these, and so is what follows
    // from them; the minimum is where the residuals have it, which are the same.
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(made_anew->values[i], with_inputs.values[i], 1e-6);
        EXPECT_NEAR(made_anew->deviations[i] / with_inputs.deviations[i], 1.0, 1e-6);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(*made_anew->errors[i] / *with_inputs.errors[i], 1.0, 1e-6);
    }
}

TEST(Solve, WhatNoCameraCanBeMadeOfIsAnError) {
    const lang::OpenCamera camera = aimed_camera({"yaw"});
    Problem problem = problem_of(camera);
    problem.marks = {{{1, 0, 0}, true}};
    problem.constraints = {{ConstraintKind::at, {0}, V2d(width / 2, height / 2)}};
    const CameraMaker none = [](std::span<const double>) -> Result<camera::Camera> {
        return error("there is no such camera");
    };
    EXPECT_EQ(first_message(solve(none, width, height, problem)), "there is no such camera");
}

TEST(Solve, SaysWhatTheFoundCameraDoesNotShow) {
    const lang::OpenCamera camera = aimed_camera({"yaw"});
    Problem problem = problem_of(camera);
    problem.marks = {{{1, 0, 0}, true}, {{-1, 0, 0}, true}};
    problem.marks[1].name = "behind";
    problem.constraints = {{ConstraintKind::at, {0}, V2d(width / 2, height / 2)},
                           {ConstraintKind::at, {1}, V2d(width / 2, height / 2)}};
    problem.constraints[1].tolerance = 1e-3;
    const auto solution = solve(camera.camera, width, height, problem);
    ASSERT_TRUE(solution) << first_message(solution);
    EXPECT_EQ(first_message(solution), "the camera that was found does not show the mark 'behind'");
    // Five are named.
    for (int i = 0; i < 6; ++i) {
        problem.marks.push_back(problem.marks[1]);
        problem.constraints.push_back(problem.constraints[1]);
        problem.constraints.back().marks = {problem.marks.size() - 1};
    }
    const auto many = solve(camera.camera, width, height, problem);
    ASSERT_TRUE(many) << first_message(many);
    ASSERT_EQ(many.diagnostics.size(), 6U);
    EXPECT_EQ(many.diagnostics.back().message, "nor does it show 2 other marks");
}

TEST(Solve, SaysWhatIsNotDetermined) {
    const lang::OpenCamera camera = aimed_camera({"yaw", "px"});
    Problem problem = problem_of(camera);
    problem.marks = {{{1, 0.2, 0}, true}};  // A direction does not change with the place.
    problem.constraints = {{ConstraintKind::at, {0}, V2d(width / 2, height / 2)}};
    const auto solution = solve(camera.camera, width, height, problem);
    EXPECT_NEAR(solution->values[0], std::atan(0.2), 1e-9);
    EXPECT_EQ(solution->values[1], 0.0);
    EXPECT_TRUE(std::isinf(solution->deviations[1]));
    EXPECT_EQ(first_message(solution),
              "the constraints do not determine '" + lang::parameter_input("px") + "'");
}

// Rounding leaves some 1e-16 of the derivatives that cancel: a wall that is level and upright says
// nothing of the field of view.
TEST(Solve, WhatCancelsDeterminesNothing) {
    const lang::OpenCamera camera = aimed_camera({"yaw", "roll", "fov"});
    Problem problem = problem_of(camera);
    problem.marks = {{{20, 4, -1.6}}, {{20, -4, -1.6}}, {{20, 4, 4.4}}, {{20, 0, -1.6}}};
    problem.constraints = {{ConstraintKind::straight, {0, 1, 3}},
                           {ConstraintKind::level, {0, 1}},
                           {ConstraintKind::upright, {0, 2}}};
    const auto solution = solve(camera.camera, width, height, problem);
    ASSERT_TRUE(solution);
    EXPECT_TRUE(std::isinf(solution->deviations[2]));
    EXPECT_LT(solution->deviations[0], 1.0);
    EXPECT_EQ(first_message(solution),
              "the constraints do not determine '" + lang::parameter_input("fov") + "'");
    // What differs by little is known with little certainty.
    problem.constraints.push_back({ConstraintKind::length, {0, 1}, {}, 300.0, {}, 1e6});
    EXPECT_LT(solve(camera.camera, width, height, problem)->deviations[2], 1e5);
}

TEST(Solve, SaysWhatIsDeterminedOnlyTogether) {
    // One position beside the middle of the picture does not tell a turn from a roll.
    const lang::OpenCamera camera = aimed_camera({"yaw", "pitch", "roll"});
    Problem problem = problem_of(camera);
    problem.marks = {{{1, 0.2, 0}, true}};
    problem.constraints = {{ConstraintKind::at, {0}, V2d(100.0, 80.0)}};
    const auto solution = solve(camera.camera, width, height, problem);
    EXPECT_LT(solution->cost, 1e-12);
    ASSERT_EQ(solution.diagnostics.size(), 2U);
    EXPECT_EQ(first_message(solution),
              "the constraints are 2 equations, too few for 3 unknown numbers");
    EXPECT_TRUE(solution.diagnostics[1].message.starts_with("the constraints do not determine '"));
    EXPECT_TRUE(std::isinf(solution->deviations[2]));
}

TEST(Solve, WrongProblemsAreErrors) {
    const lang::OpenCamera camera = aimed_camera({"yaw"});
    const Problem empty = problem_of(camera);
    EXPECT_EQ(first_message(solve(camera.camera, width, height, empty)), "there is no constraint");
    Problem problem = empty;
    problem.constraints = {{ConstraintKind::level, {0}}};
    EXPECT_EQ(first_message(solve(camera.camera, width, height, problem)),
              "constraint 1 ('level') takes 2 marks, not 1");
    problem.marks = {{{1, 0, 0}, true}};
    problem.constraints = {{ConstraintKind::at, {0}, V2d(0.0), 0.0, {}, 1e-300}};
    EXPECT_EQ(first_message(solve(camera.camera, width, height, problem)),
              "constraint 1 ('at') has a deviation that is not between 1e-12 and 1e+12");
    problem.constraints = {{ConstraintKind::at, {0}, V2d(0.0), 0.0, {}, 1.0, 1e-300}};
    EXPECT_EQ(first_message(solve(camera.camera, width, height, problem)),
              "constraint 1 ('at') has a tolerance that is not between 1e-12 and 1e+12");
    problem.marks = {{{-1, 0, 0}, true}, {{-1, 0, 1}, true}};
    problem.constraints = {{ConstraintKind::level, {0, 1}}};
    EXPECT_EQ(first_message(solve(camera.camera, width, height, problem)),
              "no ray of the first values meets mark 1");
    std::stop_source source;
    source.request_stop();
    EXPECT_EQ(kind_of_errors(
                  solve(camera.camera, width, height, problem, {}, source.get_token()).diagnostics),
              Kind::interrupted);
}

}  // namespace balcony::solve::solve_test
