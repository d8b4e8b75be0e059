// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Outlines: which points are outermost, and cameras whose answer can be calculated.

#include "solve/outlines.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "solve/system.hpp"
#include "support.hpp"

namespace balcony::solve::outlines_test {

using namespace test;

namespace {

// The corners of a box.
std::vector<V3d> box(const V3d& least, const V3d& greatest) {
    std::vector<V3d> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? greatest.x : least.x,
                             (i & 2) != 0 ? greatest.y : least.y,
                             (i & 4) != 0 ? greatest.z : least.z);
    }
    return corners;
}

Constraint demand(ConstraintKind kind, double value) {
    Constraint made{kind, {}, V2d(0.0), value};
    made.outline = 0;
    return made;
}

Problem about(const lang::OpenCamera& camera, std::vector<V3d> points) {
    Problem problem = problem_of(camera);
    problem.outlines = {{std::move(points)}};
    return problem;
}

}  // namespace

TEST(Outlines, TheHullHasTheOutermostCornersInOrder) {
    const std::vector<V2d> at{{2, 0}, {0, 2}, {2, 4}, {4, 2}, {2, 2}, {1, 1}, {3, 3}, {2, 4}};
    EXPECT_EQ(hull_of(at), (std::vector<V2d>{{0, 2}, {2, 0}, {4, 2}, {2, 4}}));
    EXPECT_EQ(hull_of({{1, 2}, {1, 2}}), (std::vector<V2d>{{1, 2}}));
    EXPECT_EQ(hull_of({{5, 1}, {1, 1}, {3, 1}}), (std::vector<V2d>{{1, 1}, {5, 1}}));
    EXPECT_TRUE(hull_of({}).empty());
}

TEST(Outlines, NoPositionIsOutsideOfTheHull) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(0.0, 1.0);
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<V2d> at;
        for (int i = 0; i < 30; ++i) {
            at.emplace_back(number(random), number(random));
        }
        const std::vector<V2d> corners = hull_of(at);
        ASSERT_GE(corners.size(), 3U);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const V2d side = corners[(k + 1) % corners.size()] - corners[k];
            for (const V2d& one : at) {
                EXPECT_GE(side.cross(one - corners[k]), -1e-12);
            }
        }
    }
}

TEST(Outlines, TheOutermostPositionsAreThoseOfTheKind) {
    const std::vector<V2d> at{{3, 3}, {2, 3}, {3, 1}, {9, 4}, {4, 7}};
    EXPECT_EQ(outermost(demand(ConstraintKind::left, 0.0), at),
              (std::vector<std::size_t>{1, 3, 2, 4}));
    Constraint line = demand(ConstraintKind::touches, 0.0);
    line.corners = {V2d(0, 0), V2d(1, 1)};
    EXPECT_EQ(outermost(line, at), (std::vector<std::size_t>{4, 3}));
}

// The near side of the box is 1 to the left and to the right, at a distance of 5.
TEST(Outlines, ACameraFramesABox) {
    const lang::OpenCamera camera = aimed_camera({"yaw", "fov"});
    Problem problem = about(camera, box({5, -1, -1}, {7, 1, 1}));
    problem.unknowns[0].value = 10 * degree;
    problem.constraints = {demand(ConstraintKind::left, 120.0),
                           demand(ConstraintKind::right, 520.0)};
    const Solution solution = solved(camera, problem);
    EXPECT_NEAR(solution.values[0], 0.0, 1e-9);
    EXPECT_NEAR(std::tan(solution.values[1] / 2), 320.0 * 0.2 / 200.0, 1e-9);
    ASSERT_EQ(solution.outlines.size(), 1U);
    ASSERT_EQ(solution.outlines[0].size(), 4U);
    for (const V2d& corner : solution.outlines[0]) {
        EXPECT_NEAR(std::abs(corner.x - 320.0), 200.0, 1e-6);
        EXPECT_NEAR(std::abs(corner.y - 180.0), 200.0, 1e-6);
    }
    EXPECT_TRUE(solution.seen.empty());
}

