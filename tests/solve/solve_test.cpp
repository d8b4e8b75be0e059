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

#include "balcony/lang.hpp"
#include "balcony/rays.hpp"

namespace balcony::solve::solve_test {
namespace {

using std::numbers::pi;

constexpr double width = 640.0;
constexpr double height = 360.0;
constexpr double degree = pi / 180.0;

const std::string aimed = R"(
    camera aimed(yaw = 0deg, pitch = 0deg, roll = 0deg, fov = 60deg from 10deg to 150deg, px = 0) {
        let half = tan(fov/2)
        map    u = half .. -half, v = square
        eye    point(0, 0, 0)
        toward plane((1, 0, 0))
        move   rotate(x, roll), rotate(y, -pitch), rotate(z, yaw), translate(px, 0, 0)
    })";

lang::OpenCamera open(const lang::CameraSource& source, const std::string& name,
                      const std::vector<std::string>& parameters,
                      const std::vector<lang::Override>& overrides = {}) {
    auto made = lang::Workspace().make_open_camera(source, name, overrides, parameters);
    for (const Diagnostic& one : made.diagnostics) {
        ADD_FAILURE() << one.message;
    }
    return *made;
}

lang::OpenCamera aimed_camera(const std::vector<std::string>& parameters) {
    return open(std::make_shared<const SourceText>("aimed.cam", aimed), "", parameters);
}

Problem problem_of(const lang::OpenCamera& camera) {
    Problem problem;
    for (const lang::OpenParameter& parameter : camera.open) {
        problem.unknowns.push_back(
            {lang::parameter_input(parameter.name), parameter.value, parameter.limits});
    }
    return problem;
}

// The rays at some points of the picture with these values of the open parameters.
std::vector<rays::Ray> rays_of(const lang::OpenCamera& camera, const std::vector<double>& values,
                               const std::vector<V2d>& points) {
    rays::CompileOptions options;
    options.tiles = false;
    options.points = true;
    std::vector<std::span<const double>> inputs;
    for (std::size_t i = 0; i < values.size(); ++i) {
        options.inputs.push_back({lang::parameter_input(camera.open[i].name)});
        inputs.emplace_back(&values[i], 1);
    }
    const auto program = rays::compile(camera.camera, width, height, options);
    std::vector<double> x;
    std::vector<double> y;
    for (const V2d& point : points) {
        x.push_back(point.x);
        y.push_back(point.y);
    }
    rays::Scratch scratch;
    rays::RayBatch batch;
    program->run(rays::Points{x, y, 0.0, inputs}, scratch, batch);
    std::vector<rays::Ray> made;
    for (std::size_t i = 0; i < points.size(); ++i) {
        made.push_back(batch[i]);
    }
    return made;
}

// Points at several distances along the rays of a grid, demanded where the rays are, with noise.
void demand_grid(Problem& problem, const lang::OpenCamera& camera,
                 const std::vector<double>& values, int columns, double noise = 0.0) {
    std::vector<V2d> points;
    for (int i = 0; i < columns * columns; ++i) {
        points.emplace_back((i % columns + 0.5) / columns * width,
                            (i / columns + 0.5) / columns * height);
    }
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0.0, 1.0);
    const std::vector<rays::Ray> rays = rays_of(camera, values, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!rays[i].valid) {
            continue;
        }
        const double distance = 1.0 + static_cast<double>(i % 5);
        Constraint constraint{ConstraintKind::at, {problem.marks.size()}, points[i]};
        constraint.position += noise * V2d(normal(random), normal(random));
        constraint.deviation = noise > 0.0 ? noise : 1.0;
        problem.marks.push_back({rays[i].origin + distance * rays[i].direction});
        problem.constraints.push_back(constraint);
    }
}

Solution solved(const lang::OpenCamera& camera, const Problem& problem,
                const Options& options = {}) {
    auto made = solve(camera.camera, width, height, problem, options);
    for (const Diagnostic& one : made.diagnostics) {
        ADD_FAILURE() << one.message;
    }
    return made ? *made : Solution{};
}

std::string first_message(const Result<Solution>& result) {
    return result.diagnostics.empty() ? "" : result.diagnostics.front().message;
}

}  // namespace

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

TEST(Solve, FindsPosesOfATarget) {
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

TEST(Solve, PosesNeedNoStart) {
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

TEST(Solve, SaysThatAPoseHasNoStart) {
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

TEST(Solve, ErrorsOfProjectionsAreThoseOfTheUnknowns) {
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

TEST(Solve, ErrorsOfProjectionsLeaveOutWhatTurnsWithTheTargets) {
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

TEST(Solve, SaysWhatIsDeterminedOnlyTogether) {
    // One position beside the middle of the picture does not tell a turn from a roll.
    const lang::OpenCamera camera = aimed_camera({"yaw", "pitch", "roll"});
    Problem problem = problem_of(camera);
    problem.marks = {{{1, 0.2, 0}, true}};
    problem.constraints = {{ConstraintKind::at, {0}, V2d(100.0, 80.0)}};
    const auto solution = solve(camera.camera, width, height, problem);
    EXPECT_LT(solution->cost, 1e-12);
    ASSERT_EQ(solution.diagnostics.size(), 4U);
    EXPECT_EQ(solution.diagnostics[3].message,
              "the constraints are 2 equations, too few for 3 unknown numbers");
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
