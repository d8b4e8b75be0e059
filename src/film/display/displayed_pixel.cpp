// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "film/display/displayed_pixel.hpp"

#include <algorithm>

namespace balcony::render {

Color4f over_background(const Film& film, const Color4f& color) {
    if (!film.background) {
        return color;
    }
    const float rest = 1.0F - std::clamp(color.a, 0.0F, 1.0F);
    const Color3f& behind = *film.background;
    return {color.r + rest * behind.x, color.g + rest * behind.y, color.b + rest * behind.z, 1.0F};
}

// Colours divided by alpha pass the view transform, so that the edge of a bright object in front of
// nothing is as smooth as that of a dark one.
DisplayedPixel displayed_pixel(const Film& film, std::size_t x, std::size_t y, float gain,
                               ViewTransform view) {
    const Color4f light = film.light(x, y);
    Color4f shown = film.display_color(x, y);
    const bool lit = light.a > 0.0F;
    if (lit) {
        const float scale = gain / light.a;
        const Color3f color =
            light.a * displayed(view, {light.r * scale, light.g * scale, light.b * scale});
        shown += Color4f(color.x, color.y, color.z, light.a);
    }
    return {over_background(film, shown), lit};
}

}  // namespace balcony::render
