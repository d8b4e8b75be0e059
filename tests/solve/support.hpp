// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Cameras with open parameters, and demands that they fulfil.

#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/lang.hpp"
#include "balcony/rays.hpp"
#include "balcony/solve.hpp"

namespace balcony::solve::test {

using std::numbers::pi;

inline constexpr double width = 640.0;
inline constexpr double height = 360.0;
inline constexpr double degree = pi / 180.0;

inline const std::string aimed = R"(
    camera aimed(yaw = 0deg, pitch = 0deg, roll = 0deg, fov = 60deg from 10deg to 150deg, px = 0) {
        let half = tan(fov/2)
        map    u = half .. -half, v = square
        eye    point(0, 0, 0)
        toward plane((1, 0, 0))
        move   rotate(x, roll), rotate(y, -pitch), rotate(z, yaw), translate(px, 0, 0)
    })";

inline lang::OpenCamera open(const lang::CameraSource& source, const std::string& name,
                             const std::vector<std::string>& parameters,
                             const std::vector<lang::Override>& overrides = {}) {
    auto made = lang::Workspace().make_open_camera(source, name, overrides, parameters);
    for (const Diagnostic& one : made.diagnostics) {
        ADD_FAILURE() << one.message;
    }
    return *made;
}

inline lang::OpenCamera aimed_camera(const std::vector<std::string>& parameters) {
    return open(std::make_shared<const SourceText>("aimed.cam", aimed), "", parameters);
}

inline Problem problem_of(const lang::OpenCamera& camera) {
    Problem problem;
    for (const lang::OpenParameter& parameter : camera.open) {
        problem.unknowns.push_back(
            {lang::parameter_input(parameter.name), parameter.value, parameter.limits});
    }
    return problem;
}

// The rays at some points of the picture with these values of the open parameters.
inline std::vector<rays::Ray> rays_of(const lang::OpenCamera& camera,
                                      const std::vector<double>& values,
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
inline void demand_grid(Problem& problem, const lang::OpenCamera& camera,
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

inline Solution solved(const lang::OpenCamera& camera, const Problem& problem,
                       const Options& options = {}) {
    auto made = solve(camera.camera, width, height, problem, options);
    for (const Diagnostic& one : made.diagnostics) {
        ADD_FAILURE() << one.message;
    }
    return made ? *made : Solution{};
}

inline std::string first_message(const Result<Solution>& result) {
    return result.diagnostics.empty() ? "" : result.diagnostics.front().message;
}

}  // namespace balcony::solve::test
