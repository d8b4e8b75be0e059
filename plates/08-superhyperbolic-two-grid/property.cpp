// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "measure/property.hpp"
#include "scenes/wall/measure_wall.hpp"

namespace balcony::plates {

// Nothing but boxes and cylinders stands before the backdrop, and no box is lost: only the space
// between the middle ones is.
static Measurements measure_superhyperbolic_two_grid(Studio& studio, const Overrides& overrides) {
    const WallView view =
        view_wall(studio, "07-superhyperbolic-two/camera.cam", 400, overrides, false);
    return {{"boxes visible", view.boxes, 64, 64},
            {"pixels of pictures, frames and wall pieces", view.unit_pixels(), 0, 0},
            {"pixels of anything else", view.others, 0, 0}};
}

Property plate_08() { return {8, measure_superhyperbolic_two_grid, {{{"height", "1.2"}}}}; }

}  // namespace balcony::plates
