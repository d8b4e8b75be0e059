// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <numbers>

#include <tbb/parallel_for.h>

#include "scenes/temple/desert.hpp"
#include "scenes/temple/dimensions.hpp"
#include "scenes/temple/marble.hpp"

namespace balcony::plates::temple {

namespace {

using scene::Mesh;
using scene::V2f;
using scene::V3f;
using std::numbers::pi;

const V2d wind(std::cos(0.2), std::sin(0.2));  // Blows this way.

// One train of dunes: a long slope to windward, a short steep one to leeward.
double dunes(const V2d& at, double length, std::uint32_t seed) {
    const V2d cross(-wind.y, wind.x);
    const double bend = fractal_noise(at / (2.6 * length), 3, seed);
    const double phase = at.dot(wind) / length + 1.9 * bend + 0.12 * at.dot(cross) / length;
    const double in = phase - std::floor(phase);
    const double shape = in < 0.74 ? smooth_step(0.0, 0.74, in) : 1.0 - smooth_step(0.74, 1.0, in);
    const double strength =
        0.55 + 0.9 * fractal_noise(at / (1.7 * length) + V2d(31.0), 2, seed + 9);
    return shape * std::max(0.0, strength);
}

// Sand that the wind left on the steps and on the floor, on the side that it comes from.
double drift(const V2d& at) {
    const double r = at.length();
    const double side = -at.dot(wind) / std::max(r, 1e-9);
    const double here = smooth_step(0.15, 0.95, side + 0.35 * fractal_noise(at / 3.5, 2, 151));
    const double across = (r - 12.7) / 2.4;
    const double bank = 1.25 * here * std::exp(-across * across) *
                        (0.85 + 0.4 * noise(V3d(at.x / 2, at.y / 2, 0.5), 153));
    const double film = floor_z + 0.1 * (fractal_noise(at / 1.6, 3, 157) - 0.16) -
                        0.05 * (10.6 - r) + 0.22 * (here - 0.75);
    return std::max(bank, film - 3.0 * std::max(r - 10.9, 0.0));
}

// Bent, so that the tiles are not seen.
V2f ripple_coordinates(const V2d& at) {
    const V2d bend(fractal_noise(at / 40.0, 2, 191), fractal_noise(at / 40.0, 2, 195));
    const V2d tile = (at + 5.0 * bend) / ripple_tile;
    return V2f(V2d(tile.x, -tile.y));
}

// Golden, and paler towards the horizon, as in dusty air.
scene::Color4f sand_color(const V2d& at) {
    const double shade = 0.96 + 0.1 * fractal_noise(at / 7.0, 4, 197);
    const double haze = std::sqrt(smooth_step(60.0, 4000.0, at.length()));
    const Color color = mix(Color(0.66, 0.45, 0.25) * shade, Color(0.72, 0.60, 0.48), haze);
    return {static_cast<float>(color.x), static_cast<float>(color.y), static_cast<float>(color.z),
            1.0F};
}

}  // namespace

double sand_height(const V2d& at) {
    const double r = at.length();
    const double sink = 1.0 - 0.75 * smooth_step(1000.0, 4000.0, r);
    const double rise = smooth_step(32.0, 150.0, r);
    const double uneven = 0.2 * fractal_noise(at / 9.0, 3, 161) * smooth_step(12.0, 20.0, r) +
                          0.9 * smooth_step(17.0, 34.0, r) * (1.0 - rise) * dunes(at, 17.0, 165);
    const double far = 11.0 * dunes(at, 150.0, 171) + 3.2 * dunes(at, 47.0, 181);
    return uneven + drift(at) * smooth_step(20.0, 17.0, r) + rise * sink * far - 0.04;
}

Mesh sand() {
    constexpr std::uint32_t around = 360;
    std::vector<double> radii{7.0};
    while (radii.back() < horizon) {
        const double r = radii.back();
        radii.push_back(r + (r < 20.0 ? 0.13 : 0.024 * (r - 15.0)));
    }
    radii.back() = horizon;
    const auto rows = static_cast<std::uint32_t>(radii.size());
    constexpr std::uint32_t columns = around + 1;
    Mesh mesh;
    const std::size_t size = std::size_t{columns} * rows;
    mesh.positions.resize(size);
    mesh.normals.resize(size);
    mesh.texture_coordinates[0].resize(size);
    mesh.colors.resize(size);
    const auto position = [&](std::uint32_t row, std::uint32_t column) -> V3f& {
        return mesh.positions[std::size_t{row} * columns + column % around];
    };
    tbb::parallel_for(0U, rows, [&](std::uint32_t row) {
        const double r = radii[row];
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double angle = 2.0 * pi * (column % around) / around;
            const V2d at(r * std::cos(angle), r * std::sin(angle));
            const std::size_t k = std::size_t{row} * columns + column;
            mesh.positions[k] = V3f(V3d(at.x, at.y, sand_height(at)));
            mesh.texture_coordinates[0][k] = ripple_coordinates(at);
            mesh.colors[k] = sand_color(at);
        }
    });
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const V3f outwards = position(std::min(row + 1, rows - 1), column) -
                                 position(row > 0 ? row - 1 : 0, column);
            const V3f around_it = position(row, column + 1) - position(row, column + around - 1);
            mesh.normals[std::size_t{row} * columns + column] =
                outwards.cross(around_it).normalized();
        }
    }
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
        for (std::uint32_t column = 0; column < around; ++column) {
            const std::uint32_t inner = row * columns + column;
            const std::uint32_t outer = inner + columns;
            mesh.triangles.push_back({inner, outer, outer + 1});
            mesh.triangles.push_back({inner, outer + 1, inner + 1});
        }
    }
    return mesh;
}

Color sand_ripples(const Sample& sample) {
    const auto height = [](const V2d& p) {
        const double bend = 0.55 * tile_noise(p, 4, 3, 201) + 0.1 * tile_noise(p, 16, 2, 211);
        constexpr double waves = 26.0;
        const double wave = std::sin(2.0 * pi * (waves * p.x + 6.0 * bend));
        const double crest = std::pow(0.5 + 0.5 * wave, 1.5);
        const double strength = smooth_step(-0.35, 0.3, tile_noise(p, 3, 3, 221)) + 0.15;
        return strength * crest + 0.05 * tile_noise(p, 128, 2, 231);
    };
    const V2d p = (sample.point + V2d(1.0)) / 2.0;
    constexpr double step = 1.0 / 2048.0;
    constexpr double steepness = 0.0038;  // The height of a crest as a fraction of the tile.
    const double dx = height(p + V2d(step, 0)) - height(p - V2d(step, 0));
    const double dy = height(p + V2d(0, step)) - height(p - V2d(0, step));
    const V3d normal =
        V3d(-dx * steepness / (2 * step), -dy * steepness / (2 * step), 1.0).normalized();
    return (normal + V3d(1.0)) / 2.0;
}

}  // namespace balcony::plates::temple
