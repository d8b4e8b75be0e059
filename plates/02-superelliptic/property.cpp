// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include "measure/measure.hpp"
#include "measure/property.hpp"
#include "scenes/gallery/measure_gallery.hpp"

namespace balcony::plates {

// All seven pictures wholly visible and nearly undistorted. An ellipsoid would do by anisotropy
// alone in this room, but it bends edges by several per cent of a picture's diagonal.
//
// Twice the resolution halves the steps between neighbouring rays where the camera is continuous,
// and leaves a jump as it is. Corners bend fast, so that they are not quite halved. The room is
// closed, so that no pixel is empty: normals of nearly flat walls run along the axes but for a
// hair, which ray tracing kernels can trip over.
static Measurements measure_superelliptic(Studio& studio, const Overrides& overrides) {
    const auto look = [&](std::size_t scale) {
        return studio.look({.scene = "gallery",
                            .camera = "02-superelliptic/camera.cam",
                            .width = 1000 * scale,
                            .height = 200 * scale},
                           overrides);
    };
    const render::Film film = look(1);
    const GalleryView view = view_gallery(studio.scene("gallery"), film);
    const RayStep coarse = max_step(film);
    const RayStep fine = max_step(look(2));
    const auto& ids = film.layers->object;
    return {
        {"pictures wholly visible", view.wholly_visible, 7},
        {"pictures in one region", view.connected, 7},
        {"median anisotropy", view.median_anisotropy, 1, 1.25},
        {"largest bend of a picture, in diagonals", view.most_bent, 0, 0.015},
        {"longest step of origins at twice the resolution", fine.origin / coarse.origin, 0, 0.6},
        {"longest step of directions at twice the resolution", fine.direction / coarse.direction, 0,
         0.6},
        {"pixels that show nothing", std::count(ids.begin(), ids.end(), 0U), 0, 0}};
}

Property plate_02() { return {2, measure_superelliptic, {{{"gamma", "1"}}, {{"a", "20"}}}}; }

}  // namespace balcony::plates
