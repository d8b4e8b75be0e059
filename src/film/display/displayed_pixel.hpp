// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/film.hpp"

namespace balcony::render {

struct DisplayedPixel {
    Color4f color;     ///< Linear, premultiplied.
    bool lit = false;  ///< Whether light contributes, and not only display colours.
};

/// A pixel of the window as a picture file shows it: light after exposure (a factor) and view
/// transform, and display colours, over the film's background.
[[nodiscard]] DisplayedPixel displayed_pixel(const Film& film, std::size_t x, std::size_t y,
                                             float gain, ViewTransform view);

/// A premultiplied colour over the film's background.
[[nodiscard]] Color4f over_background(const Film& film, const Color4f& color);

}  // namespace balcony::render
