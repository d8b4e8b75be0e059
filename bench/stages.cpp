// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What each stage costs: the example of its row in the catalogue, a whole camera, on one core. And
// how long cameras take from their text to a program.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "balcony/catalogue.hpp"
#include "balcony/lang.hpp"
#include "bench_case.hpp"
#include "timing.hpp"

namespace balcony::bench {

namespace {

constexpr int stage_passes = 5;
constexpr std::size_t width = 640;
constexpr std::size_t height = 360;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double nanoseconds_a_ray(const program::Program& program) {
    const std::vector<program::Tile> tiles = tiles_of_picture(width, height);
    program::ResultArrays memory;
    const auto results = memory.reserve(program.root_count(), tile_points);
    program::Scratch scratch;
    Stopwatch stopwatch(tiles.size());
    for (int pass = 0; pass < stage_passes; ++pass) {
        for (std::size_t t = 0; t < tiles.size(); ++t) {
            stopwatch.time(t, [&] { program::run(program, tiles[t], scratch, results); });
        }
    }
    return 1e9 * stopwatch.seconds() / static_cast<double>(width * height);
}

void print_program(std::string_view name, const program::Program& program) {
    const double nanoseconds = nanoseconds_a_ray(program);
    fmt::print("{:<52}{:>6}{:>10.1f}{:>10.1f}\n", name,
               program.instruction_count(program::Rate::pixel), nanoseconds, 1e3 / nanoseconds);
}

void print_camera(std::string_view name, const std::string& text) {
    print_program(name, compile(make_camera(text), width, height));
}

// A NURBS patch of 16 x 16 points with weights, u and v not separable.
std::string patch_text() {
    constexpr int side = 16;
    std::string points;
    for (int i = 0; i < side * side; ++i) {
        const int column = i % side;
        const int row = i / side;
        points += fmt::format("{}({}, {}, {:.3f}, {})", i == 0 ? "" : ", ", column, row,
                              std::sin(0.7 * column) * std::cos(0.5 * row), 1 + i % 3);
    }
    return fmt::format(
        "camera patch {{\n"
        "    map  u = 0.1 .. 0.9, v = 0.1 .. 0.9\n"
        "    warp rotate(5deg, at = (0.5, 0.5))\n"
        "    eye  nurbs_patch([{}], columns = {})\n"
        "    look normal\n"
        "}}\n",
        points, side);
}

std::string thin_plate_text() {
    constexpr int count = 32;
    std::string seeds;
    for (int i = 0; i < count; ++i) {
        const double u = std::cos(2.4 * i) * std::sqrt(i / 32.0);
        const double v = std::sin(2.4 * i) * std::sqrt(i / 32.0);
        seeds += fmt::format("{}({:.4f}, {:.4f}, {:.4f}, {:.4f})", i == 0 ? "" : ", ", u, v,
                             u + 0.05 * std::sin(5.0 * v), v + 0.05 * std::cos(4.0 * u));
    }
    return fmt::format(
        "camera plate {{\n"
        "    map    u = 1 .. -1, v = square\n"
        "    warp   thin_plate([{}])\n"
        "    eye    point(0, 0, 0)\n"
        "    toward plane(at = (1, 0, 0))\n"
        "}}\n",
        seeds);
}

constexpr const char* coin_text =
    "camera coin {\n"
    "    map    u = 1 .. -1, v = square\n"
    "    eye    point(0, 0, 0)\n"
    "    toward { object plane(at = (1, 0, 0))  move coin((1, 0.2, 0.1)) }\n"
    "}\n";

}  // namespace

void print_stages() {
    fmt::print("{:<52}{:>6}{:>10}{:>10}\n", "camera of each stage's example, one core", "pixel",
               "ns a ray", "M rays/s");
    print_camera("NURBS patch of 16 x 16 with normals (reach: 2)", patch_text());
    print_camera("thin-plate warp of 32 points (reach: 2)", thin_plate_text());
    print_camera("COIN (reach: 10)", coin_text);
    for (const camera::StageEntry& row : camera::catalogue()) {
        // An example that is a picture of several cameras is no measure of a ray.
        const std::string example(row.example);
        if (!example.empty() && ("\n" + example).find("\npicture ") == std::string::npos) {
            print_camera(fmt::format("{} {}", camera::name_of(row.kind), row.name), example);
        }
    }
}

void print_maps() {
    fmt::print("{:<52}{:>6}{:>10}{:>10}\n", "map projections, one core (reach: 3 M rays/s)",
               "pixel", "ns a ray", "M rays/s");
    for (const std::string& name : lang::built_in_cameras()) {
        if (lang::family_of(name) == "maps") {
            print_program(name, compile(*lang::make_camera(name, ""), width, height));
        }
    }
}

void print_compilation() {
    fmt::print("{:<52}{:>16}{:>16}\n", "milliseconds from text to program (reach: 10)", "first",
               "best of 5");
    for (const std::string& name : lang::built_in_cameras()) {
        if (!lang::make_camera(name, "")) {
            continue;  // A picture of several cameras.
        }
        double first = 0.0;
        double best = std::numeric_limits<double>::infinity();
        for (int pass = 0; pass < stage_passes; ++pass) {
            const auto start = std::chrono::steady_clock::now();
            const auto made = lang::make_camera(name, "");
            (void)compile(*made, width, height);
            const double milliseconds = 1e3 * seconds_since(start);
            first = pass == 0 ? milliseconds : first;
            best = std::min(best, milliseconds);
        }
        fmt::print("{:<52}{:>16.2f}{:>16.2f}\n", name, first, best);
    }
}

}  // namespace balcony::bench
