// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/corner/measure_corner.hpp"

namespace balcony::plates {

// A fair view to compare with: it shows all four pictures.
static Measurements measure_corner(Studio& studio, const Overrides& overrides) {
    const CornerView view = view_corner(studio.scene("corner"),
                                        look_at_corner(studio, "09-corner/camera.cam", overrides));
    return {{"pictures wholly visible", view.wholly_visible, 4, 4},
            {"median anisotropy", view.median_anisotropy, 1}};
}

Property plate_09() {
    return {9, measure_corner, {{{"half_width", "0.35"}}, {{"distance", "16"}}}};
}

}  // namespace balcony::plates
