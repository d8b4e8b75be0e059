// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include "measure/measure.hpp"
#include "measure/property.hpp"
#include "scenes/temple/measure_temple.hpp"

namespace balcony::plates {

// The share of the origins of plate 13's rays that the picture shows: some pixel looks that way,
// and nothing stands before it.
static double share_in_view(const render::Film& picture, const render::Film& flight) {
    const render::DataLayers& seen = picture.layers.value();
    const auto& origins = flight.layers.value().origin;
    const scene::V3d eye(seen.origin.front());
    // A pixel is about 1 / width radians wide.
    const double nearly_one = 1.0 - 0.5 / static_cast<double>(picture.width * picture.width);
    std::size_t in_view = 0;
    for (std::size_t x = 0; x < flight.width; ++x) {
        const scene::V3d way = scene::V3d(origins[x]) - eye;
        const double distance = way.length();
        for (std::size_t i = 0; i < seen.direction.size(); ++i) {
            if (scene::V3d(seen.direction[i]).dot(way) > nearly_one * distance) {
                in_view += seen.ray_length[i] > distance ? 1 : 0;
                break;
            }
        }
    }
    return static_cast<double>(in_view) / static_cast<double>(flight.width);
}

// The whole temple from its front, and the way of plate 13's camera through it.
static Measurements measure_temple_pinhole(Studio& studio, const Overrides& overrides) {
    const render::Film film = studio.look(
        {.scene = "temple", .camera = "12-temple/camera.cam", .width = 300, .height = 200},
        overrides);
    const render::Film flight = studio.look(
        {.scene = "temple", .camera = "13-circle-and-torus/camera.cam", .width = 60, .height = 30});
    const ObjectPixels ring = object_pixels(film, "ring");
    return {
        {"columns seen", sightings_of(film, "column ").seen, 13, 14},
        {"width of the ring in that of the picture",
         static_cast<double>(ring.max_x - ring.min_x) / static_cast<double>(film.width), 0.5, 0.9},
        {"share of plate 13's eye points in view", share_in_view(film, flight), 0.6, 1},
        {"share of the sky", share_of(film, "sky"), 0.2, 0.6}};
}

Property plate_12() {
    return {12, measure_temple_pinhole, {{{"distance", "15"}}, {{"pitch", "60deg"}}}};
}

}  // namespace balcony::plates
