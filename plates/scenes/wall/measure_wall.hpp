// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a picture of the wall shows of its units.

#include <array>
#include <cstddef>
#include <string>

#include "measure/property.hpp"
#include "scenes/wall/wall.hpp"

namespace balcony::plates {

/// What a picture shows of a unit: its picture, frame and piece of wall.
struct UnitView {
    std::size_t pixels = 0;
    std::size_t min_x = 0, max_x = 0, min_y = 0, max_y = 0;  ///< Of these pixels, if there are any.
};

struct WallView {
    /// By row and column.
    std::array<std::array<UnitView, wall_units>, wall_units> units;
    std::size_t boxes = 0;   ///< How many of them are seen.
    std::size_t others = 0;  ///< Pixels of anything but units, boxes, cylinders and the backdrop.

    [[nodiscard]] std::size_t units_seen() const;
    [[nodiscard]] std::size_t unit_pixels() const;
};

/// Looks through the camera file of a plate, `size` pixels wide and high.
[[nodiscard]] WallView view_wall(Studio& studio, const std::string& camera, std::size_t size,
                                 const Overrides& overrides, bool pictures_and_walls = true);

}  // namespace balcony::plates
