// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "balcony/film.hpp"
#include "render/sampling/digits.hpp"

namespace balcony::render {

/// Groups of eight pixels of a block of 16 x 16: one of each of eight cells of 4 x 8 or 8 x 4. In
/// every pass and block, chance decides which cells and which pixels. So most neighbours are in
/// different groups, and their noise is independent.
class PixelGroups {
public:
    static constexpr std::size_t size = 8;
    static constexpr std::size_t block_side = 16;

    PixelGroups(const Region& region, std::size_t pass)
        : first_column_(region.x / block_side),
          first_row_(region.y / block_side),
          columns_((region.x + region.width - 1) / block_side - first_column_ + 1),
          seed_(mixed(static_cast<std::uint32_t>(pass))) {}

    /// The group of a pixel of the region, by its place in the picture; counts from 0.
    [[nodiscard]] std::uint32_t of(std::size_t x, std::size_t y) const {
        const Place at = place(x, y, 0, 0);
        const std::size_t cell = at.across / 8 * 4 + at.along / 4;
        const std::size_t in_cell = at.across % 8 * 4 + at.along % 4;
        const std::uint32_t moved = mixed(at.chance + static_cast<std::uint32_t>(cell)) % groups;
        return static_cast<std::uint32_t>(groups * at.block + (in_cell ^ moved));
    }

    /// The same for groups of 2 x 4 or 4 x 2 neighbours, whose grid is moved by chance and wraps
    /// around in each block. Their noise is not independent, but what they see is more alike.
    [[nodiscard]] std::uint32_t near(std::size_t x, std::size_t y) const {
        const std::uint32_t shift = mixed(seed_);
        const Place at = place(x, y, shift % block_side, shift / block_side % block_side);
        return static_cast<std::uint32_t>(groups * at.block + at.across / 2 * 4 + at.along / 4);
    }

private:
    struct Place {
        std::size_t block, along, across;
        std::uint32_t chance;
    };
    [[nodiscard]] Place place(std::size_t x, std::size_t y, std::size_t right,
                              std::size_t down) const {
        const std::size_t column = x / block_side;
        const std::size_t row = y / block_side;
        const auto number =
            morton(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
        const std::uint32_t chance = mixed(number ^ seed_);
        const std::size_t moved_x = (x + right) % block_side;
        const std::size_t moved_y = (y + down) % block_side;
        const bool upright = chance % 2 != 0;
        return {(row - first_row_) * columns_ + column - first_column_, upright ? moved_y : moved_x,
                upright ? moved_x : moved_y, chance};
    }

    static constexpr std::size_t groups = block_side * block_side / size;

    std::size_t first_column_, first_row_, columns_;
    std::uint32_t seed_;
};

}  // namespace balcony::render
