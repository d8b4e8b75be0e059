// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "measure/property.hpp"
#include "scenes/wall/measure_wall.hpp"

namespace balcony::plates {

// Nothing but boxes and cylinders stands before the backdrop, and the picture shows all 64 boxes
// but two at each corner of the wall, which are beyond its upper and lower edge.
static Measurements measure_superhyperbolic_one_grid(Studio& studio, const Overrides& overrides) {
    const WallView view =
        view_wall(studio, "05-superhyperbolic-one/camera.cam", 400, overrides, false);
    return {{"boxes visible", view.boxes, 56},
            {"pixels of pictures, frames and wall pieces", view.unit_pixels(), 0, 0},
            {"pixels of anything else", view.others, 0, 0}};
}

Property plate_06() { return {6, measure_superhyperbolic_one_grid, {{{"height", "1.2"}}}}; }

}  // namespace balcony::plates
