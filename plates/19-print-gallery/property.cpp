// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <fmt/format.h>

#include "measure/measure.hpp"
#include "measure/property.hpp"
#include "scenes/print_gallery/print_gallery.hpp"

namespace balcony::plates {

namespace print_gallery_plate {

using namespace print_gallery;
using Complex = std::complex<double>;

// The point that the straight picture and its copy in the print have in common.
constexpr Complex common(common_y, common_z);

// The picture repeats under the power map if it is scaled and rotated by this (de Smit and
// Lenstra).
Complex period() {
    const Complex turn(0.0, 2.0 * std::numbers::pi);
    return std::exp(turn * turn / (turn + std::log(picture_scale)));
}

render::Film look(Studio& studio, Overrides overrides, std::size_t width,
                  const Complex& scaled = 1.0) {
    overrides.push_back({"turn", fmt::format("{}rad", std::arg(scaled))});
    overrides.push_back({"zoom", fmt::format("{}", std::abs(scaled))});
    return studio.look({.scene = "print_gallery",
                        .camera = "19-print-gallery/camera.cam",
                        .name = "print_gallery",
                        .width = width,
                        .height = width * 3 / 4},
                       overrides);
}

// Where a pixel looks in the straight picture, to the left and upwards, from the common point.
Complex place(const render::Film& film, std::size_t pixel) {
    const scene::V3d d(film.layers->direction[pixel]);
    return Complex(d.y / d.x, d.z / d.x) - common;
}

// How far it is to the edge of the straight picture.
double to_edge(const Complex& place) {
    const Complex p = place + common;
    return std::fabs(std::max(std::fabs(p.real()) - half_width, std::fabs(p.imag()) - half_height));
}

struct Steps {
    double longest = 0.0;  ///< In the straight picture, whose print shows the whole picture again.
    double from_edge = 0.0;  ///< How far from the edge of the picture or its print rays jump.
    std::size_t jumps = 0;
};

// From each pixel to its neighbours. In the innermost pixels, all steps are long.
Steps steps_of(const render::Film& film) {
    constexpr double innermost = 0.1;
    constexpr double jump = 0.3;
    Steps steps;
    const auto compare = [&](std::size_t a, std::size_t b) {
        const Complex from = place(film, a);
        const Complex to = place(film, b);
        const double step = std::abs(to - from);
        const double into_print = std::abs(to / picture_scale - from);
        const double out_of_print = std::abs(to - from / picture_scale);
        steps.longest = std::max(steps.longest, std::min({step, into_print, out_of_print}));
        if (step > jump) {
            ++steps.jumps;
            steps.from_edge = std::max(steps.from_edge, std::min(to_edge(from), to_edge(to)));
        }
    };
    const double width = static_cast<double>(film.width);
    for (std::size_t y = 0; y + 1 < film.height; ++y) {
        for (std::size_t x = 0; x + 1 < film.width; ++x) {
            const double right = (static_cast<double>(x) + 0.5) / width - 0.5;
            const double down = (static_cast<double>(y) + 0.5) / width - 0.375;
            if (std::hypot(right, down) > innermost) {
                const std::size_t i = y * film.width + x;
                compare(i, i + 1);
                compare(i, i + film.width);
            }
        }
    }
    return steps;
}

// Of two pictures, the share of pixels that look elsewhere. Along the edge of the print, rounding
// decides which side of it a pixel sees.
double share_elsewhere(const render::Film& first, const render::Film& second) {
    std::size_t elsewhere = 0;
    const std::size_t pixels = first.width * first.height;
    for (std::size_t i = 0; i < pixels; ++i) {
        elsewhere += std::abs(place(first, i) - place(second, i)) > 1e-4 ? 1U : 0U;
    }
    return static_cast<double>(elsewhere) / static_cast<double>(pixels);
}

Measurements measure(Studio& studio, const Overrides& overrides) {
    const render::Film film = look(studio, overrides, 400);
    const render::Film turned = look(studio, overrides, 400, period());
    const Steps coarse = steps_of(film);
    const Steps fine = steps_of(look(studio, overrides, 800));
    return {{"share of pixels that look elsewhere in the picture turned and scaled by its period",
             share_elsewhere(film, turned), 0, 1e-3},
            {"longest step in the gallery that contains itself, at twice the resolution",
             fine.longest / coarse.longest, 0, 0.6},
            {"farthest from the edge of the print that rays jump, in units of the wall's distance",
             fine.from_edge, 0, 0.02},
            {"pixels that show the paper in the print's place", object_pixels(film, "print").pixels,
             0, 0},
            {"times that the picture shows the visitor's hat",
             object_pixels(film, "visitor hat").regions, 2}};
}

}  // namespace print_gallery_plate

Property plate_19() {
    return {19, print_gallery_plate::measure, {{{"scale", "12"}}, {{"scale", "20"}}}};
}

}  // namespace balcony::plates
