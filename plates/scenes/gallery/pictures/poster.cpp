// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "scenes/gallery/paintings.hpp"

namespace balcony::plates {

namespace {

// Letters are signed distances (negative inside), in a cell whose middle is the origin.
constexpr double letter_half_height = 0.66;
constexpr double letter_half_width = 0.142;
constexpr double letter_stroke = 0.094;
constexpr double pitch = 0.334;

double rectangle(const V2d& p, const V2d& low, const V2d& high) {
    const V2d d(std::max(low.x - p.x, p.x - high.x), std::max(low.y - p.y, p.y - high.y));
    return std::hypot(std::max(d.x, 0.0), std::max(d.y, 0.0)) + std::min(std::max(d.x, d.y), 0.0);
}

// The outline, one stroke wide, of a rectangle with round corners; low and high are its outside.
double ring(const V2d& p, const V2d& low, const V2d& high) {
    constexpr double corner = 0.075;
    const V2d in(letter_stroke / 2.0 + corner, letter_stroke / 2.0 + corner);
    return std::abs(rectangle(p, low + in, high - in) - corner) - letter_stroke / 2.0;
}

double segment(const V2d& p, const V2d& from, const V2d& to) {
    const V2d along = to - from;
    const double t = std::clamp((p - from).dot(along) / along.length2(), 0.0, 1.0);
    return (p - from - along * t).length() - letter_stroke / 2.0;
}

const V2d low(-letter_half_width, -letter_half_height);
const V2d high(letter_half_width, letter_half_height);

double stem(const V2d& p, double left) {
    return rectangle(p, {left, low.y}, {left + letter_stroke, high.y});
}

double letter_b(const V2d& p) {
    constexpr double waist = 0.05;
    return std::min({stem(p, low.x),
                     ring(p, {low.x, waist - letter_stroke / 2.0}, {high.x - 0.012, high.y}),
                     ring(p, low, {high.x, waist + letter_stroke / 2.0}),
                     rectangle(p, {low.x, high.y - letter_stroke}, {0.0, high.y}),
                     rectangle(p, low, {0.0, low.y + letter_stroke})});
}

double letter_a(const V2d& p) {
    const double arch = std::max(ring(p, low - V2d(0.0, 0.5), high), low.y - p.y);
    return std::min(arch, rectangle(p, {low.x, -0.24}, {high.x, -0.24 + letter_stroke}));
}

double letter_l(const V2d& p) {
    return std::min(stem(p, low.x), rectangle(p, low, {high.x, low.y + letter_stroke}));
}

double letter_c(const V2d& p) {
    return std::max(ring(p, low, high), -rectangle(p, {0.0, -0.24}, {1.0, 0.24}));
}

double letter_o(const V2d& p) { return ring(p, low, high); }

double letter_n(const V2d& p) {
    const double slant = segment(p, {low.x + 0.02, high.y + 0.06}, {high.x - 0.02, low.y - 0.06});
    return std::min({stem(p, low.x), stem(p, high.x - letter_stroke),
                     std::max(slant, rectangle(p, low, high))});
}

double letter_y(const V2d& p) {
    const V2d fork(0.0, -0.08);
    const double arms = std::min(segment(p, {-0.098, high.y + 0.05}, fork),
                                 segment(p, {0.098, high.y + 0.05}, fork));
    return std::min(std::max(arms, p.y - high.y),
                    stem({p.x, std::max(p.y, -0.65)}, -letter_stroke / 2.0) +
                        (p.y > fork.y ? p.y - fork.y : 0.0));
}

double word(const V2d& p) {
    using Letter = double (*)(const V2d&);
    constexpr Letter letters[] = {letter_b, letter_a, letter_l, letter_c,
                                  letter_o, letter_n, letter_y};
    const int nearest = int(std::lround(p.x / pitch)) + 3;
    double minimum = 1e9;
    for (int n = std::max(nearest - 1, 0); n <= std::min(nearest + 1, 6); ++n) {
        minimum = std::min(minimum, letters[n]({p.x - (n - 3) * pitch, p.y}));
    }
    return std::max(minimum, std::abs(p.y) - letter_half_height);
}

// The local zoom of the picture: what is seen at p stands at the returned point of the flat poster.
constexpr double zoom_radius = 1.02;
constexpr double zoom_strength = 0.56;

double zoom_height(const V2d& p) {
    const V2d q(p.x / 1.12, p.y);
    return std::pow(std::max(0.0, 1.0 - q.length2() / (zoom_radius * zoom_radius)), 2);
}

V2d flat_from_zoomed(const V2d& p) { return p * (1.0 - zoom_strength * zoom_height(p)); }

// Two families of waving lines; where they meet, they make a moire.
double guilloche(const V2d& q) {
    const double first = q.y * 31.0 + 1.3 * std::sin(q.x * 7.0) + 0.6 * std::sin(q.x * 17.0 + 1.0);
    const double second = q.y * 31.0 - 1.3 * std::sin(q.x * 7.0 + 0.9) + 3.0 * q.x;
    const auto line = [](double phase) {
        return smooth_step(0.36, 0.24, std::abs(phase - std::floor(phase) - 0.5) * 2.0);
    };
    return std::max(line(first), 0.6 * line(second));
}

}  // namespace

Color poster(const Sample& sample) {
    static const Gradient ground({0xf0a33c, 0xe0592f, 0xb02a4c, 0x4b2468, 0x1a2360, 0x0d1740});
    static const Color ivory = from_srgb(0xfff4dc);
    static const Color night = from_srgb(0x0c1030);

    const V2d p = sample.point;
    const V2d q = flat_from_zoomed(p);
    const double distance = V2d(p.x / 1.15, p.y).length();

    // The swelling is lit from the upper left.
    constexpr double step = 1e-3;
    const double slope_x = (zoom_height(p + V2d(step, 0)) - zoom_height(p - V2d(step, 0))) / step;
    const double slope_y = (zoom_height(p + V2d(0, step)) - zoom_height(p - V2d(0, step))) / step;
    const double light = 1.0 + 0.09 * (slope_x - 1.2 * slope_y);

    Color color = ground(distance * 0.95);
    color = mix(color, color * 0.25 + ground(distance * 0.95 - 0.35) * 0.75, guilloche(q));
    color *= std::clamp(light, 0.35, 1.5);

    const double shade = word(q + V2d(-0.020, 0.026));
    color = mix(color, night, 0.72 * smooth_step(0.012, -0.012, shade));
    const double ink = word(q);
    if (ink < 0.0) {
        color = ivory * std::clamp(0.5 + 0.5 * light, 0.6, 1.0);
        const double inline_edge = std::abs(ink + 0.016);
        color = mix(from_srgb(0xd6402b), color, smooth_step(0.002, 0.0035, inline_edge));
    } else if (ink < 0.007) {
        color = night;
    }
    // A border holds the poster together: paper outside, one fine line inside.
    const double rim = std::min(1.25 - std::abs(p.x), 1.0 - std::abs(p.y));
    if (rim < 0.04 || (rim > 0.055 && rim < 0.061)) {
        color = ivory * 0.97;
    }
    return color;
}

}  // namespace balcony::plates
