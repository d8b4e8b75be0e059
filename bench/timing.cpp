// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "timing.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace balcony::bench {

using program::max_tile_width;

std::vector<program::Tile> tiles_of_picture(std::size_t width, std::size_t height,
                                            std::size_t tile_height) {
    std::vector<program::Tile> tiles;
    for (std::size_t y = 0; y < height; y += tile_height) {
        for (std::size_t x = 0; x < width; x += max_tile_width) {
            tiles.push_back({.x = static_cast<double>(x) + 0.5,
                             .y = static_cast<double>(y) + 0.5,
                             .width = std::min(max_tile_width, width - x),
                             .height = std::min(tile_height, height - y)});
        }
    }
    return tiles;
}

Stopwatch::Stopwatch(std::size_t tiles)
    : min_seconds_(tiles, std::numeric_limits<double>::infinity()) {}

double Stopwatch::seconds() const {
    return std::accumulate(min_seconds_.begin(), min_seconds_.end(), 0.0);
}

void Stopwatch::note(std::size_t tile, double seconds) {
    min_seconds_[tile] = std::min(min_seconds_[tile], seconds);
}

}  // namespace balcony::bench
