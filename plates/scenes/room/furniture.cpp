// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/room/furniture.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "common/meshes.hpp"
#include "common/mouldings.hpp"
#include "common/surfaces.hpp"

namespace balcony::plates::room {

namespace {

using std::numbers::pi;

// A straight rod between two points.
void rod(MeshBuilder& built, const V3d& from, const V3d& to, double radius, double end_radius) {
    built.tube({{from, radius}, {to, end_radius}}, 10);
}

// A tapered leg from the floor to a height.
void leg(MeshBuilder& built, const V2d& at, const V2d& foot, double height, double radius) {
    rod(built, V3d(foot.x, foot.y, 0.6 * radius), V3d(at.x, at.y, height), 0.6 * radius, radius);
}

struct Book {
    V3d low, high;
    std::uint32_t color;
    bool banded;
};

// With its spine at -y; two bands of gold across it.
void append_book(scene::Mesh& mesh, const Book& book, const M44d& placed = M44d()) {
    const auto append_colored = [&](const MeshBuilder& part, const Color& color) {
        scene::Mesh made = MeshBuilder().add(part, placed).mesh();
        set_color(made, color);
        append(mesh, made);
    };
    append_colored(MeshBuilder().box(book.low, book.high, 0.003), from_srgb(book.color));
    if (!book.banded) {
        return;
    }
    const double height = book.high.z - book.low.z;
    MeshBuilder bands;
    for (const double at : {0.12, 0.78, 0.86}) {
        const double z = book.low.z + at * height;
        bands.box(V3d(book.low.x + 0.002, book.low.y - 0.0015, z),
                  V3d(book.high.x - 0.002, book.low.y + 0.004, z + 0.008));
    }
    append_colored(bands, from_srgb(0xd9b25c));
}

constexpr std::array<std::uint32_t, 14> covers{0x8c2f2a, 0x274b6b, 0x2f5a44, 0xc98a2e, 0x5b2e4f,
                                               0xd8cdb4, 0x1f2a36, 0xb5532e, 0x4f7c86, 0x7a6a3a,
                                               0x9e3f56, 0x3d3a6b, 0xe0b64c, 0x54703c};

std::uint32_t cover(double random) {
    return covers[static_cast<std::size_t>(random * static_cast<double>(covers.size()))];
}

}  // namespace

scene::Mesh cushion(const V3d& middle, const V3d& half, double exponent) {
    return smooth_surface(32, 20, [&](double u, double v) {
        const double longitude = 2.0 * pi * u;
        const double latitude = pi * (v - 0.5);
        const V3d way(std::cos(latitude) * std::cos(longitude),
                      std::cos(latitude) * std::sin(longitude), std::sin(latitude));
        const double sum = std::pow(std::abs(way.x), exponent) +
                           std::pow(std::abs(way.y), exponent) +
                           std::pow(std::abs(way.z), exponent);
        return middle + way * half * std::pow(sum, -1.0 / exponent);
    });
}

scene::Mesh upholstery(double width, int seats) {
    const double inner = width - 0.38;
    scene::Mesh mesh = cushion(V3d(0, 0, 0.23), V3d(width / 2 - 0.03, 0.43, 0.13), 12);
    append(mesh, cushion(V3d(0, 0.37, 0.5), V3d(width / 2 - 0.04, 0.09, 0.33), 7));
    for (const double side : {-1.0, 1.0}) {
        append(mesh, cushion(V3d(side * (width / 2 - 0.1), 0, 0.36), V3d(0.1, 0.45, 0.27), 6));
    }
    for (int k = 0; k < seats; ++k) {
        const double x = inner * ((k + 0.5) / seats - 0.5);
        const double half = inner / seats / 2 + 0.005;
        append(mesh, cushion(V3d(x, -0.09, 0.41), V3d(half, 0.37, 0.09), 5));
        append(mesh, cushion(V3d(x, 0.2, 0.66), V3d(half, 0.12, 0.21), 4));
    }
    return mesh;
}

MeshBuilder feet(double width) {
    MeshBuilder built;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-0.34, 0.34}) {
            leg(built, V2d(x * (width / 2 - 0.12), y), V2d(x * (width / 2 - 0.1), y), 0.14, 0.025);
        }
    }
    return built;
}