TEST(Outlines, WidthHeightBoxAndLineAreFulfilled) {
    const std::vector<V3d> points = box({5, -1, -1}, {7, 1, 1});
    const auto first_of = [&](const Constraint& constraint, const char* parameter) {
        const lang::OpenCamera camera = aimed_camera({parameter});
        Problem problem = about(camera, points);
        problem.constraints = {constraint};
        return solved(camera, problem);
    };
    // 320 pixels are tan(fov/2) at a distance of 1, and a half of the box is 0.2.
    const auto half = [](const Solution& solution) { return std::tan(solution.values[0] / 2); };
    EXPECT_NEAR(half(first_of(demand(ConstraintKind::wide, 100.0), "fov")), 64.0 / 50.0, 1e-9);
    EXPECT_NEAR(half(first_of(demand(ConstraintKind::high, 200.0), "fov")), 64.0 / 100.0, 1e-9);
    Constraint within = demand(ConstraintKind::within, 0.0);
    within.corners = {V2d(280.0, 0.0), V2d(360.0, 360.0)};
    EXPECT_NEAR(half(first_of(within, "fov")), 64.0 / 40.0, 1e-6);
    // The line is the upper border, which the upper side of the box begins below.
    Constraint touches = demand(ConstraintKind::touches, 0.0);
    touches.corners = {V2d(0.0, 0.0), V2d(640.0, 0.0)};
    EXPECT_NEAR(half(first_of(touches, "fov")), 64.0 / 180.0, 1e-9);
}

// While the camera turns, other corners become the outermost ones.
TEST(Outlines, ResidualsAreContinuousWhereCornersTakeTurns) {
    const lang::OpenCamera camera = aimed_camera({"roll", "yaw"});
    Problem problem = about(camera, box({5, -1, -0.6}, {7, 0.8, 1}));
    for (const ConstraintKind kind : {ConstraintKind::left, ConstraintKind::top,
                                      ConstraintKind::wide, ConstraintKind::touches}) {
        problem.constraints.push_back(demand(kind, 0.0));
    }
    problem.constraints.back().corners = {V2d(400.0, 0.0), V2d(500.0, 360.0)};
    const Problem marked = with_outline_marks(problem);
    const CameraMaker make = [&](std::span<const double>) { return camera.camera; };
    const auto rays = CameraRays::make(make, V2d(width, height), marked, {});
    ASSERT_TRUE(rays);
    System system(*rays, marked, V2d(width, height), std::vector<V2d>(8, V2d(320.0, 180.0)));
    constexpr double step = 1e-3;
    std::optional<Residuals> last;
    int changes = 0;
    for (double turn = -0.8; turn < 0.8; turn += step) {
        const auto now = system.residuals(Eigen::Vector2d(turn, 0.1));
        ASSERT_TRUE(now);
        for (Eigen::Index r = 0; last && r < now->values.size(); ++r) {
            const double was = std::abs(last->values[r]);
            const double slope =
                std::max(std::abs(last->by_unknown(r, 0)), std::abs(now->by_unknown(r, 0)));
            // The slope changes by less than 1000 pixels for a radian more.
            EXPECT_NEAR(std::abs(now->values[r]), was, step * (slope + 1.0)) << turn << ' ' << r;
            const double jump = (now->by_unknown.row(r) - last->by_unknown.row(r)).norm();
            changes += jump > 20.0 ? 1 : 0;
        }
        last = now;
    }
    EXPECT_GE(changes, 2);
}

TEST(Outlines, APointThatNoRayMeetsIsAnError) {
    const lang::OpenCamera camera = aimed_camera({"fov"});
    Problem problem = about(camera, box({-1, -1, -1}, {7, 1, 1}));
    problem.outlines[0].name = "house";
    problem.constraints = {demand(ConstraintKind::left, 120.0)};
    EXPECT_EQ(first_message(solve(camera.camera, width, height, problem)),
              "no ray of the first values meets a point of the outline 'house'");
}

TEST(Outlines, AConstraintHasItsOutlineAndItsCorners) {
    const lang::OpenCamera camera = aimed_camera({"fov"});
    Problem problem = about(camera, box({5, -1, -1}, {7, 1, 1}));
    const auto said = [&](const Constraint& constraint) {
        problem.constraints = {constraint};
        return first_message(solve(camera.camera, width, height, problem));
    };
    Constraint wrong = demand(ConstraintKind::left, 1.0);
    wrong.outline = 1;
    EXPECT_EQ(said(wrong), "constraint 1 ('left') is about no outline");
    wrong = demand(ConstraintKind::isotropic, 0.0);
    EXPECT_EQ(said(wrong), "constraint 1 ('isotropic') is about an outline");
    wrong = demand(ConstraintKind::touches, 0.0);
    EXPECT_EQ(said(wrong), "constraint 1 ('touches') has corners that are no box or line");
    wrong.corners = {V2d(1.0), V2d(1.0)};
    EXPECT_EQ(said(wrong), "constraint 1 ('touches') has corners that are no box or line");
    wrong = demand(ConstraintKind::within, 0.0);
    wrong.corners = {V2d(1.0, 1.0), V2d(5.0, 0.0)};
    EXPECT_EQ(said(wrong), "constraint 1 ('within') has corners that are no box or line");
    problem.outlines[0].points.clear();
    EXPECT_EQ(said(demand(ConstraintKind::left, 1.0)),
              "outline 1 has no points, or some at no place");
}

}  // namespace balcony::solve::outlines_test
