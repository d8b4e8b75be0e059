// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Prints how long it takes to find parameters of a camera from points that it shows.

#include "balcony/solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <fmt/format.h>

#include "balcony/drag.hpp"
#include "balcony/lang.hpp"
#include "balcony/ray_roots.hpp"
#include "bench_case.hpp"

namespace balcony::bench {

namespace {

const solve::V2d solved_size(960.0, 540.0);
constexpr int passes = 5;

// A pinhole camera with a polynomial warp of many coefficients.
lang::CameraSource warped(std::size_t coefficients) {
    std::string parameters;
    std::array<std::string, 2> sums{"u", "v"};
    for (std::size_t i = 0; i < coefficients; ++i) {
        parameters += fmt::format("{}k{} = 0", i == 0 ? "" : ", ", i);
        const std::size_t order = i / 2;
        sums[i % 2] += fmt::format(" + k{}*u^{}*v^{}", i, order % 5, order / 5);
    }
    const std::string text = fmt::format(R"(camera warped({}) {{
    map    u = 1 .. -1, v = square
    warp   formula(u, v) = [{}, {}]
    eye    point(0, 0, 0)
    toward plane((1, 0, 0))
}})",
                                         parameters, sums[0], sums[1]);
    return {std::make_shared<const SourceText>("warped.cam", text)};
}

// Marks at random distances along the rays of the camera as it is, and where they appear, up to a
// normal error of half a pixel.
solve::Problem problem_of(const lang::OpenCamera& camera, std::size_t marks) {
    solve::Problem problem;
    expr::Graph graph;
    const auto ray = camera.camera.emit(graph, solved_size.x, solved_size.y);
    const Axes axes = camera.camera.parts().axes;
    const std::vector<expr::Expr> roots = rays::ray_roots(ray, false, false, axes, axes);
    std::vector<std::string> names;
    for (const lang::OpenParameter& parameter : camera.open) {
        problem.unknowns.push_back(
            {lang::parameter_input(parameter.name), parameter.value, parameter.limits});
    }
    std::vector<expr::InputValue> inputs;
    for (const solve::Unknown& unknown : problem.unknowns) {
        inputs.push_back({unknown.input, unknown.value});
    }
    std::mt19937_64 random(1996);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> half_a_pixel(0.0, 0.5);
    while (problem.marks.size() < marks) {
        const solve::V2d at(solved_size.x * unit(random), solved_size.y * unit(random));
        const auto v = expr::evaluate(roots, {at.x, at.y, 0.0, {}, inputs});
        if (v[6] != 1.0) {
            continue;
        }
        const double distance = 1.0 + 9.0 * unit(random);
        problem.constraints.push_back(
            {solve::ConstraintKind::at,
             {problem.marks.size()},
             at + solve::V2d(half_a_pixel(random), half_a_pixel(random))});
        problem.marks.push_back(
            {solve::V3d(v[0], v[1], v[2]) + distance * solve::V3d(v[3], v[4], v[5])});
    }
    return problem;
}

// Two points are seen. One is held, and a hand pulls the other one 60 pixels to the right in steps
// of 2.
void print_drags() {
    fmt::print("\na point that is pulled and one that is held, all open parameters follow\n\n");
    fmt::print("{:<20}{:>10}{:>12}{:>12}{:>12}\n", "camera", "unknowns", "compile ms", "median ms",
               "most ms");
    for (const char* const name : {"pinhole", "panorama", "fisheye", "panini"}) {
        const auto picture = lang::Workspace().make_open_picture(name);
        const auto camera = lang::Workspace().make_open_camera(name, "", {});
        if (!picture || !camera) {
            throw std::runtime_error("a built-in camera is not made");
        }
        const solve::Problem seen = problem_of(*camera, 2);
        const auto start = std::chrono::steady_clock::now();
        auto hand = live::Dragger::make(*picture, 0, {960, 540});
        const std::chrono::duration<double, std::milli> compiled =
            std::chrono::steady_clock::now() - start;
        if (!hand) {
            throw std::runtime_error(hand.diagnostics.front().message);
        }
        std::vector<double> taken;
        for (int step = 1; step <= 30; ++step) {
            live::Drag drag;
            for (std::size_t i = 0; i < seen.marks.size(); ++i) {
                const solve::V2d at = seen.constraints[i].position;
                drag.pulls.push_back({seen.marks[i].place, false, at,
                                      i == 0 ? at : at + solve::V2d(2.0 * step, 0.0)});
            }
            taken.push_back(1e3 * hand->drag(drag, {}, camera->camera.parts().axes).seconds);
        }
        std::sort(taken.begin(), taken.end());
        fmt::print("{:<20}{:>10}{:>12.1f}{:>12.2f}{:>12.2f}\n", name, picture->open.size(),
                   compiled.count(), taken[taken.size() / 2], taken.back());
    }
}

}  // namespace

void print_solve() {
    struct SolveCase {
        const char* name;
        lang::CameraSource camera;
        std::optional<std::vector<std::string>> parameters;
        std::size_t marks;
    };
    const std::vector<SolveCase> cases{
        {"pinhole", "pinhole", {{"fov"}}, 3},
        {"panorama", "panorama", {{"yaw"}}, 3},
        {"superelliptic", "superelliptic", {{"px"}}, 3},
        {"pinhole", "pinhole", {{"fov", "px", "py", "pz", "yaw", "pitch", "roll"}}, 100},
        {"polynomial warp", warped(50), {}, 5000},
    };
    fmt::print("\nparameters found from points that a picture of {} x {} pixels shows\n\n",
               solved_size.x, solved_size.y);
    fmt::print("{:<20}{:>10}{:>8}{:>12}{:>10}\n", "camera", "unknowns", "marks", "iterations",
               "ms");
    for (const SolveCase& one : cases) {
        const auto camera = lang::Workspace().make_open_camera(one.camera, "", {}, one.parameters);
        if (!camera) {
            throw std::runtime_error(camera.diagnostics.front().message);
        }
        const solve::Problem problem = problem_of(*camera, one.marks);
        double least = std::numeric_limits<double>::infinity();
        std::size_t iterations = 0;
        for (int pass = 0; pass < passes; ++pass) {
            const auto start = std::chrono::steady_clock::now();
            const auto solved = solve::solve(camera->camera, solved_size.x, solved_size.y, problem);
            const std::chrono::duration<double, std::milli> taken =
                std::chrono::steady_clock::now() - start;
            least = std::min(least, taken.count());
            iterations = solved ? solved->iterations : 0;
        }
        fmt::print("{:<20}{:>10}{:>8}{:>12}{:>10.1f}\n", one.name, problem.unknowns.size(),
                   one.marks, iterations, least);
    }
    print_drags();
}

}  // namespace balcony::bench
