// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "measure/property.hpp"
#include "scenes/wall/measure_wall.hpp"

namespace balcony::plates {

// All units are visible, and of one size: an overview without details. The outermost units show a
// little less of their wall, which is behind their frames.
static Measurements measure_wall_pinhole(Studio& studio, const Overrides& overrides) {
    const WallView view = view_wall(studio, "04-wall/camera.cam", 400, overrides);
    const auto width_of = [](const UnitView& unit) { return double(unit.max_x - unit.min_x + 1); };
    const double centre = width_of(view.units[3][3]);
    return {{"units visible", view.units_seen(), 49, 49},
            {"width of the centre unit in that of a corner unit",
             centre / width_of(view.units[0][0]), 0.95, 1.05},
            {"width of the centre unit in that of the picture", centre / 400, 0, 0.15}};
}

Property plate_04() { return {4, measure_wall_pinhole, {{{"fov", "30deg"}}, {{"yaw", "20deg"}}}}; }

}  // namespace balcony::plates