MeshBuilder chair() {
    MeshBuilder built;
    built.box(V3d(-0.22, -0.22, 0.43), V3d(0.22, 0.22, 0.465), 0.012);
    for (const double side : {-1.0, 1.0}) {
        leg(built, V2d(side * 0.18, -0.18), V2d(side * 0.2, -0.21), 0.44, 0.022);
        rod(built, V3d(side * 0.2, 0.24, 0.015), V3d(side * 0.18, 0.2, 0.5), 0.015, 0.02);
        rod(built, V3d(side * 0.18, 0.2, 0.45), V3d(side * 0.19, 0.28, 0.92), 0.02, 0.014);
    }
    for (int k = -2; k <= 2; ++k) {
        rod(built, V3d(0.06 * k, 0.2, 0.45), V3d(0.068 * k, 0.27, 0.86), 0.009, 0.008);
    }
    built.box(V3d(-0.22, 0.262, 0.85), V3d(0.22, 0.292, 0.95), 0.012);
    return built;
}

MeshBuilder round_table() {
    MeshBuilder built;
    built.lathe(V3d(0.0),
                {{0.24, 0.0},
                 {0.24, 0.0},
                 {0.24, 0.02},
                 {0.24, 0.02},
                 {0.06, 0.07},
                 {0.035, 0.2},
                 {0.05, 0.35},
                 {0.035, 0.5},
                 {0.08, 0.7},
                 {0.08, 0.7},
                 {0.44, 0.705},
                 {0.48, 0.715},
                 {0.485, 0.73},
                 {0.475, 0.74},
                 {0.475, 0.74},
                 {0.0, 0.74}},
                48);
    return built;
}

MeshBuilder coffee_table() {
    MeshBuilder built;
    built.box(V3d(-0.6, -0.31, 0.385), V3d(0.6, 0.31, 0.42), 0.008);
    built.box(V3d(-0.52, -0.25, 0.15), V3d(0.52, 0.25, 0.17), 0.004);
    for (const double x : {-0.53, 0.53}) {
        for (const double y : {-0.26, 0.26}) {
            leg(built, V2d(x, y), V2d(1.03 * x, 1.06 * y), 0.39, 0.024);
        }
    }
    return built;
}

namespace {

constexpr int shelves = 6;
constexpr int columns = 3;
constexpr double shelf_depth = 0.28;
constexpr double board = 0.025;
constexpr double shelf_pitch = 0.355;
constexpr double bookcase_foot = 0.1;

}  // namespace

MeshBuilder bookcase() {
    MeshBuilder built;
    const double half = bookcase_width / 2;
    const double top = bookcase_foot + shelves * shelf_pitch;
    built.box(V3d(-half, -0.012, 0), V3d(half, 0, top));
    for (int k = 0; k <= columns; ++k) {
        const double x = -half + k * (bookcase_width - board) / columns;
        built.box(V3d(x, -shelf_depth - 0.015, 0), V3d(x + board, -0.01, top), 0.003);
    }
    for (int k = 0; k <= shelves; ++k) {
        const double z = bookcase_foot + k * shelf_pitch;
        built.box(V3d(-half + 0.01, -shelf_depth, z - board), V3d(half - 0.01, -0.01, z), 0.003);
    }
    built.box(V3d(-half, -shelf_depth + 0.02, 0), V3d(half, -shelf_depth + 0.04, bookcase_foot));
    built.box(V3d(-half - 0.03, -shelf_depth - 0.045, top), V3d(half + 0.03, 0, top + 0.05), 0.012);
    return built;
}

scene::Mesh books() {
    scene::Mesh mesh;
    int number = 0;
    const auto random = [&number](std::uint32_t what) { return lattice_noise(number, 5, what); };
    const double bay = (bookcase_width - board) / columns;
    for (int shelf = 0; shelf < shelves; ++shelf) {
        for (int column = 0; column < columns; ++column) {
            const double z = bookcase_foot + shelf * shelf_pitch;
            double x = -bookcase_width / 2 + column * bay + board + 0.004;
            const double all = x + bay - board - 0.01;
            // A gap at the end of some rows, where the last book leans.
            const double end = all - (lattice_noise(shelf, column, 41) < 0.6 ? 0.16 : 0.0);
            std::uint32_t color = 0;
            int in_series = 0;
            double height = 0.0;
            double width = 0.0;
            while (true) {
                ++number;
                if (in_series-- <= 0) {
                    color = cover(random(1));
                    in_series = random(2) < 0.3 ? 2 + static_cast<int>(5.0 * random(3)) : 0;
                    height = 0.2 + 0.11 * random(4);
                    width = 0.018 + 0.03 * random(5);
                }
                if (x + width > end) {
                    break;
                }
                const double front = -shelf_depth + 0.02 + 0.03 * random(6);
                append_book(mesh, {V3d(x, front, z), V3d(x + width - 0.001, -0.03, z + height),
                                   color, random(7) < 0.6});
                x += width;
            }
            if (end < all) {
                const M44d leaning = M44d().setAxisAngle(V3d(0, 1, 0), -0.32) *
                                     M44d().setTranslation(V3d(x + 0.005 + 0.24 * 0.315, 0, z));
                append_book(mesh,
                            {V3d(0, -shelf_depth + 0.03, 0), V3d(0.028, -0.04, 0.24),
                             cover(random(8)), true},
                            leaning);
            }
        }
    }
    return mesh;
}

