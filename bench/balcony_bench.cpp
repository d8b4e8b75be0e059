// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Prints rays a second on one core: each camera on each instruction set and as a plain loop, all in
// one run. Every tile counts with the best of several passes over the picture, as anything else
// that runs on the machine only ever makes it slower.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <numeric>

#include <fmt/core.h>

#include "bench_case.hpp"

namespace balcony::bench {

namespace {

using program::Tile;

constexpr int passes = 9;

// Where the rays of one tile go.
class TileResults {
public:
    TileResults() : memory_(ray_roots * points_of_tile) {
        for (std::size_t root = 0; root < ray_roots; ++root) {
            pointers_.push_back(memory_.data() + root * points_of_tile);
        }
    }
    [[nodiscard]] std::span<double* const> pointers() const { return pointers_; }

private:
    static constexpr std::size_t points_of_tile =
        program::max_tile_width * program::max_tile_height;
    std::vector<double> memory_;
    std::vector<double*> pointers_;
};

std::vector<Tile> tiles_of_picture() {
    using program::max_tile_height;
    using program::max_tile_width;
    std::vector<Tile> tiles;
    for (std::size_t y = 0; y < picture_height; y += max_tile_height) {
        for (std::size_t x = 0; x < picture_width; x += max_tile_width) {
            tiles.push_back({.x = static_cast<double>(x) + 0.5,
                             .y = static_cast<double>(y) + 0.5,
                             .width = std::min(max_tile_width, picture_width - x),
                             .height = std::min(max_tile_height, picture_height - y)});
        }
    }
    return tiles;
}

// The least time of each tile.
class Stopwatch {
public:
    explicit Stopwatch(std::size_t tiles)
        : least_seconds_(tiles, std::numeric_limits<double>::infinity()) {}

    template <class Function>
    void time(std::size_t tile, Function function) {
        const auto start = std::chrono::steady_clock::now();
        function();
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        least_seconds_[tile] = std::min(least_seconds_[tile], taken.count());
    }

    [[nodiscard]] double seconds() const {
        return std::accumulate(least_seconds_.begin(), least_seconds_.end(), 0.0);
    }

private:
    std::vector<double> least_seconds_;
};

// Seconds for the plain loop and then each instruction set. They take turns, so that whatever
// disturbs the machine for a while disturbs all of them.
std::vector<double> least_seconds(const Case& row) {
    const std::vector<Tile> tiles = tiles_of_picture();
    const TileResults results;
    program::Scratch scratch;
    const std::size_t sets = program::instruction_sets().size();
    std::vector<Stopwatch> stopwatches(1 + sets, Stopwatch(tiles.size()));
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t t = 0; t < tiles.size(); ++t) {
            stopwatches[0].time(t, [&] { row.plain_loop(tiles[t], results.pointers()); });
        }
        for (std::size_t set = 0; set < sets; ++set) {
            for (std::size_t t = 0; t < tiles.size(); ++t) {
                stopwatches[1 + set].time(
                    t, [&] { run_on(set, row.program, tiles[t], scratch, results.pointers()); });
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
double largest_difference(const Case& row) {
    const TileResults loop;
    const TileResults program;
    program::Scratch scratch;
    double largest = 0.0;
    for (const Tile& tile : tiles_of_picture()) {
        row.plain_loop(tile, loop.pointers());
        run(row.program, tile, scratch, program.pointers());
        for (std::size_t root = 0; root < ray_roots; ++root) {
            for (std::size_t i = 0; i < tile.width * tile.height; ++i) {
                const double expected = loop.pointers()[root][i];
                const double difference = std::fabs(program.pointers()[root][i] - expected);
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
    const std::vector<double> seconds = least_seconds(row);
    fmt::print("{:>9.1f}", million_rays / seconds[0]);
    for (std::size_t column = 1; column < seconds.size(); ++column) {
        fmt::print("{:>9.1f} ({:>5.1f} x)", million_rays / seconds[column],
                   seconds[0] / seconds[column]);
    }
    fmt::print("{:>11.1e}\n", largest_difference(row));
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

int main() {
    try {
        print_rays();
        bench::print_frames();
        bench::print_inverse();
    } catch (const std::exception& problem) {
        fmt::print(stderr, "error: {}\n", problem.what());
        return 1;
    }
}
