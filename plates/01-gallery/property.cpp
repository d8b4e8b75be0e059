// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "measure/property.hpp"
#include "scenes/gallery/measure_gallery.hpp"

namespace balcony::plates {

// From any position in the room, a pinhole camera shows at most four pictures completely.
static Measurements measure_pinhole(Studio& studio, const Overrides& overrides) {
    const GalleryView view = view_gallery(
        studio.scene("gallery"),
        studio.look(
            {.scene = "gallery", .camera = "01-gallery/camera.cam", .width = 700, .height = 350},
            overrides));
    return {{"pictures wholly visible", view.wholly_visible, 1, 4}};
}

Property plate_01() { return {1, measure_pinhole, {{{"yaw", "135deg"}}}}; }

}  // namespace balcony::plates