scene::Mesh pile_of_books(int count, std::uint32_t seed) {
    scene::Mesh mesh;
    double z = 0.0;
    for (int k = 0; k < count; ++k) {
        const double thickness = 0.02 + 0.02 * lattice_noise(k, 1, seed);
        // On its side: the spine stays at -y.
        const M44d placed =
            M44d().setAxisAngle(V3d(0, 1, 0), -pi / 2) *
            M44d().setTranslation(V3d(0.12, -0.085, z)) *
            M44d().setAxisAngle(V3d(0, 0, 1), 0.5 * (lattice_noise(k, 2, seed) - 0.5));
        append_book(
            mesh,
            {V3d(0, 0, 0), V3d(thickness, 0.17, 0.24), cover(lattice_noise(k, 3, seed)), true},
            placed);
        z += thickness + 0.001;
    }
    return mesh;
}

Fireplace fireplace(double ceiling) {
    constexpr double opening_half = 0.46;
    constexpr double opening_height = 0.74;
    Fireplace made;
    const double half = breast_width / 2;
    const double front = -breast_depth;
    made.breast.box(V3d(-half, front, 0), V3d(-opening_half, 0, ceiling));
    made.breast.box(V3d(opening_half, front, 0), V3d(half, 0, ceiling));
    made.breast.box(V3d(-opening_half, front, opening_height), V3d(opening_half, 0, ceiling));
    made.hearth.quad(V3d(-opening_half, -0.01, 0), V3d(opening_half, -0.01, 0),
                     V3d(opening_half, -0.01, opening_height),
                     V3d(-opening_half, -0.01, opening_height));
    made.hearth.box(V3d(-opening_half, front - 0.3, 0), V3d(opening_half, 0, 0.03));
    made.hearth.box(V3d(-0.8, front - 0.34, 0), V3d(0.8, front, 0.028), 0.006);
    for (const double side : {-1.0, 1.0}) {
        const double inner = side * opening_half;
        const double outer = side * (opening_half + 0.2);
        made.surround.box(V3d(std::min(inner, outer), front - 0.05, 0.028),
                          V3d(std::max(inner, outer), front, 0.93), 0.008);
        made.surround.box(V3d(std::min(inner, outer) - 0.02, front - 0.07, 0.028),
                          V3d(std::max(inner, outer) + 0.02, front, 0.16), 0.01);
    }
    made.surround.box(V3d(-0.68, front - 0.05, opening_height), V3d(0.68, front, 1.02), 0.008);
    made.surround.box(V3d(-0.14, front - 0.07, opening_height - 0.02), V3d(0.14, front, 1.02),
                      0.015);
    made.surround.box(V3d(-0.78, front - 0.12, 1.02), V3d(0.78, front, 1.07), 0.02);
    made.surround.box(V3d(-0.86, front - 0.2, 1.07), V3d(0.86, front, mantel_height), 0.012);
    for (const double y : {front + 0.06, front + 0.2}) {
        rod(made.logs, V3d(-0.3, y, 0.1), V3d(0.28, y + 0.03, 0.09), 0.05, 0.055);
    }
    rod(made.logs, V3d(-0.26, front + 0.1, 0.2), V3d(0.2, front + 0.17, 0.16), 0.045, 0.05);
    for (int k = 0; k < 5; ++k) {
        const double size = 0.13 + 0.13 * std::sin(pi * (k + 1) / 6.0);
        const double x = -0.2 + 0.1 * k;
        made.flames.tube({{V3d(x, front + 0.13, 0.17), 0.35 * size},
                          {V3d(x + 0.01, front + 0.13, 0.17 + 0.5 * size), 0.27 * size},
                          {V3d(x - 0.01, front + 0.13, 0.17 + 1.0 * size), 0.12 * size},
                          {V3d(x + 0.01, front + 0.13, 0.17 + 1.35 * size), 0.01}},
                         10);
    }
    return made;
}

