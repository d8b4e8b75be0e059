// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/temple/column.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "common/meshes.hpp"
#include "common/mouldings.hpp"
#include "scenes/temple/dimensions.hpp"
#include "scenes/temple/marble.hpp"

namespace balcony::plates::temple {

namespace {

using scene::M44d;
using scene::Mesh;
using std::numbers::pi;

constexpr int flutes = 20;
constexpr int points_a_flute = 8;

// A square slab about the z axis: four flat sides, top and bottom.
Mesh slab(double half, double low, double high, double bevel) {
    Profile profile(V2d(half - bevel, low));
    profile.line({half, low + bevel}).line({half, high - bevel}).line({half - bevel, high});
    profile.line({half / 3.0, high});
    // A lathe with four segments whose corners are at 45 degrees; its sides are flat, so that they
    // have normals of their own.
    Mesh mesh;
    for (int side = 0; side < 4; ++side) {
        const double middle = side * pi / 2;
        for (const Profile::Run& run : profile.runs()) {
            std::vector<V3d> points;
            for (const V2d& point : run) {
                for (const double corner : {-1.0, 1.0}) {
                    const V3d p(point.x, corner * point.x, point.y);
                    points.push_back(p * M44d().setAxisAngle(V3d(0, 0, 1), middle));
                }
            }
            append(mesh, grid(2, points, marble_size));
        }
    }
    return mesh;
}

Mesh base() {
    Mesh mesh = slab(0.68, floor_z - 0.05, floor_z + 0.2, 0.012);
    Profile profile(V2d(0.6, floor_z + 0.2));
    profile.arc({0.6, floor_z + 0.36}, 0.5, 10);
    profile.line({0.565, floor_z + 0.36}).line({0.565, floor_z + 0.385});
    profile.arc({0.535, floor_z + 0.45}, -0.3, 6);
    profile.line({0.55, floor_z + 0.45}).line({0.55, floor_z + 0.465});
    profile.arc({0.55, floor_z + 0.54}, 0.5, 8);
    profile.line({0.52, floor_z + 0.54}).line({0.52, shaft_z}).line({0.3, shaft_z});
    append(mesh, revolve(profile, 48, {}, marble_size));
    return mesh;
}

// The radius of a shaft without flutes, which swells a little below its middle (entasis).
double swelling(double t) {
    return std::lerp(shaft_low, shaft_high, t) + 0.022 * t * (1.0 - t) * 4;
}

struct Fluting {
    int number;       // Of the column, for the weathering.
    double from, to;  // Heights where the hollows begin and end.
};

// How deep the surface lies below the swelling at an angle and a height.
double hollow(const Fluting& fluting, double angle, double z) {
    const double in = angle / (2.0 * pi) * flutes;
    const double across = 2.0 * (in - std::floor(in)) - 1.0;  // -1 to 1 over a flute and its fillet
    constexpr double half_width = 0.8;
    // The ends are round.
    const double to_end = std::clamp(std::min(z - fluting.from, fluting.to - z) / 0.075, 0.0, 1.0);
    const double depth = std::sqrt(to_end * (2.0 - to_end));
    const double width = half_width * depth;
    double below = 0.0;
    if (std::abs(across) < width) {
        const double s = across / width;
        below = 0.06 * depth * std::sqrt(1.0 - s * s);
    }
    // Chips off the fillets.
    const V3d at(2.5 * std::cos(angle), 2.5 * std::sin(angle), 2.2 * z + 17.0 * fluting.number);
    const double chip = smooth_step(0.42, 0.7, noise(at, 101) + 0.35 * noise(at * 4.0, 103));
    return std::max(below, 0.034 * chip);
}

// The fluted surface between two heights, one drum, with a rounded joint at either end.
Mesh drum(const Fluting& fluting, double low, double high, int rows) {
    constexpr std::uint32_t around = flutes * points_a_flute + 1;
    std::vector<V3d> points;
    const auto add_row = [&](double z, double recess) {
        const double t = (z - shaft_z) / (capital_z - shaft_z);
        for (std::uint32_t k = 0; k < around; ++k) {
            const double angle = 2.0 * pi * k / (around - 1);
            const double r = swelling(t) - recess - hollow(fluting, angle, z);
            points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
        }
    };
    add_row(low, 0.02);
    for (int row = 0; row <= rows; ++row) {
        add_row(std::lerp(low + 0.008, high - 0.008, static_cast<double>(row) / rows), 0.0);
    }
    add_row(high, 0.02);
    return grid(around, points, marble_size);
}

// Another part of the marble's tile for each mesh.
void shift_texture(Mesh& mesh, int number) {
    const V2d by(lattice_noise(number, 1, 111), lattice_noise(number, 2, 111));
    for (scene::V2f& at : mesh.texture_coordinates[0]) {
        at += scene::V2f(by);
    }
}

void append_stone(Mesh& mesh, Mesh part, int number) {
    set_color(part, block_tint(number, 0.22));
    shift_texture(part, number);
    append(mesh, part);
}

Mesh impost() {
    Mesh mesh = slab(0.56, impost_z - 0.02, impost_z + 0.3, 0.01);
    append(mesh, slab(0.6, impost_z + 0.3, impost_z + 0.37, 0.01));
    append(mesh, slab(0.65, impost_z + 0.37, spring_z, 0.01));
    return mesh;
}

}  // namespace

Mesh column(int number) {
    constexpr int drums = 5;
    Mesh mesh;
    const int seed = 10 * number;
    append_stone(mesh, base(), seed);
    const Fluting fluting{number, shaft_z + 0.1, capital_z - 0.1};
    double low = shaft_z;
    for (int k = 0; k < drums; ++k) {
        const double even = (k + 1.0) / drums;
        const double uneven = k + 1 < drums ? 0.08 * (lattice_noise(seed, k, 121) - 0.5) : 0.0;
        const double high = std::lerp(shaft_z, capital_z, even + uneven);
        append_stone(mesh, drum(fluting, low, high, k == 0 || k + 1 == drums ? 12 : 7),
                     seed + 1 + k);
        low = high;
    }
    append_stone(mesh, moved(capital(), M44d().setTranslation(V3d(0, 0, capital_z))), seed + 7);
    append_stone(mesh, impost(), seed + 8);
    return mesh;
}

Mesh fallen_drum(int number, double length) {
    const double low = shaft_z + 1.5;
    Mesh mesh = drum({number, 0.0, 20.0}, low, low + length, 12);
    constexpr std::uint32_t around = flutes * points_a_flute + 1;
    // Both faces; the first and the last point of a row are one.
    const std::size_t upper = mesh.positions.size() - around;
    std::vector<V3d> top, bottom;
    for (std::uint32_t k = 0; k + 1 < around; ++k) {
        top.emplace_back(mesh.positions[upper + k]);
        bottom.emplace_back(mesh.positions[around - 1 - k]);
    }
    append(mesh, fan(top, marble_size));
    append(mesh, fan(bottom, marble_size));
    mesh = moved(std::move(mesh), M44d().setTranslation(V3d(0, 0, -low)));
    set_color(mesh, block_tint(number, 0.2));
    shift_texture(mesh, number);
    return mesh;
}

}  // namespace balcony::plates::temple
