// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "measure/property.hpp"
#include "scenes/wall/measure_wall.hpp"

namespace balcony::plates {

// The middle row and column, 13 of 49 units and 26.5 % of the wall, nearly disappear; all units of
// the four quarters remain.
static Measurements measure_superhyperbolic_two(Studio& studio, const Overrides& overrides) {
    const WallView view = view_wall(studio, "07-superhyperbolic-two/camera.cam", 400, overrides);
    constexpr std::size_t middle = wall_units / 2;
    std::size_t cross = 0;
    std::size_t quarters = 0;
    for (std::size_t row = 0; row < wall_units; ++row) {
        for (std::size_t column = 0; column < wall_units; ++column) {
            const std::size_t pixels = view.units[row][column].pixels;
            if (row == middle || column == middle) {
                cross += pixels;
            } else {
                quarters += pixels > 0 ? 1 : 0;
            }
        }
    }
    return {{"share of the middle cross in the pixels of the wall",
             double(cross) / double(view.unit_pixels()), 0, 0.06},
            {"units of the four quarters visible", quarters, 36, 36}};
}

Property plate_07() {
    return {7, measure_superhyperbolic_two, {{{"gamma", "1"}}, {{"width", "0.5"}}}};
}

}  // namespace balcony::plates
