// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "measure/measure.hpp"
#include "measure/property.hpp"

namespace balcony::plates {

namespace kitchen_table_plate {

// Rows divided by columns of what is seen of an object above a height in the scene.
double proportion(const render::Film& film, const std::string& object, float above) {
    std::size_t first_row = std::numeric_limits<std::size_t>::max();
    std::size_t first_column = first_row;
    std::size_t last_row = 0;
    std::size_t last_column = 0;
    for (std::size_t i = 0; i < film.width * film.height; ++i) {
        const std::uint32_t id = film.layers->object[i];
        if (id == 0 || film.objects[id - 1] != object || film.layers->position[i].z < above) {
            continue;
        }
        first_row = std::min(first_row, i / film.width);
        last_row = std::max(last_row, i / film.width);
        first_column = std::min(first_column, i % film.width);
        last_column = std::max(last_column, i % film.width);
    }
    return last_column > first_column ? static_cast<double>(last_row - first_row) /
                                            static_cast<double>(last_column - first_column)
                                      : 0.0;
}

// The plate is seen from above and the mouth of the jar from its side, which no one eye can do, and
// all things are there.
Measurements measure(Studio& studio, const Overrides& overrides) {
    const render::Film film = studio.look(
        {.scene = "kitchen_table", .camera = "23-table/camera.cam", .width = 800, .height = 600},
        overrides);
    const Sightings fruit = sightings_of(film, "apple");
    return {{"height of the plate divided by its width", proportion(film, "plate", -1.0F), 0.75},
            {"height of the jar's mouth divided by its width",
             proportion(film, "ginger jar", 0.233F), 0, 0.15},
            {"loose fruit and stalks that are seen", fruit.seen, 7}};
}

}  // namespace kitchen_table_plate

Property plate_23() {
    return {23, kitchen_table_plate::measure, {{{"play", "0"}}, {{"play", "0.4"}}}};
}

}  // namespace balcony::plates
