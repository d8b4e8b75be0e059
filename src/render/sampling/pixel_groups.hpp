// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "balcony/film.hpp"
#include "render/sampling/digits.hpp"

namespace balcony::render {

/// Groups of eight neighbouring pixels: two quads of 2 x 2 pixels each, from a block of 4 x 4. In
/// every pass and block, chance decides which quads make a group, so that no border between groups
/// stays.
class PixelGroups {
public:
    static constexpr std::size_t size = 8;

    PixelGroups(const Region& region, std::size_t pass)
        : first_column_(region.x / block_side),
          first_row_(region.y / block_side),
          columns_((region.x + region.width - 1) / block_side - first_column_ + 1),
          seed_(mixed(static_cast<std::uint32_t>(pass))) {}

    /// The group of a pixel of the region, by its place in the picture; counts from 0.
    [[nodiscard]] std::uint32_t of(std::size_t x, std::size_t y) const {
        const std::size_t column = x / block_side;
        const std::size_t row = y / block_side;
        const auto place =
            morton(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
        const auto block = (row - first_row_) * columns_ + column - first_column_;
        const bool right = x / 2 % 2 != 0;
        const bool low = y / 2 % 2 != 0;
        std::size_t half = 0;
        switch (mixed(place ^ seed_) % 3) {
            case 0: half = low ? 1 : 0; break;     // The quads beside each other,
            case 1: half = right ? 1 : 0; break;   // above each other,
            default: half = right != low ? 1 : 0;  // and across.
        }
        return static_cast<std::uint32_t>(2 * block + half);
    }

private:
    static constexpr std::size_t block_side = 4;

    std::size_t first_column_, first_row_, columns_;
    std::uint32_t seed_;
};

}  // namespace balcony::render
