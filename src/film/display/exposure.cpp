// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "balcony/film.hpp"
#include "balcony/median.hpp"
#include "film/sums/film_arrays.hpp"
#include "images/luminance.hpp"

namespace balcony::render {

double automatic_exposure(const Film& film) {
    if (!check_sizes(film).empty()) {
        return 0.0;
    }
    std::vector<double> luminances;  // Of what is lit.
    for (std::size_t y = 0; y < film.window.height; ++y) {
        for (std::size_t x = 0; x < film.window.width; ++x) {
            const Color4f light = film.surface_light(film.window.x + x, film.window.y + y);
            if (light.a > 0.0F && luminance(light) > 0.0F) {
                luminances.push_back(static_cast<double>(luminance(light) / light.a));
            }
        }
    }
    constexpr double too_dark = 0.01;   // Level 25 of 255 in sRGB.
    constexpr double too_bright = 2.0;  // A stop above white.
    constexpr double brightest_highlights = 4.0;
    constexpr double middle_grey = 0.18;
    constexpr double white = 1.0;
    if (luminances.empty()) {
        return 0.0;
    }
    const auto highlight =
        luminances.begin() + static_cast<std::ptrdiff_t>((luminances.size() - 1) * 95 / 100);
    std::nth_element(luminances.begin(), highlight, luminances.end());
    const double bright = *highlight;
    const double middle = *median(std::move(luminances));
    if (too_dark < middle && middle < too_bright && bright <= brightest_highlights) {
        return 0.0;
    }
    // A bright part, such as a ceiling next to its lamp, does not darken all the rest.
    constexpr double max_stops_for_highlights = 2.0;
    const double for_middle = std::log2(middle_grey / middle);
    const double for_highlights = std::log2(white / bright);
    const double stops =
        std::clamp(for_highlights, for_middle - max_stops_for_highlights, for_middle);
    return std::round(4.0 * stops) / 4.0;
}

}  // namespace balcony::render
