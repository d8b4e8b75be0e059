// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A few points that are evenly distributed over a picture.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "balcony/film.hpp"
#include "balcony/rays.hpp"

namespace balcony::render {

/// About 2048 points.
[[nodiscard]] inline rays::Tile coarse_grid(const Film& film, double time) {
    constexpr double points = 2048.0;
    const auto width = static_cast<double>(film.width);
    const auto height = static_cast<double>(film.height);
    const double step = std::max(1.0, std::sqrt(width * height / points));
    const auto count = [step](double extent) {
        return static_cast<std::size_t>(std::max(1.0, std::round(extent / step)));
    };
    return {0.5 * step,         0.5 * step,         step, count(width), count(height), time,
            {0.5, width - 0.5}, {0.5, height - 0.5}};
}

}  // namespace balcony::render
