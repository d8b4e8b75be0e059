// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/gallery/measure_gallery.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "balcony/median.hpp"
#include "measure/measure.hpp"

namespace balcony::plates {

GalleryView view_gallery(const scene::Scene& gallery, const render::Film& film) {
    GalleryView gallery_view;
    std::vector<double> anisotropy;
    for (int number = 1; number <= 7; ++number) {
        const std::string name = fmt::format("picture {}", number);
        const View view = view_of(film, name, rectangle_of(gallery, name));
        gallery_view.wholly_visible += view.share_seen == 1.0 ? 1 : 0;
        gallery_view.connected += view.regions == 1 ? 1 : 0;
        gallery_view.most_bent = std::max(gallery_view.most_bent, view.bend);
        anisotropy.insert(anisotropy.end(), view.anisotropy.begin(), view.anisotropy.end());
    }
    gallery_view.median_anisotropy = median(std::move(anisotropy)).value_or(0.0);
    return gallery_view;
}

}  // namespace balcony::plates
