// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/temple/desert.hpp"

namespace balcony::plates::temple {

namespace {

using scene::Mesh;
using scene::V2f;
using scene::V3f;
using std::numbers::pi;

constexpr double sun_elevation = 13.0 * pi / 180.0;
constexpr double sun_azimuth = 205.0 * pi / 180.0;  // From the x axis, counter-clockwise.
constexpr double sun_diameter = 0.7 * pi / 180.0;

// The clear sky of a late afternoon: blue above, pale and warm at the horizon, bright about the
// sun.
Color clear_sky(const V3d& direction) {
    static const Color zenith(0.036, 0.10, 0.26);
    static const Color low(0.32, 0.40, 0.50);
    static const Color dust(0.80, 0.56, 0.36);
    const double up = std::max(direction.z, 0.0);
    const double to_sun = direction.dot(sun_direction());
    const double apart = std::acos(std::clamp(to_sun, -1.0, 1.0));
    Color color = mix(low, zenith, 1.0 - std::exp(-2.6 * up));
    color = mix(color, dust, (0.6 + 0.28 * to_sun) * std::exp(-up / 0.075));
    const double halo = 0.26 * std::exp(-apart / 0.45) + 0.8 * std::exp(-apart / 0.10) +
                        2.0 * std::exp(-apart / 0.03);
    return color + Color(1.0, 0.76, 0.48) * halo * (0.6 + 0.4 * std::exp(-up / 0.3));
}

// How thick a layer of cloud is at a place of it; places are in the unit of its height.
double heaps(const V2d& at) {
    const V2d bent =
        at + 0.5 * V2d(fractal_noise(at * 0.9, 3, 301), fractal_noise(at * 0.9, 3, 311));
    const double cover = 0.5 * fractal_noise(at * 0.23, 2, 321);
    return std::max(0.0, fractal_noise(bent * 0.85, 6, 331) + cover - 0.02);
}

double veils(const V2d& at) {
    // Drawn out by the wind high above.
    const double c = std::cos(0.5);
    const double s = std::sin(0.5);
    const V2d along(c * at.x + s * at.y, c * at.y - s * at.x);
    const V2d bent =
        along + 0.6 * V2d(fractal_noise(along * 0.5, 3, 341), fractal_noise(along * 0.6, 3, 351));
    const double streaks = fractal_noise(V2d(bent.x * 0.35, bent.y * 2.2), 5, 361);
    return smooth_step(-0.02, 0.75, streaks + 0.5 * fractal_noise(at * 0.2, 2, 371));
}

// Where a direction meets a layer of cloud. The earth's curvature keeps it from running to
// infinity.
V2d on_layer(const V3d& direction, double curvature) {
    return V2d(direction.x, direction.y) / (direction.z + curvature);
}

Color sky(const V3d& direction) {
    static const Color shade(0.38, 0.375, 0.41);
    static const Color lit(1.0, 0.82, 0.64);
    Color color = clear_sky(direction);
    const V3d sun = sun_direction();
    const double to_sun = std::max(direction.dot(sun), 0.0);
    const double forward = 0.9 + 0.4 * std::pow(to_sun, 6.0);
    const double fade = smooth_step(0.005, 0.10, direction.z);

    const double veil = veils(on_layer(direction, 0.22) * 1.2);
    color = mix(color, lit * (0.55 * forward), 0.42 * veil * fade);

    const V2d at = on_layer(direction, 0.09) * 0.9;
    const double thickness = heaps(at);
    if (thickness > 0.0) {
        // What lies between here and the sun takes its light away.
        const V2d towards = V2d(sun.x, sun.y).normalized();
        double between = 0.0;
        for (int k = 1; k <= 5; ++k) {
            between += heaps(at + towards * (0.11 * k));
        }
        const double light =
            std::exp(-1.1 * between) * (1.0 - 0.35 * smooth_step(0.2, 0.7, thickness));
        const double density = 1.0 - std::exp(-5.0 * thickness);
        const double edge = (1.0 - density) * 0.35 * std::pow(to_sun, 3.0);
        const Color cloud = mix(shade, lit * forward * 0.95, 0.12 + 0.88 * light) + lit * edge;
        const double far = std::exp(-0.05 / std::max(direction.z, 1e-3));
        color = mix(color, mix(color, cloud, 0.35 + 0.65 * far), 0.92 * density * fade);
    }
    return color;
}

// The elevation at a height in the picture, both from 0 (the horizon) to 1 (the zenith).
double elevation_at(double height) { return height * height; }

V3d direction_of(double turn, double elevation) {
    const double angle = 2.0 * pi * turn;
    const double up = elevation * pi / 2.0;
    return {std::cos(up) * std::cos(angle), std::cos(up) * std::sin(angle), std::sin(up)};
}

}  // namespace

V3d sun_direction() { return direction_of(sun_azimuth / (2.0 * pi), sun_elevation / (pi / 2.0)); }

Color sky_picture(const Sample& sample) {
    const double turn = 0.5 - sample.point.x / (2.0 * sky_aspect);
    const double height = (sample.point.y + 1.0) / 2.0;
    // Noise of about one step of a byte hides the steps.
    const V2d place = sample.point * 1e4;
    const double dither =
        lattice_noise(static_cast<int>(place.x), static_cast<int>(place.y), 381) - 0.5;
    return sky(direction_of(turn, elevation_at(height))) * (1.0 + 0.012 * dither);
}

Mesh sky_dome() {
    constexpr std::uint32_t columns = 97;
    constexpr std::uint32_t rows = 29;
    Mesh mesh;
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double turn = 1.0 - column / (columns - 1.0);
            const double height = row / (rows - 1.0);
            const V3d direction = direction_of(turn, elevation_at(height));
            mesh.positions.emplace_back(horizon * direction);
            mesh.normals.emplace_back(-direction);
            mesh.texture_coordinates[0].push_back(V2f(V2d(1.0 - turn, 1.0 - height)));
        }
    }
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t low = row * columns + column;
            const std::uint32_t high = low + columns;
            mesh.triangles.push_back({low, low + 1, high + 1});
            if (row + 2 < rows) {
                mesh.triangles.push_back({low, high + 1, high});
            }
        }
    }
    return mesh;
}

Mesh sun_disc() {
    constexpr int pieces = 12;
    const V3d direction = sun_direction();
    const V3d right = direction.cross(V3d(0, 0, 1)).normalized();
    const V3d up = right.cross(direction);
    const double distance = 0.97 * horizon;
    const double size = distance * std::tan(sun_diameter / 2.0);
    Mesh mesh;
    mesh.positions.emplace_back(distance * direction);
    for (int k = 0; k < pieces; ++k) {
        const double angle = 2.0 * pi * k / pieces;
        mesh.positions.emplace_back(distance * direction +
                                    size * (right * std::cos(angle) + up * std::sin(angle)));
    }
    mesh.normals.assign(mesh.positions.size(), V3f(-direction));
    for (std::uint32_t k = 0; k < pieces; ++k) {
        mesh.triangles.push_back({0, 1 + (k + 1) % pieces, 1 + k});
    }
    return mesh;
}

}  // namespace balcony::plates::temple
