// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include "measure/measure.hpp"
#include "measure/property.hpp"
#include "scenes/temple/measure_temple.hpp"

namespace balcony::plates {

// The share of a picture's columns of pixels whose rays start where a condition holds; all rays of
// one start at one point.
template <class Condition>
static double share_of_origins(const render::Film& film, const Condition& holds) {
    const auto& origins = film.layers.value().origin;
    const auto end = origins.begin() + static_cast<std::ptrdiff_t>(film.width);
    const auto count = std::count_if(
        origins.begin(), end, [&](const scene::V3f& origin) { return holds(scene::V3d(origin)); });
    return static_cast<double>(count) / static_cast<double>(film.width);
}

// The eye enters the temple below an arch, without touching a column, and leaves it above the ring.
static Measurements measure_flight(Studio& studio, const Overrides& overrides) {
    const scene::Scene& scene = studio.scene("temple");
    const render::Film film = studio.look({.scene = "temple",
                                           .camera = "13-circle-and-torus/camera.cam",
                                           .width = 320,
                                           .height = 160},
                                          overrides);
    const Extent arch = extent_of(scene, "arch 1");
    const Extent ring = extent_of(scene, "ring");
    const double below = share_of_origins(film, [&](const scene::V3d& origin) {
        return !arch.about(origin) && arch.max_r > std::hypot(origin.x, origin.y) &&
               origin.z < arch.min_z;
    });
    const double under_arch = share_of_origins(film, [&](const scene::V3d& origin) {
        return arch.about(origin) && origin.z < arch.min_z;
    });
    const double above = share_of_origins(film, [&](const scene::V3d& origin) {
        return ring.about(origin) && origin.z > ring.max_z;
    });
    const double inside = share_of_origins(film, [&](const scene::V3d& origin) {
        return ring.about(origin) && origin.z > ring.min_z && origin.z < ring.max_z;
    });
    const RayStep step = max_step(film);
    return {{"share of origins inside the temple, below the arches", below, 0.2},
            {"share of origins in the opening of an arch", under_arch, 0.01},
            {"share of origins above the ring", above, 0.03},
            {"share of origins within the ring's stone", inside, 0, 0},
            {"clearance from the columns' axes, in metres", clearance(film), 0.7},
            {"columns seen", sightings_of(film, "column ").seen, 8},
            {"regions of the ring", object_pixels(film, "ring").regions, 1, 1},
            {"share of the sky", share_of(film, "sky"), 0.2, 0.5},
            {"longest step between neighbouring origins, in metres", step.origin, 0, 0.2}};
}

Property plate_13() {
    return {13,
            measure_flight,
            {{{"tilt", "0deg"}}, {{"tilt", "-30deg"}, {"height", "2"}}, {{"column", "1.5"}}}};
}

}  // namespace balcony::plates
