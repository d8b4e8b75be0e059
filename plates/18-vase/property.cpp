// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "balcony/median.hpp"
#include "measure/measure.hpp"
#include "measure/property.hpp"

namespace balcony::plates {

// The strip shows the vase all round in one piece, everywhere at nearly the same scale.
static Measurements measure_vase(Studio& studio, const Overrides& overrides) {
    const auto look = [&](std::size_t scale) {
        return studio.look({.scene = "vase",
                            .camera = "18-vase/camera.cam",
                            .name = "unrolled",
                            .width = 398 * scale,
                            .height = 100 * scale},
                           overrides);
    };
    const render::Film film = look(1);
    const ObjectPixels vase = object_pixels(film, "vase");
    const auto& position = film.layers->position;

    constexpr std::size_t directions = 180;  // From the axis of the vase.
    std::vector<bool> seen(directions, false);
    std::vector<double> anisotropy;
    std::vector<double> areas;
    for (std::size_t y = 0; y + 1 < film.height; ++y) {
        for (std::size_t x = 0; x + 1 < film.width; ++x) {
            const std::size_t i = y * film.width + x;
            const scene::V3d at(position[i]);
            const double part = std::atan2(at.y, at.x) / (2.0 * std::numbers::pi) + 0.5;
            seen[std::min(static_cast<std::size_t>(part * directions), directions - 1)] = true;
            const scene::V3d right = scene::V3d(position[i + 1]) - at;
            const scene::V3d down = scene::V3d(position[i + film.width]) - at;
            // In the plane of the surface: along `right`, and across it.
            const scene::V3d along = right.normalized();
            const double shear = down.dot(along);
            const double across = (down - along * shear).length();
            anisotropy.push_back(singular_ratio(right.length(), shear, 0.0, across));
            areas.push_back(right.length() * across);
        }
    }
    const double pixels = static_cast<double>(film.width * film.height);
    const RayStep coarse = max_step(film);
    const RayStep fine = max_step(look(2));
    const double middle_area = median(areas).value_or(0.0);
    const auto tenth = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 10);
    std::nth_element(areas.begin(), tenth, areas.end());
    return {
        {"share of the circumference",
         static_cast<double>(std::count(seen.begin(), seen.end(), true)) / directions, 1, 1},
        {"share of the strip that shows the vase", static_cast<double>(vase.pixels) / pixels, 1, 1},
        {"regions of the vase", vase.regions, 1, 1},
        {"median anisotropy", median(std::move(anisotropy)).value_or(0.0), 1, 1.1},
        {"area in a pixel that nine of ten exceed, relative to the median one",
         *tenth / middle_area, 0.8},
        {"longest step of origins at twice the resolution", fine.origin / coarse.origin, 0, 0.6},
        {"longest step of directions at twice the resolution", fine.direction / coarse.direction, 0,
         0.6}};
}

Property plate_18() {
    return {18,
            measure_vase,
            {{{"turn", "340deg"}}, {{"high", "0.9"}}, {{"low", "0"}}, {{"distance", "-1"}}}};
}

}  // namespace balcony::plates
