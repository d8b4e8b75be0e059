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
        const std::size_t column = x / block_side;
        const std::size_t row = y / block_side;
        const auto place =
            morton(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
        const auto block = (row - first_row_) * columns_ + column - first_column_;
        const std::uint32_t chance = mixed(place ^ seed_);
        const bool upright = chance % 2 != 0;
        const std::size_t along = (upright ? y : x) % block_side;
        const std::size_t across = (upright ? x : y) % block_side;
        const std::size_t cell = across / 8 * 4 + along / 4;
        const std::size_t in_cell = across % 8 * 4 + along % 4;
        const std::uint32_t moved = mixed(chance + static_cast<std::uint32_t>(cell)) % groups;
        return static_cast<std::uint32_t>(groups * block + (in_cell ^ moved));
    }

private:
    static constexpr std::size_t groups = block_side * block_side / size;

    std::size_t first_column_, first_row_, columns_;
    std::uint32_t seed_;
};

}  // namespace balcony::render
