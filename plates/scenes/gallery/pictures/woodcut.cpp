// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "scenes/gallery/paintings.hpp"

namespace balcony::plates {

namespace {

constexpr double shore = -0.52;  // Height of the water's far edge.
const V2d sun_middle(0.42, 0.30);
constexpr double sun_radius = 0.30;

struct Ridge {
    double base;       // Mean height of the crest.
    double roughness;  // Height of its hills.
    double size;       // Width of its hills.
    Color crest;
    Color foot;  // Colour in the mist at its foot.
    std::uint32_t seed;
};

const Ridge ridges[] = {
    {0.13, 0.30, 0.95, from_srgb(0x9db4c0), from_srgb(0xf3dfc2), 11},
    {-0.03, 0.32, 0.80, from_srgb(0x6f93ad), from_srgb(0xefd9bd), 23},
    {-0.20, 0.30, 0.60, from_srgb(0x44709a), from_srgb(0xd9d5c6), 37},
    {-0.35, 0.26, 0.50, from_srgb(0x25507f), from_srgb(0xa9c0c4), 51},
};

// A mountain apart from the ridges: a cone with concave flanks and a broken, snowy top.
double peak_height(double x) {
    const double away = std::abs(x + 0.62);
    const double flank = 0.86 * std::exp(-1.75 * std::max(away, 0.085)) - 0.26;
    return flank + 0.02 * noise(V2d(x * 14.0, 0.5), 3) * smooth_step(0.5, 0.0, away);
}

// Height of a crest; few octaves give the lie of the land, more of them its detail.
double crest(const Ridge& ridge, double x, int octaves) {
    const double sharp = 1.0 - std::abs(noise(V2d(x / ridge.size, 7.3), ridge.seed));
    return ridge.base + ridge.roughness * (0.55 * (sharp - 0.5) +
                                           0.5 * fractal_noise(V2d(x / ridge.size * 1.7, 2.1),
                                                               octaves, ridge.seed + 100));
}

// Graded bands of printed colour: paper warm at the horizon, indigo along the upper edge.
Color sky(const V2d& point) {
    static const Gradient graded(
        {0xf7e3bf, 0xf6d5a4, 0xeec08f, 0xd9c9b0, 0x9fbcc0, 0x5b8da8, 0x1d4778, 0x122a5c});
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
            color = mix(
                paper, color,
                0.35 * smooth_step(0.0, 2.0 * b.half_height, point.y - b.middle.y + b.half_height));
        }
    }
    return color;
}

constexpr double ink_width = 0.0045;
const Color ink = from_srgb(0x101b3a);

// Whether a ridge stands at a point, and then its colour.
std::optional<Color> on_ridge(const Ridge& ridge, const V2d& point) {
    constexpr double highest = 0.775;  // That crest() can reach, in hills above the base.
    if (point.y > ridge.base + highest * ridge.roughness) {
        return std::nullopt;
    }
    const double top = crest(ridge, point.x, 6);
    if (point.y > top) {
        return std::nullopt;
    }
    if (top - point.y < ink_width) {
        return mix(ink, ridge.crest, 0.25);
    }
    const double mist_top = 0.5 * (ridge.base + crest(ridge, point.x, 1));
    return mix(ridge.crest, ridge.foot, smooth_step(0.0, 1.0, (mist_top + 0.06 - point.y) / 0.30));
}

// What stands on land: the nearest ridge first, the sky last.
Color above_shore(const V2d& point) {
    for (auto ridge = std::rbegin(ridges); ridge != std::rend(ridges); ++ridge) {
        if (const std::optional<Color> color = on_ridge(*ridge, point)) {
            return *color;
        }
    }
    const double peak = peak_height(point.x);
    if (point.y > peak) {
        return with_bands(point, sky(point));
    }
    static const Gradient body({0xf4ddc0, 0xb9b6b8, 0x5f7fa6, 0x35598c, 0x27497c});
    static const Color white = from_srgb(0xfbf6ea);
    const double snow = 0.33 + 0.075 * noise(V2d(point.x * 16.0, 1.0), 8) +
                        0.04 * noise(V2d(point.x * 41.0, 2.0), 9);
    if (peak - point.y < ink_width) {
        return ink;
    }
    return point.y > snow ? white * (point.x > -0.60 ? 1.0 : 0.86) : body((point.y + 0.22) / 0.62);
}

