// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include "measure/measure.hpp"
#include "measure/property.hpp"

namespace balcony::plates {

// Nothing hides the boxes that stand along the walls, apart from the rows along floor and ceiling:
// each is one region, and the pixels around them are empty.
static Measurements measure_grid(Studio& studio, const Overrides& overrides) {
    const render::Film film = studio.look({.scene = "gallery",
                                           .camera = "02-superelliptic/camera.cam",
                                           .width = 2000,
                                           .height = 400,
                                           .pictures_and_walls = false},
                                          overrides);
    const Sightings boxes = sightings_of(film, "box ");
    const Sightings cylinders = sightings_of(film, "cylinder ");
    const auto& ids = film.layers->object;
    const auto empty = static_cast<std::size_t>(std::count(ids.begin(), ids.end(), 0U));
    const double all = static_cast<double>(film.width * film.height);
    return {{"share of boxes seen", double(boxes.seen) / double(boxes.objects), 0.9},
            {"share of boxes in one region", double(boxes.connected) / double(boxes.objects), 0.9},
            {"pixels of anything but boxes, cylinders and the void",
             all - double(boxes.pixels + cylinders.pixels + empty), 0, 0}};
}

Property plate_03() { return {3, measure_grid, {{{"a", "60"}}}}; }

}  // namespace balcony::plates
