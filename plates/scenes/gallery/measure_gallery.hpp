// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/film.hpp"
#include "balcony/scene.hpp"

namespace balcony::plates {

/// How a picture shows the seven pictures of the gallery.
struct GalleryView {
    int wholly_visible = 0;
    int connected = 0;  ///< Those that are one region.
    double median_anisotropy = 0.0;
    double most_bent = 0.0;  ///< The largest View::bend.
};

[[nodiscard]] GalleryView view_gallery(const scene::Scene& gallery, const render::Film& film);

}  // namespace balcony::plates
