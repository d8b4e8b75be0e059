// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "measure/property.hpp"
#include "scenes/wall/measure_wall.hpp"

namespace balcony::plates {

// The centre unit is enlarged to more than 30 % of the picture's width and of its height, and
// all 49 units are still visible. A hyperboloid spreads its normals evenly and does not have both.
static Measurements measure_superhyperbolic_one(Studio& studio, const Overrides& overrides) {
    constexpr std::size_t size = 400;
    const WallView view = view_wall(studio, "05-superhyperbolic-one/camera.cam", size, overrides);
    const UnitView& centre = view.units[3][3];
    return {{"width of the centre unit in that of the picture",
             double(centre.max_x - centre.min_x + 1) / size, 0.3},
            {"height of the centre unit in that of the picture",
             double(centre.max_y - centre.min_y + 1) / size, 0.3},
            {"units visible", view.units_seen(), 49, 49}};
}

Property plate_05() {
    return {5, measure_superhyperbolic_one, {{{"gamma", "1"}}, {{"width", "1.2"}}}};
}

}  // namespace balcony::plates
