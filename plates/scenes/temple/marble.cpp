// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/temple/marble.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/temple/dimensions.hpp"

namespace balcony::plates::temple {

namespace {

using std::numbers::pi;

int wrapped(int x, int period) { return ((x % period) + period) % period; }

double tile_octave(const V2d& point, int cells, std::uint32_t seed) {
    const V2d scaled = point * cells;
    const int x = static_cast<int>(std::floor(scaled.x));
    const int y = static_cast<int>(std::floor(scaled.y));
    const double u = smooth_step(0.0, 1.0, scaled.x - x);
    const double v = smooth_step(0.0, 1.0, scaled.y - y);
    const auto at = [&](int dx, int dy) {
        return lattice_noise(wrapped(x + dx, cells), wrapped(y + dy, cells), seed);
    };
    return 2.0 * std::lerp(std::lerp(at(0, 0), at(1, 0), u), std::lerp(at(0, 1), at(1, 1), u), v) -
           1.0;
}

// A vein runs where a noise passes through 0: 1 in its middle.
double vein(double noise, double width) { return std::exp(-std::abs(noise) / width); }

V2d tile_point(const Sample& sample) { return (sample.point + V2d(1.0)) / 2.0; }

}  // namespace

double noise(const V3d& point, std::uint32_t seed) {
    const double floor = std::floor(point.z);
    const double w = smooth_step(0.0, 1.0, point.z - floor);
    const V2d across(point.x, point.y);
    const auto layer = [&](double z) {
        return plates::noise(across,
                             seed + 7919U * static_cast<std::uint32_t>(static_cast<int>(z)));
    };
    return std::lerp(layer(floor), layer(floor + 1.0), w);
}

double tile_noise(const V2d& point, int cells, int octaves, std::uint32_t seed) {
    double sum = 0.0;
    double height = 0.5;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += height * tile_octave(point, cells, seed + static_cast<std::uint32_t>(octave));
        cells *= 2;
        height /= 2.0;
    }
    return sum;
}

Color marble(const Sample& sample) {
    static const Color white = from_srgb(0xe6dac6);
    static const Color honey = from_srgb(0xcfae7e);
    static const Color grey = from_srgb(0x8b8378);
    static const Color rust = from_srgb(0x9a6a42);
    const V2d p = tile_point(sample);
    const V2d bent = p + 0.22 * V2d(tile_noise(p, 3, 4, 1), tile_noise(p, 3, 4, 11));
    const double cloud = tile_noise(bent, 2, 5, 21);
    Color color = mix(white, honey, smooth_step(-0.15, 0.55, cloud) * 0.75);
    color = mix(color, grey, 0.55 * vein(tile_noise(bent, 3, 3, 31), 0.018));
    color = mix(color, rust, 0.35 * vein(tile_noise(bent, 5, 3, 41), 0.012));
    return color * (0.95 + 0.12 * tile_noise(p, 48, 3, 51));
}

Color floor_slabs(const Sample& sample) {
    static const Gradient pale({0xd9c9ad, 0xe4d8c2, 0xcdb894});
    static const Gradient red({0x8d6a58, 0x9b7763, 0x7f5d4d});
    static const Gradient green({0x6d7466, 0x7c8171, 0x5f665b});
    const double r = 11.5 * sample.point.length();
    const double turn = std::atan2(sample.point.y, sample.point.x) / bay;
    const double grain = fractal_noise(sample.point * 60.0, 4, 61);
    const double fleck = 0.25 * fractal_noise(sample.point * 9.0, 4, 67);

    // The star: from its points at radius 4 to its notches at 2.2.
    const double in_ray = 2.0 * std::abs(turn - std::round(turn));
    const double star = std::lerp(4.2, 2.1, in_ray);
    // Rings of slabs outside of it, each with joints of its own.
    const int ring = static_cast<int>(std::floor((r - 4.6) / 1.15));
    const double slabs = ring % 2 == 0 ? 2.0 : 3.0;
    const double across = turn * slabs + 0.5 * (ring & 1);
    const int slab = static_cast<int>(std::floor(across));
    const double shade = lattice_noise(slab, ring, 71) * 0.7 + 0.3 * grain + fleck;
    Color color;
    double to_joint = 1.0;
    if (r < 0.9) {
        color = red(0.5 + grain);
    } else if (r < star) {
        color = turn > std::round(turn) ? pale(0.6 + grain) : green(0.5 + grain);
        to_joint = std::min(r - 0.9, star - r);
    } else if (r < 4.6) {
        color = red(0.5 + grain);
        to_joint = std::min(r - star, 4.6 - r);
    } else {
        color = ring == 3 ? red(shade) : pale(shade);
        const double in = across - slab;
        const double up = (r - 4.6) / 1.15 - ring;
        to_joint = std::min(std::min(in, 1.0 - in) * r * bay / slabs, std::min(up, 1 - up) * 1.15);
    }
    return color * (0.55 + 0.45 * smooth_step(0.0, 0.025, to_joint)) * (1.0 + 0.1 * grain);
}

Color block_tint(int number, double variation) {
    const double level = 1.0 - variation * lattice_noise(number, 5, 81);
    const double warmth = 0.5 * variation * (lattice_noise(number, 9, 83) - 0.5);
    return {level, level * (1.0 - 0.3 * std::abs(warmth)), level * (1.0 - 0.5 * warmth) * 0.98};
}

void weather(scene::Mesh& mesh, double amount, double size) {
    for (scene::V3f& position : mesh.positions) {
        const V3d p = V3d(position) / size;
        const V3d offset(noise(p, 91), noise(p, 92), noise(p, 93));
        position += scene::V3f(offset * amount);
    }
}

}  // namespace balcony::plates::temple
