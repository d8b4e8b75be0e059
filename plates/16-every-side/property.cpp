// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "measure/property.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "measure/measure.hpp"
#include "scenes/temple/measure_temple.hpp"

namespace balcony::plates {

// In how many of 16 equal sectors of the horizon a picture shows the sky.
static std::ptrdiff_t compass_points_with_sky(const render::Film& film) {
    std::array<bool, 16> seen{};
    const render::DataLayers& layers = film.layers.value();
    for (std::size_t i = 0; i < layers.object.size(); ++i) {
        const std::uint32_t id = layers.object[i];
        if (id != 0 && film.objects.at(id - 1) == "sky") {
            const double turn =
                std::atan2(layers.direction[i].y, layers.direction[i].x) / (2 * std::numbers::pi);
            seen[static_cast<std::size_t>((turn + 1.0) * 16.0) % 16] = true;
        }
    }
    return std::count(seen.begin(), seen.end(), true);
}

// All columns from outside and each in one piece, as no pinhole shows them, and the sky and the
// sand round about.
static Measurements measure_every_side(Studio& studio, const Overrides& overrides) {
    const render::Film film = studio.look(
        {.scene = "temple", .camera = "16-every-side/camera.cam", .width = 300, .height = 300},
        overrides);
    const Sightings columns = sightings_of(film, "column ");
    const RayStep step = max_step(film);
    return {{"columns seen", columns.seen, 14, 14},
            {"columns in one region", columns.connected, 14, 14},
            {"share of columns' pixels seen from outside", share_from_outside(film), 0.97},
            {"arches seen", sightings_of(film, "arch ").seen, 14, 14},
            {"regions of the ring", object_pixels(film, "ring").regions, 1, 1},
            {"points of the compass with sky, of 16", compass_points_with_sky(film), 16, 16},
            {"share of the sky", share_of(film, "sky"), 0.1, 0.4},
            {"longest step between neighbouring directions, in degrees", step.direction * 57.2958,
             0, 8}};
}

Property plate_16() {
    return {16, measure_every_side, {{{"depth", "-25"}}, {{"inward", "40deg"}}}};
}

}  // namespace balcony::plates