// Water: what stands above it, upside down and broken into strokes, under a blue that deepens.
Color lake(const V2d& point) {
    const double depth = shore - point.y;
    const double stroke = noise(V2d(point.x * 3.5, depth * (120.0 - 70.0 * depth)), 61);
    const V2d mirrored(point.x + 0.03 * stroke * (0.3 + 2.0 * depth), shore + depth * 1.9);
    static const Gradient water({0xe9d3b4, 0x8fb3ba, 0x3d7796, 0x1b467a, 0x12295a});
    Color color = water(depth / 0.48 + 0.05 * stroke);
    const double from_sun =
        std::abs(point.x - sun_middle.x + 0.05 * stroke) / (0.09 + 0.32 * depth);
    if (stroke > -0.05 + 0.35 * from_sun && from_sun < 1.0) {
        static const Color glow = from_srgb(0xe4583a);
        color = mix(color, glow, 0.85);
    } else if (stroke > 0.45 && depth < 0.33) {
        color = mix(color, above_shore(mirrored), 0.5 - depth);
    }
    return color;
}

const V2d pine_root(-1.20, -1.05);

bool in_trunk(const V2d& p) {
    const double bend = 0.17 * std::sin(p.y * 2.6) - 0.05;
    const double half = 0.040 - 0.020 * p.y + 0.005 * noise(p * 30.0, 70);
    if (p.y < 1.42 && std::abs(p.x - bend) < half) {
        return true;
    }
    // Boughs that carry the needles.
    for (const auto& [height, length] :
         {std::pair{0.60, 0.42}, {0.78, -0.34}, {0.97, 0.34}, {1.16, -0.24}}) {
        const double start = 0.17 * std::sin(height * 2.6) - 0.05;
        const double along = (p.x - start) / length;
        const double rise = height + 0.05 * along - 0.03 * std::sin(along * 5.0);
        if (along > 0.0 && along < 1.0 && std::abs(p.y - rise) < 0.014 * (1.2 - along)) {
            return true;
        }
    }
    return false;
}

// Needles grow in clouds: domes side by side over a level underside. Positive inside, growing
// from the outline to the middle of a dome.
double in_needles(const V2d& p) {
    struct Cloud {
        V2d middle;
        double half_length;
        double height;
    };
    static const Cloud clouds[] = {
        {{0.36, 0.62}, 0.36, 0.115}, {{-0.26, 0.79}, 0.30, 0.110}, {{0.34, 0.99}, 0.29, 0.105},
        {{-0.10, 1.18}, 0.27, 0.10}, {{0.10, 1.38}, 0.22, 0.115},
    };
    if (p.y < 0.55 || p.y > 1.56 || std::abs(p.x) > 0.8) {
        return -1.0;
    }
    const double ragged = 0.16 * fractal_noise(p * 34.0, 2, 71);
    double inside = -1.0;
    for (const Cloud& cloud : clouds) {
        for (int dome = -2; dome <= 2; ++dome) {
            const double size = 1.0 - 0.17 * std::abs(dome);
            const V2d q((p.x - cloud.middle.x - 0.36 * dome * cloud.half_length) /
                            (0.34 * cloud.half_length * size),
                        (p.y - cloud.middle.y) / (cloud.height * size));
            const double squeezed = q.y < 0.0 ? q.y * 4.0 : q.y;
            inside = std::max(inside, 1.0 + ragged - std::hypot(q.x, squeezed));
        }
    }
    return inside;
}

Color foreground(const V2d& point, Color color) {
    static const Gradient needles({0x081a2c, 0x123a46, 0x1f5a58, 0x3c7d68});
    static const Color bark = from_srgb(0x1a1422);
    static const Gradient earth({0x1d3b55, 0x0e1d38, 0x0a142c});
    const V2d p = point - pine_root;
    const double inside = in_needles(p);
    if (inside > 0.0) {
        const double tuft = fractal_noise(V2d(p.x * 60.0, p.y * 34.0), 2, 84);
        return inside < 0.07 ? needles(0.0) : needles(1.0 - 1.15 * inside + 0.35 * tuft);
    }
    if (in_trunk(p)) {
        return bark;
    }
    const double bank = -0.90 + 0.09 * noise(V2d(point.x * 1.3, 0.0), 81) - 0.14 * point.x / 1.5 +
                        0.015 * fractal_noise(V2d(point.x * 24.0, 3.0), 3, 82);
    return point.y < bank ? earth((bank - point.y) / 0.2) : color;
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
    Color color = point.y > shore ? above_shore(point) : lake(point);
    for (const auto& [middle, size] :
         {std::pair{V2d(0.02, 0.56), 0.052}, {V2d(0.16, 0.63), 0.040}, {V2d(0.13, 0.49), 0.034}}) {
        color = in_bird(point, middle, size) ? ink : color;
    }
    color = foreground(point, color);

    // The grain of the block, faint, along the picture.
    const double grain =
        noise(V2d(point.x * 2.0, point.y * 85.0 + 3.0 * noise(point * 2.0, 91)), 90);
    return color * (1.0 + 0.025 * grain);
}

}  // namespace balcony::plates
