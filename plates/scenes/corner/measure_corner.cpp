// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/corner/measure_corner.hpp"

#include <fmt/format.h>

#include "balcony/median.hpp"
#include "measure/measure.hpp"

namespace balcony::plates {

CornerView view_corner(const scene::Scene& corner, const render::Film& film) {
    CornerView corner_view;
    std::vector<double> anisotropy;
    for (std::size_t k = 0; k < corner_view.pixels.size(); ++k) {
        const std::string picture = fmt::format("picture {}", k + 1);
        const View view = view_of(film, picture, rectangle_of(corner, picture));
        corner_view.pixels[k] = view.pixels;
        corner_view.wholly_visible += view.regions == 1 && view.share_seen == 1.0 ? 1 : 0;
        anisotropy.insert(anisotropy.end(), view.anisotropy.begin(), view.anisotropy.end());
    }
    corner_view.median_anisotropy = median(std::move(anisotropy)).value_or(0.0);
    return corner_view;
}

render::Film look_at_corner(Studio& studio, const char* camera, const Overrides& overrides,
                            std::size_t scale) {
    return studio.look(
        {.scene = "corner", .camera = camera, .width = 390 * scale, .height = 150 * scale},
        overrides);
}

}  // namespace balcony::plates
