// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <utility>
#include <vector>

#include "balcony/film.hpp"
#include "balcony/median.hpp"

namespace balcony::render {

namespace {

// Y of linear Rec. 709.
float luminance(const Color4f& c) { return 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b; }

}  // namespace

double automatic_exposure(const Film& film) {
    std::vector<double> luminances;
    for (std::size_t y = 0; y < film.window.height; ++y) {
        for (std::size_t x = 0; x < film.window.width; ++x) {
            const Color4f pixel = film.pixel(film.window.x + x, film.window.y + y);
            if (pixel.a > 0.0F) {
                luminances.push_back(static_cast<double>(luminance(pixel) / pixel.a));
            }
        }
    }
    constexpr double too_dark = 0.004;  // Level 13 of 255 in sRGB.
    constexpr double too_bright = 2.0;  // A stop above white.
    constexpr double middle_grey = 0.18;
    const double middle = median(std::move(luminances)).value_or(0.0);
    if (!(middle > 0.0) || (too_dark < middle && middle < too_bright)) {
        return 0.0;
    }
    return std::round(2.0 * std::log2(middle_grey / middle)) / 2.0;
}

}  // namespace balcony::render
