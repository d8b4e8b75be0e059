// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What all tables of rays measure with. Every tile counts with the best of several passes over the
// picture, as anything else that runs on the machine only ever makes it slower.

#include <chrono>
#include <vector>

#include "balcony/program.hpp"

namespace balcony::bench {

/// The points of the largest tile.
inline constexpr std::size_t tile_points = program::max_tile_width * program::max_tile_height;

[[nodiscard]] std::vector<program::Tile> tiles_of_picture(
    std::size_t width, std::size_t height, std::size_t tile_height = program::max_tile_height);

/// The least time of each tile.
class Stopwatch {
public:
    explicit Stopwatch(std::size_t tiles);

    template <class Function>
    void time(std::size_t tile, Function function) {
        const auto start = std::chrono::steady_clock::now();
        function();
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        note(tile, taken.count());
    }

    [[nodiscard]] double seconds() const;

private:
    void note(std::size_t tile, double seconds);

    std::vector<double> min_seconds_;
};

}  // namespace balcony::bench
