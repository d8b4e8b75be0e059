// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "film/denoise/planes.hpp"

namespace balcony::render {

namespace {

struct Sum {
    float operator()(float a, float b) const { return a + b; }
};
struct Maximum {
    float operator()(float a, float b) const { return std::max(a, b); }
};

template <class Combine>
void combine_into(float* __restrict to, const float* __restrict from, std::size_t count) {
    for (std::size_t x = 0; x < count; ++x) {
        to[x] = Combine()(to[x], from[x]);
    }
}

// First along the rows, then along the columns.
template <class Combine>
Plane combined(const Plane& plane, std::size_t radius, const Canvas& canvas) {
    const std::size_t width = canvas.width;
    Plane along = plane;
    for_each_row(canvas, [&](std::size_t y) {
        const float* const from = plane.data() + y * width;
        float* const to = along.data() + y * width;
        for (std::size_t step = 1; step <= std::min(radius, width - 1); ++step) {
            combine_into<Combine>(to + step, from, width - step);
            combine_into<Combine>(to, from + step, width - step);
        }
    });
    Plane made = along;
    for_each_row(canvas, [&](std::size_t y) {
        float* const to = made.data() + y * width;
        for (std::size_t step = 1; step <= radius; ++step) {
            if (y >= step) {
                combine_into<Combine>(to, along.data() + (y - step) * width, width);
            }
            if (y + step < canvas.height) {
                combine_into<Combine>(to, along.data() + (y + step) * width, width);
            }
        }
    });
    return made;
}

}  // namespace

Plane box_mean(const Plane& plane, std::size_t radius, const Canvas& canvas) {
    Plane made = combined<Sum>(plane, radius, canvas);
    const auto within = [radius](std::size_t at, std::size_t side) {
        return static_cast<float>(std::min(at + radius, side - 1) - (at - std::min(at, radius)) +
                                  1);
    };
    for_each_row(canvas, [&](std::size_t y) {
        for (std::size_t x = 0; x < canvas.width; ++x) {
            made[y * canvas.width + x] /= within(x, canvas.width) * within(y, canvas.height);
        }
    });
    return made;
}

Plane box_maximum(const Plane& plane, std::size_t radius, const Canvas& canvas) {
    return combined<Maximum>(plane, radius, canvas);
}

}  // namespace balcony::render
