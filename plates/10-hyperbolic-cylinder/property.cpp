// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include "measure/measure.hpp"
#include "scenes/corner/measure_corner.hpp"

namespace balcony::plates {

// How often the walls meet in the row in which they meet most often, from the left one on the left
// to the right one on the right; 0 if anywhere they meet the other way round.
static std::size_t most_meetings(const render::Film& film) {
    const auto id_of_wall = [&](const char* name) {
        const auto place = std::find(film.objects.begin(), film.objects.end(), name);
        return static_cast<std::uint32_t>(place - film.objects.begin()) + 1;
    };
    const std::uint32_t left = id_of_wall("wall left");
    const std::uint32_t right = id_of_wall("wall right");
    const auto& ids = film.layers->object;
    std::size_t most = 0;
    for (std::size_t y = 0; y < film.height; ++y) {
        std::size_t meetings = 0;
        for (std::size_t i = y * film.width; i + 1 < (y + 1) * film.width; ++i) {
            if (ids[i] == right && ids[i + 1] == left) {
                return 0;
            }
            meetings += ids[i] == left && ids[i + 1] == right ? 1 : 0;
        }
        most = std::max(most, meetings);
    }
    return most;
}

// Each picture is larger than in plate 9, in pictures of one size, and nearly undistorted.
//
// Twice the resolution halves the steps between neighbouring rays where the camera is continuous,
// and leaves a jump as it is.
static Measurements measure_hyperbolic_cylinder(Studio& studio, const Overrides& overrides) {
    constexpr const char* camera = "10-hyperbolic-cylinder/camera.cam";
    const scene::Scene& corner = studio.scene("corner");
    const render::Film film = look_at_corner(studio, camera, overrides);
    const CornerView view = view_corner(corner, film);
    const CornerView pinhole =
        view_corner(corner, look_at_corner(studio, "09-corner/camera.cam", {}));
    double smallest_gain = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < view.pixels.size(); ++k) {
        smallest_gain = std::min(smallest_gain, static_cast<double>(view.pixels[k]) /
                                                    static_cast<double>(pinhole.pixels[k]));
    }
    const RayStep coarse = max_step(film);
    const RayStep fine = max_step(look_at_corner(studio, camera, overrides, 2));
    return {
        {"pictures wholly visible", view.wholly_visible, 4, 4},
        {"smallest area of a picture, relative to plate 9", smallest_gain, 1.5},
        {"median anisotropy", view.median_anisotropy, 1, 1.2},
        {"places where the walls meet, in a row of pixels", most_meetings(film), 1, 1},
        {"longest step of origins at twice the resolution", fine.origin / coarse.origin, 0, 0.6},
        {"longest step of directions at twice the resolution", fine.direction / coarse.direction, 0,
         0.6}};
}

Property plate_10() {
    return {10,
            measure_hyperbolic_cylinder,
            {{{"b", "1"}}, {{"reach", "1.7"}}, {{"before_walls", "1"}}}};
}

}  // namespace balcony::plates
