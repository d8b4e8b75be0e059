// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Prints how long the calls of the library take that bench/python_calls.py makes in Python, a line
// for each: its name and its least seconds.

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>

#include <fmt/core.h>

#include "balcony/inverse.hpp"
#include "balcony/lang.hpp"
#include "balcony/parameter_derivatives.hpp"
#include "balcony/ray_arrays.hpp"
#include "bench_case.hpp"

namespace balcony::bench {

namespace {

using Imath::V3d;

constexpr int call_runs = 5;
constexpr std::size_t call_width = 4096;
constexpr std::size_t call_height = 2048;
constexpr std::size_t many_points = 1'000'000;
constexpr std::size_t some_points = 100'000;

template <class T>
T value_of(Result<T> made) {
    if (!made) {
        throw std::runtime_error(to_text(made.diagnostics));
    }
    return std::move(*made);
}

template <class Call>
void print_call(const char* name, const Call& call) {
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < call_runs; ++run) {
        const auto start = std::chrono::steady_clock::now();
        call();
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        least = std::min(least, taken.count());
    }
    fmt::print("{} {:.6f}\n", name, least);
}

// In front of the cameras, which look along x.
std::vector<V3d> points(std::size_t count) {
    std::mt19937_64 random(1996);
    std::uniform_real_distribution<double> ahead(4.0, 10.0);
    std::uniform_real_distribution<double> across(-1.0, 1.0);
    std::vector<V3d> made(count);
    for (V3d& point : made) {
        point = {ahead(random), across(random), across(random)};
    }
    return made;
}

camera::Picture picture_of(const char* name) {
    return value_of(lang::make_picture(lang::CameraSource(name), ""));
}

analyse::Locator locator_of(const char* name) {
    return value_of(analyse::Locator::make(picture_of(name), static_cast<double>(call_width),
                                           static_cast<double>(call_height)));
}

void print_rays_of_all_pixels() {
    const auto grid = value_of(bridge::RayGrid::make(picture_of("panorama"),
                                                     {.width = call_width, .height = call_height}));
    print_call("rays", [&] {
        // New memory for each call, as new arrays have.
        const std::unique_ptr<double[]> origins(new double[3 * grid.size()]);
        const std::unique_ptr<double[]> directions(new double[3 * grid.size()]);
        const std::unique_ptr<double[]> parameters(new double[2 * grid.size()]);
        const std::unique_ptr<std::uint8_t[]> valid(new std::uint8_t[grid.size()]);
        static_cast<void>(
            bridge::fill(grid, {origins.get(), directions.get(), valid.get(), parameters.get()}));
    });
}

void print_project(const char* name, const char* camera, std::size_t count) {
    const analyse::Locator locator = locator_of(camera);
    const std::vector<V3d> places = points(count);
    print_call(name, [&] {
        std::vector<std::size_t> in_part;
        const auto found = value_of(locator.locate(places, in_part));
        std::vector<Imath::V2d> positions;
        positions.reserve(places.size());
        for (const analyse::Sighting* one : analyse::foremost(found, places.size())) {
            positions.push_back(one != nullptr ? one->position : Imath::V2d(0.0));
        }
    });
}

void print_jacobian() {
    const auto picture = value_of(lang::Workspace().make_open_picture(
        lang::CameraSource("pinhole"), "", {}, std::vector<std::string>{"fov", "yaw", "pitch"}));
    const analyse::Locator locator = locator_of("pinhole");
    const std::vector<V3d> places = points(some_points);
    print_call("jacobian", [&] {
        static_cast<void>(value_of(
            app::position_derivatives(picture,
                                      {.by = std::vector<std::string>{"fov", "yaw", "pitch"},
                                       .size = {call_width, call_height}},
                                      locator, places)));
    });
}

}  // namespace

void print_calls() {
    print_rays_of_all_pixels();
    print_project("project_pinhole", "pinhole", many_points);
    print_project("project_panorama", "panorama", many_points);
    print_project("project_superelliptic", "superelliptic", some_points);
    print_jacobian();
}

}  // namespace balcony::bench
