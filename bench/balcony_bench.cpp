// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Prints the tables of speed, all of them or those that are named. Rays a second on one core: each
// camera on each instruction set and as a plain loop, all in one run.

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <string_view>

#include <fmt/core.h>

#include "bench_case.hpp"
#include "timing.hpp"

namespace balcony::bench {

namespace {

constexpr int passes = 9;

// Seconds for the plain loop and then each instruction set. They take turns, so that whatever
// disturbs the machine for a while disturbs all of them.
std::vector<double> min_seconds(const Case& row) {
    const std::vector<program::Tile> tiles = tiles_of_picture(picture_width, picture_height);
    program::ResultArrays memory;
    const auto results = memory.reserve(ray_roots, tile_points);
    program::Scratch scratch;
    const std::size_t sets = program::instruction_sets().size();
    std::vector<Stopwatch> stopwatches(1 + sets, Stopwatch(tiles.size()));
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t t = 0; t < tiles.size(); ++t) {
            stopwatches[0].time(t, [&] { row.plain_loop(tiles[t], results); });
        }
        for (std::size_t set = 0; set < sets; ++set) {
            for (std::size_t t = 0; t < tiles.size(); ++t) {
                stopwatches[1 + set].time(
                    t, [&] { run_on(set, row.program, tiles[t], scratch, results); });
            }
        }
    }
    std::vector<double> seconds;
    for (const Stopwatch& stopwatch : stopwatches) {
        seconds.push_back(stopwatch.seconds());
    }
    return seconds;
}

// The largest difference between a camera and its plain loop, relative to the size of the value
// where that is above 1: a figure for another formula would mean nothing.
double max_difference(const Case& row) {
    program::ResultArrays loop;
    program::ResultArrays program;
    program::Scratch scratch;
    double largest = 0.0;
    for (const program::Tile& tile : tiles_of_picture(picture_width, picture_height)) {
        row.plain_loop(tile, loop.reserve(ray_roots, tile_points));
        run(row.program, tile, scratch, program.reserve(ray_roots, tile_points));
        for (std::size_t root = 0; root < ray_roots; ++root) {
            for (std::size_t i = 0; i < tile.width * tile.height; ++i) {
                const double expected = loop[root][i];
                const double difference = std::fabs(program[root][i] - expected);
                largest = std::max(largest, difference / std::max(1.0, std::fabs(expected)));
            }
        }
    }
    return largest;
}

void print_row(const Case& row) {
    using program::Rate;
    fmt::print(
        "{:<28}{:>6}/{:<5}", row.name,
        row.program.instruction_count(Rate::column) + row.program.instruction_count(Rate::row),
        row.program.instruction_count(Rate::pixel));
    constexpr double million_rays = 1e-6 * static_cast<double>(picture_width * picture_height);
    const std::vector<double> seconds = min_seconds(row);
    fmt::print("{:>9.1f}", million_rays / seconds[0]);
    for (std::size_t column = 1; column < seconds.size(); ++column) {
        fmt::print("{:>9.1f} ({:>5.1f} x)", million_rays / seconds[column],
                   seconds[0] / seconds[column]);
    }
    fmt::print("{:>11.1e}\n", max_difference(row));
}

}  // namespace

}  // namespace balcony::bench

namespace {

using namespace balcony;

void print_rays() {
    fmt::print("million rays a second, one core, {} x {} points in tiles of {} x {}\n\n",
               bench::picture_width, bench::picture_height, program::max_tile_width,
               program::max_tile_height);
    fmt::print("{:<28}{:>12}{:>9}", "camera", "curve/pixel", "loop");
    for (const program::InstructionSet& set : program::instruction_sets()) {
        fmt::print("{:>19}", set.name);
    }
    fmt::print("{:>11}\n", "difference");
    for (const bench::Case& row : bench::cases()) {
        bench::print_row(row);
    }
}

}  // namespace

int main(int argc, char** argv) {
    struct Section {
        std::string_view name;
        void (*print)();
    };
    constexpr std::array sections = {
        Section{"rays", print_rays},
        Section{"frames", bench::print_frames},
        Section{"live", bench::print_live},
        Section{"stages", bench::print_stages},
        Section{"maps", bench::print_maps},
        Section{"compile", bench::print_compilation},
        Section{"inverse", bench::print_inverse},
        Section{"solve", bench::print_solve},
        Section{"scenes", bench::print_scenes},
        Section{"start", bench::print_start},
        Section{"calls", bench::print_calls},
    };
    const std::vector<std::string_view> wanted(argv + 1, argv + argc);
    const auto is_wanted = [&wanted](const Section& section) {
        return wanted.empty() ||
               std::find(wanted.begin(), wanted.end(), section.name) != wanted.end();
    };
    try {
        for (const Section& section : sections) {
            if (is_wanted(section)) {
                section.print();
                fmt::print("\n");
            }
        }
    } catch (const std::exception& problem) {
        fmt::print(stderr, "error: {}\n", problem.what());
        return 1;
    }
}