LongcaseClock longcase_clock() {
    LongcaseClock made;
    made.wood.box(V3d(-0.26, -0.28, 0), V3d(0.26, 0, 0.1), 0.01);
    made.wood.box(V3d(-0.24, -0.26, 0.1), V3d(0.24, 0, 0.55), 0.01);
    made.wood.box(V3d(-0.26, -0.28, 0.55), V3d(0.26, 0, 0.59), 0.012);
    made.wood.box(V3d(-0.18, -0.2, 0.59), V3d(0.18, 0, 1.62), 0.01);
    made.wood.box(V3d(-0.26, -0.26, 1.62), V3d(0.26, 0, 1.66), 0.012);
    made.wood.box(V3d(-0.24, -0.18, 1.66), V3d(0.24, 0, 2.18), 0.01);
    made.wood.box(V3d(-0.28, -0.24, 2.18), V3d(0.28, 0, 2.24), 0.015);
    std::vector<V2d> low, high;
    for (int k = 0; k <= 16; ++k) {
        const double x = -0.26 + 0.52 * k / 16;
        low.emplace_back(x, 2.23);
        high.emplace_back(x, 2.24 + 0.16 * std::pow(std::cos(x / 0.26 * pi / 2), 2.0));
    }
    made.wood.band(low, high, -0.2, 0.0);
    // The door of the trunk with its pendulum, and a knob on top.
    for (const double x : {-0.13, 0.115}) {
        made.wood.box(V3d(x, -0.215, 0.7), V3d(x + 0.015, -0.19, 1.52), 0.003);
    }
    made.brass.box(V3d(-0.006, -0.212, 0.95), V3d(0.006, -0.2, 1.5));
    made.brass.ellipsoid(V3d(0, -0.21, 0.9), V3d(0.075, 0.016, 0.075));
    made.brass.ellipsoid(V3d(0, -0.1, 2.45), V3d(0.04, 0.04, 0.05));
    return made;
}

Dresser dresser() {
    Dresser made;
    made.wood.box(V3d(-0.53, -0.43, 0.08), V3d(0.53, 0, 0.82), 0.006);
    made.wood.box(V3d(-0.55, -0.45, 0.82), V3d(0.55, 0, 0.85), 0.008);
    for (const double x : {-0.48, 0.42}) {
        made.wood.box(V3d(x, -0.42, 0), V3d(x + 0.06, -0.02, 0.09), 0.004);
    }
    for (int row = 0; row < 3; ++row) {
        for (const double x : {-0.515, 0.01}) {
            const double z = 0.11 + 0.235 * row;
            made.wood.box(V3d(x, -0.445, z), V3d(x + 0.505, -0.42, z + 0.22), 0.008);
            made.knobs.ellipsoid(V3d(x + 0.2525, -0.455, z + 0.11), V3d(0.018), 12);
        }
    }
    return made;
}

Door door() {
    Door made;
    made.leaf.box(V3d(-0.5, -0.03, 0), V3d(0.5, 0, 2.1));
    for (const auto& [low, high] : {V2d(0.2, 0.9), V2d(1.05, 1.95)}) {
        for (const double x : {-0.4, 0.04}) {
            made.leaf.box(V3d(x, -0.05, low), V3d(x + 0.36, -0.02, high), 0.018);
        }
    }
    for (const double x : {-0.6, 0.5}) {
        made.leaf.box(V3d(x, -0.06, 0), V3d(x + 0.1, 0, 2.2), 0.012);
    }
    made.leaf.box(V3d(-0.6, -0.06, 2.1), V3d(0.6, 0, 2.2), 0.012);
    made.handle.box(V3d(0.41, -0.036, 0.94), V3d(0.455, -0.028, 1.12), 0.003);
    made.handle.ellipsoid(V3d(0.432, -0.075, 1.03), V3d(0.028));
    return made;
}

Lamp floor_lamp() {
    Lamp made;
    made.metal.lathe(
        V3d(0.0),
        {{0.15, 0}, {0.15, 0.015}, {0.02, 0.03}, {0.012, 0.05}, {0.012, 1.5}, {0.0, 1.5}});
    made.shade.lathe(V3d(0, 0, 1.35), {{0.24, 0}, {0.16, 0.3}}, 40);
    return made;
}

Lamp pendant() {
    Lamp made;
    made.metal.lathe(V3d(0, 0, -0.04), {{0.0, 0.0}, {0.02, 0.0}, {0.06, 0.03}, {0.06, 0.04}});
    rod(made.metal, V3d(0, 0, -0.32), V3d(0, 0, -0.01), 0.006, 0.006);
    made.metal.lathe(V3d(0, 0, -0.34), {{0.06, 0.0}, {0.05, 0.03}, {0.0, 0.04}});
    made.shade.ellipsoid(V3d(0, 0, -0.48), V3d(0.17, 0.17, 0.15), 32);
    return made;
}

scene::Mesh curtain(double width, double height) {
    return smooth_surface(72, 10, [&](double u, double v) {
        const double drop = 1.0 - v;
        const double fold = 0.035 * (0.6 + 0.4 * drop);
        const double x = (u - 0.5) * width * (0.92 + 0.08 * drop);
        return V3d(x + 0.01 * std::sin(9.0 * pi * u + 1.0), fold * std::cos(12.0 * pi * u + v),
                   -drop * height);
    });
}

}  // namespace balcony::plates::room
