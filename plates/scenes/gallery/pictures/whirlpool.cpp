// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "scenes/gallery/paintings.hpp"

namespace balcony::plates {

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

// One turn about the middle is this vector of the tile lattice, so that the weave closes.
constexpr int tiles_across = 9;
constexpr int tiles_along = 5;

struct Ribbon {
    double across;  // -1 .. 1 from edge to edge.
    double slope;   // Direction across the ribbon in the tile, radians.
    double shadow;  // 0 lit .. 1 dark, from the ribbon that passes above.
    bool found = false;
};

constexpr double half_width = 0.27;

// The shares of tiles that are crossings, and that are crossings or arcs about the corners ++, --.
constexpr double crossings = 0.46;
constexpr double mirrored_arcs = 0.73;

Ribbon on_straight(double offset, double along, bool vertical, bool above) {
    Ribbon ribbon{offset / half_width, vertical ? 0.0 : pi / 2.0, 0.0,
                  std::abs(offset) < half_width};
    if (!above) {
        ribbon.shadow = 1.0 - smooth_step(half_width, half_width + 0.22, std::abs(along));
    }
    return ribbon;
}

Ribbon on_arc(const Complex& from_corner) {
    const double radius = std::abs(from_corner);
    return {(radius - 0.5) / half_width, std::arg(from_corner), 0.0,
            std::abs(radius - 0.5) < half_width};
}

// One Truchet tile, |x|, |y| < 1/2: a crossing of two ribbons or two arcs about corners.
Ribbon in_tile(const Complex& p, double choice) {
    if (choice < crossings) {
        const bool vertical_above = choice < crossings / 2.0;
        const Ribbon vertical = on_straight(p.real(), p.imag(), true, vertical_above);
        const Ribbon horizontal = on_straight(p.imag(), p.real(), false, !vertical_above);
        const Ribbon& first = vertical_above ? vertical : horizontal;
        return first.found ? first : vertical_above ? horizontal : vertical;
    }
    const double mirrored = choice < mirrored_arcs ? 1.0 : -1.0;
    const Complex corner(0.5 * mirrored, 0.5);
    const Ribbon upper = on_arc(p - corner);
    return upper.found ? upper : on_arc(p + corner);
}

// Distance from the nearest middle line of a ribbon.
double to_middle_line(const Complex& p, double choice) {
    if (choice < crossings) {
        return std::min(std::abs(p.real()), std::abs(p.imag()));
    }
    const Complex corner(choice < mirrored_arcs ? 0.5 : -0.5, 0.5);
    return std::min(std::abs(std::abs(p - corner) - 0.5), std::abs(std::abs(p + corner) - 0.5));
}

// The ground between ribbons takes one of two colours, as a map does: the ribbons part the corners
// of a tile so that neighbouring corners always lie in different regions.
int ground_parity(const Complex& p, double choice) {
    const bool falling = p.real() * p.imag() > 0.0;  // Nearer to the corners ++ and --.
    if (choice < crossings) {
        return falling ? 0 : 1;
    }
    const int cut_off = choice < mirrored_arcs ? 0 : 1;
    const Complex corner(cut_off == 0 ? 0.5 : -0.5, 0.5);
    const bool beyond = std::min(std::abs(p - corner), std::abs(p + corner)) < 0.5;
    return beyond ? cut_off : 1 - cut_off;
}

}  // namespace

Color whirlpool(const Sample& sample) {
    static const Gradient ribbons(
        {0xfbe7b2, 0xf2a541, 0xd6402b, 0xf2a541, 0xfbe7b2, 0x8fc9b0, 0x1f8a94, 0x8fc9b0}, true);
    static const Color night = from_srgb(0x14265a);
    static const Color wine = from_srgb(0x6b1f3a);
    static const Color line = from_srgb(0xfff3d6);
    static const Color outline = from_srgb(0x0a0b1c);

    const Complex z(sample.point.x - 0.04, sample.point.y - 0.10);
    const double radius = std::abs(z);
    if (radius < 1e-6) {
        return outline;
    }
    const Complex per_turn(tiles_across, tiles_along);
    const Complex w = std::log(z) * per_turn / Complex(0.0, 2.0 * pi);

    // Tiles that differ by a whole turn are the same tile.
    int column = int(std::floor(w.real()));
    int row = int(std::floor(w.imag()));
    const Complex in(w.real() - column - 0.5, w.imag() - row - 0.5);
    const int turn = int(std::floor(double(column) / tiles_across));
    column -= turn * tiles_across;
    row -= turn * tiles_along;
    const double choice = lattice_noise(column, row, 2024);
    const Ribbon ribbon = in_tile(in, choice);

    const double depth = smooth_step(-3.4, 0.4, std::log(radius));
    if (!ribbon.found) {
        const int parity = (ground_parity(in, choice) + column + row) & 1;
        const double lit = 0.35 + 0.75 * smooth_step(half_width, 0.52, to_middle_line(in, choice));
        return (parity == 0 ? night : wine) * ((0.25 + 0.9 * depth) * lit);
    }
    // The ribbon is a shallow arch; the light turns with the lattice, so it is set in the picture.
    const double bulge = ribbon.across * 0.9;
    const Complex across = std::polar(1.0, ribbon.slope) * z / std::abs(z) * Complex(0.0, 1.0) /
                           std::polar(1.0, std::arg(per_turn));
    const V3d normal = V3d(bulge * across.real(), bulge * across.imag(), 1.0).normalized();
    const double light = std::max(0.0, normal.dot(V3d(-0.45, 0.65, 0.62).normalized()));
    const double edge = smooth_step(0.80, 0.90, std::abs(ribbon.across));
    const double rail = smooth_step(0.10, 0.0, std::abs(std::abs(ribbon.across) - 0.62));
    Color color = ribbons(std::arg(z) / (2.0 * pi) + 0.22 * std::log(radius));
    color = mix(color, line, 0.55 * rail);
    color *= (0.22 + 0.95 * light) * (1.0 - 0.72 * ribbon.shadow) * (0.30 + 0.75 * depth);
    return mix(color, outline, edge);
}

}  // namespace balcony::plates
