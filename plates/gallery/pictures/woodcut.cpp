// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "gallery/paintings.hpp"

namespace balcony::plates {

namespace {

constexpr double shore = -0.52;  // Height of the water's far edge.
const V2d sun_middle(0.42, 0.30);
constexpr double sun_radius = 0.30;

struct Ridge {
    double base;       // Mean height of the crest.
    double roughness;  // Height of its hills.
    double size;       // Width of its hills.
    std::uint32_t crest;
    std::uint32_t foot;  // Colour in the mist at its foot.
    std::uint32_t seed;
};

const Ridge ridges[] = {
    {0.13, 0.30, 0.95, 0x9db4c0, 0xf3dfc2, 11},
    {-0.03, 0.32, 0.80, 0x6f93ad, 0xefd9bd, 23},
    {-0.20, 0.30, 0.60, 0x44709a, 0xd9d5c6, 37},
    {-0.35, 0.26, 0.50, 0x25507f, 0xa9c0c4, 51},
};

// A mountain apart from the ridges: a cone with concave flanks and a broken, snowy top.
double peak_height(double x) {
    const double away = std::abs(x + 0.62);
    const double flank = 0.86 * std::exp(-1.75 * std::max(away, 0.085)) - 0.26;
    return flank + 0.02 * noise(V2d(x * 14.0, 0.5), 3) * smooth_step(0.5, 0.0, away) ;
}

double crest(const Ridge& ridge, double x) {
    const double sharp = 1.0 - std::abs(noise(V2d(x / ridge.size, 7.3), ridge.seed));
    return ridge.base + ridge.roughness * (0.55 * (sharp - 0.5) +
                                           0.5 * fractal_noise(V2d(x / ridge.size * 1.7, 2.1), 5,
                                                               ridge.seed + 100));
}

// Graded bands of printed colour: paper warm at the horizon, indigo along the upper edge.
Color sky(const V2d& point) {
    static const Gradient graded({0xf7e3bf, 0xf6d5a4, 0xeec08f, 0xd9c9b0, 0x9fbcc0, 0x5b8da8, 0x1d4778,
                                  0x122a5c});
    Color color = graded((point.y + 0.25) / 1.25);
    const double from_sun = (point - sun_middle).length();
    if (from_sun < sun_radius) {
        static const Gradient red({0xf0803c, 0xd8402a, 0xc22d2b});
        color = red(0.5 + 0.5 * (point.y - sun_middle.y) / sun_radius);
    }
    return color;
}

// Long bands of mist with round ends, drawn across the sun as woodcuts do.
double band(const V2d& point, const V2d& middle, double half_length, double half_height) {
    const double beyond = std::max(std::abs(point.x - middle.x) - half_length, 0.0);
    return half_height - std::hypot(beyond, point.y - middle.y);
}

Color with_bands(const V2d& point, Color color) {
    struct Band {
        V2d middle;
        double half_length;
        double half_height;
    };
    static const Band bands[] = {
        {{0.72, 0.235}, 0.42, 0.022}, {{0.30, 0.165}, 0.50, 0.026}, {{1.05, 0.62}, 0.36, 0.030},
        {{0.74, 0.575}, 0.30, 0.022}, {{-1.15, 0.70}, 0.40, 0.030}, {{-0.88, 0.645}, 0.26, 0.022},
        {{-0.05, 0.82}, 0.30, 0.022},
    };
    static const Color paper = from_srgb(0xf8ead0);
    for (const Band& b : bands) {
        const double depth = band(point, b.middle, b.half_length, b.half_height);
        if (depth > 0.0) {
            color = mix(paper, color, 0.35 * smooth_step(0.0, 2.0 * b.half_height,
                                                        point.y - b.middle.y + b.half_height));
        }
    }
    return color;
}

constexpr double ink_width = 0.0045;
const Color ink = from_srgb(0x101b3a);

Color mountains(const V2d& point, Color color) {
    const double peak = peak_height(point.x);
    if (point.y < peak) {
        static const Gradient body({0xf4ddc0, 0xb9b6b8, 0x5f7fa6, 0x35598c, 0x27497c});
        const double snow = 0.33 + 0.075 * noise(V2d(point.x * 16.0, 1.0), 8) +
                            0.04 * noise(V2d(point.x * 41.0, 2.0), 9);
        color = point.y > snow ? from_srgb(0xfbf6ea) * (point.x > -0.60 ? 1.0 : 0.86)
                               : body((point.y + 0.22) / 0.62);
        color = peak - point.y < ink_width ? ink : color;
    }
    for (const Ridge& ridge : ridges) {
        const double top = crest(ridge, point.x);
        if (point.y < top) {
            const double depth = (top - point.y) / 0.34;
            color = mix(from_srgb(ridge.crest), from_srgb(ridge.foot), smooth_step(0.0, 1.0, depth));
            color = top - point.y < ink_width ? mix(ink, from_srgb(ridge.crest), 0.25) : color;
        }
    }
    return color;
}

// Water: what stands above it, upside down and broken into strokes, under a blue that deepens.
Color lake(const V2d& point) {
    const double depth = shore - point.y;
    const double stroke = noise(V2d(point.x * 3.5, depth * (95.0 - 60.0 * depth)), 61);
    const V2d mirrored(point.x + 0.03 * stroke * (0.3 + 2.0 * depth), shore + depth * 1.9);
    static const Gradient water({0xe9d3b4, 0x8fb3ba, 0x3d7796, 0x1b467a, 0x12295a});
    Color color = water(depth / 0.48 + 0.05 * stroke);
    const double from_sun = std::abs(point.x - sun_middle.x + 0.05 * stroke) /
                            (0.09 + 0.32 * depth);
    if (stroke > -0.05 + 0.35 * from_sun && from_sun < 1.0) {
        color = mix(color, from_srgb(0xe4583a), 0.85);
    } else if (stroke > 0.52) {
        color = mix(color, mountains(mirrored, sky(mirrored)), 0.45);
    }
    return color;
}

// A pine's shelf-like clouds of needles on a bent trunk, in flat dark colour.
bool in_pine(V2d point) {
    const V2d root(-1.18, -1.05);
    const V2d p = point - root;
    const double bend = 0.16 * std::sin(p.y * 2.6) - 0.05;
    const double trunk = 0.036 - 0.018 * p.y + 0.006 * noise(p * 30.0, 70);
    if (p.y < 1.28 && std::abs(p.x - bend) < trunk) {
        return true;
    }
    struct Shelf {
        V2d middle;
        double half_length;
        double half_height;
    };
    static const Shelf shelves[] = {
        {{0.32, 0.62}, 0.34, 0.065},  {{-0.22, 0.82}, 0.27, 0.062}, {{0.30, 0.98}, 0.26, 0.058},
        {{-0.10, 1.17}, 0.24, 0.055}, {{0.10, 1.33}, 0.19, 0.055},
    };
    const double ragged = 0.30 * fractal_noise(p * 16.0, 3, 71);
    return std::any_of(std::begin(shelves), std::end(shelves), [&](const Shelf& shelf) {
        const V2d q((p.x - shelf.middle.x) / shelf.half_length,
                    (p.y - shelf.middle.y) / shelf.half_height);
        const double flat = q.y < 0 ? 2.2 : 1.0;
        return q.x * q.x + flat * q.y * q.y < 1.0 + ragged;
    });
}

Color foreground(const V2d& point, Color color) {
    const double bank = -0.90 + 0.09 * noise(V2d(point.x * 1.3, 0.0), 81) - 0.14 * point.x / 1.5 +
                        0.015 * fractal_noise(V2d(point.x * 24.0, 3.0), 3, 82);
    if (in_pine(point)) {
        const double lift = fractal_noise(point * 15.0, 3, 84);
        return mix(from_srgb(0x0f2340), from_srgb(0x24506a), smooth_step(0.0, 0.5, lift));
    }
    if (point.y < bank) {
        return mix(from_srgb(0x16324f), from_srgb(0x0b1730), smooth_step(0.0, 0.2, bank - point.y));
    }
    return color;
}

// Two strokes of a wing.
bool in_bird(const V2d& point, const V2d& middle, double size) {
    const V2d p = (point - middle) / size;
    const double arc = 0.42 * std::sqrt(std::abs(p.x)) - 0.28 * p.x * p.x;
    return std::abs(p.x) < 1.0 && std::abs(p.y - arc) < 0.085 * (1.05 - std::abs(p.x));
}

}  // namespace

Color woodcut(const Sample& sample) {
    const V2d point = sample.point;
    Color color = point.y > shore ? mountains(point, with_bands(point, sky(point))) : lake(point);
    for (const auto& [middle, size] : {std::pair{V2d(0.02, 0.56), 0.052}, {V2d(0.16, 0.63), 0.040},
                                       {V2d(0.13, 0.49), 0.034}}) {
        color = in_bird(point, middle, size) ? ink : color;
    }
    color = foreground(point, color);

    // The grain of the block, faint, along the picture.
    const double grain = noise(V2d(point.x * 2.0, point.y * 85.0 + 3.0 * noise(point * 2.0, 91)), 90);
    return color * (1.0 + 0.025 * grain);
}

}  // namespace balcony::plates
