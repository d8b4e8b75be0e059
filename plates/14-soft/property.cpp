// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "measure/property.hpp"
#include "measure/measure.hpp"

namespace balcony::plates {

static Measurements measure_soft(Studio& studio, const Overrides& overrides) {
    const Sightings letters = sightings_of(
        studio.look({.scene = "soft", .camera = "14-soft/camera.cam", .width = 320, .height = 180},
                    overrides),
        "letter ");
    return {{"letters seen", letters.seen, 4, 4},
            {"letters in one region", letters.connected, 4, 4}};
}

// From the side, letters hide one another.
Property plate_14() { return {14, measure_soft, {{{"azimuth", "90deg"}, {"height", "9.5"}}}}; }

}  // namespace balcony::plates
