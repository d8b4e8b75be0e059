// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <vector>

#include "scenes/corner/measure_corner.hpp"

namespace balcony::plates {

// Of equal cells of the parameters that a film shows, those that another one shows too.
static double share_still_seen(const render::Film& whole, const render::Film& zoomed) {
    constexpr std::size_t columns = 78;
    constexpr std::size_t rows = 30;
    const auto& places = whole.layers->parameters;
    const scene::V2f first = places.front();
    const scene::V2f extent = places.back() - first;
    std::vector<bool> seen(columns * rows, false);
    for (const scene::V2f& place : zoomed.layers->parameters) {
        const scene::V2f part = (place - first) / extent;
        if (part.x >= 0.0F && part.x <= 1.0F && part.y >= 0.0F && part.y <= 1.0F) {
            const auto column = static_cast<std::size_t>(part.x * (columns - 1) + 0.5F);
            const auto row = static_cast<std::size_t>(part.y * (rows - 1) + 0.5F);
            seen[row * columns + column] = true;
        }
    }
    return static_cast<double>(std::count(seen.begin(), seen.end(), true)) /
           static_cast<double>(seen.size());
}

// The smallest Jacobian of the parameters over the picture, relative to their mean one; it is
// negative where the picture folds over.
static double smallest_jacobian(const render::Film& film) {
    const auto& places = film.layers->parameters;
    double smallest = std::numeric_limits<double>::infinity();
    double sum = 0.0;
    for (std::size_t y = 0; y + 1 < film.height; ++y) {
        for (std::size_t x = 0; x + 1 < film.width; ++x) {
            const std::size_t i = y * film.width + x;
            const scene::V2f right = places[i + 1] - places[i];
            const scene::V2f up = places[i] - places[i + film.width];
            const double jacobian = right.x * up.y - right.y * up.x;
            smallest = std::min(smallest, jacobian);
            sum += jacobian;
        }
    }
    return smallest * static_cast<double>((film.width - 1) * (film.height - 1)) / sum;
}

// As in Escher's "Balcony": a part swells, and nothing of the rest is lost.
static Measurements measure_hyperbolic_zoom(Studio& studio, const Overrides& overrides) {
    const scene::Scene& corner = studio.scene("corner");
    const render::Film whole = look_at_corner(studio, "10-hyperbolic-cylinder/camera.cam", {});
    const render::Film zoomed =
        look_at_corner(studio, "11-hyperbolic-zoom/camera.cam", overrides, 2);
    const CornerView before = view_corner(corner, whole);
    const CornerView view = view_corner(corner, zoomed);
    const double gain =
        static_cast<double>(view.pixels[3]) / 4.0 / static_cast<double>(before.pixels[3]);
    return {{"pictures wholly visible", view.wholly_visible, 4, 4},
            {"area of the plant, relative to plate 10", gain, 1.5},
            {"share of what plate 10 shows", share_still_seen(whole, zoomed), 1, 1},
            {"smallest Jacobian of the parameters, relative to their mean",
             smallest_jacobian(zoomed), 1e-3}};
}

Property plate_11() {
    return {11,
            measure_hyperbolic_zoom,
            {{{"strength", "1.2"}}, {{"at_u", "1.35"}}, {{"strength", "0.3"}}}};
}

}  // namespace balcony::plates
