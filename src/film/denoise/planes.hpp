// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Images as planes of one value per pixel, row by row.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "base/parallel_for.hpp"

namespace balcony::render {

using Plane = std::vector<float>;

/// The size of planes, and the number of threads that work on them; 0 for all of the machine.
struct Canvas {
    std::size_t width = 0;
    std::size_t height = 0;
    std::size_t threads = 0;

    [[nodiscard]] std::size_t size() const { return width * height; }
};

/// Calls visit(y) for each row, in parallel.
template <class Visit>
void for_each_row(const Canvas& canvas, const Visit& visit) {
    parallel_for(canvas.height, visit, canvas.threads);
}

/// Calls visit(i) for each pixel, in parallel.
template <class Visit>
void for_each_pixel(const Canvas& canvas, const Visit& visit) {
    for_each_row(canvas, [&](std::size_t y) {
        for (std::size_t i = y * canvas.width; i < (y + 1) * canvas.width; ++i) {
            visit(i);
        }
    });
}

/// The means, or the largest, of the values within so many pixels in each direction.
[[nodiscard]] Plane box_mean(const Plane& plane, std::size_t radius, const Canvas& canvas);
[[nodiscard]] Plane box_maximum(const Plane& plane, std::size_t radius, const Canvas& canvas);

}  // namespace balcony::render
