// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/temple/arcade.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "common/meshes.hpp"
#include "common/mouldings.hpp"
#include "scenes/temple/dimensions.hpp"
#include "scenes/temple/marble.hpp"

namespace balcony::plates::temple {

namespace {

using scene::Mesh;
using std::numbers::pi;

constexpr double joint = 0.004;  // Half the width of a gap between blocks, in metres.
constexpr double floor_radius = 11.5;

// Each block shows another part of the marble's tile.
Mesh as_block(Mesh mesh, int number, double variation = 0.16) {
    set_color(mesh, block_tint(number, variation));
    const V2d by(lattice_noise(number, 1, 131), lattice_noise(number, 2, 131));
    for (scene::V2f& at : mesh.texture_coordinates[0]) {
        at += scene::V2f(by);
    }
    return mesh;
}

// A course of blocks: the profile turned about the axis, with gaps.
Mesh course(const Profile& profile, int blocks, int segments, double first, int number) {
    Mesh mesh;
    const double step = 2.0 * pi / blocks;
    for (int k = 0; k < blocks; ++k) {
        const double from = first + k * step;
        const Turn turn{from + joint / radius, from + step - joint / radius};
        append(mesh, as_block(revolve(profile, segments, turn, marble_size), number + k));
    }
    return mesh;
}

// The wall of an arch is drawn flat, with the length s along the columns' circle, and bent.
V3d bent(double middle, double s, double z, double r) {
    const double angle = middle + s / radius;
    return {r * std::cos(angle), r * std::sin(angle), z};
}

// A band of the wall round its opening: between two radii from the arch's centre, as voussoirs.
void add_archivolt(Mesh& mesh, double middle, int number, bool outside) {
    // Distance from the edge of the opening, and height above the wall.
    constexpr std::array<std::array<double, 2>, 7> section{{{0.0, 0.0},
                                                            {0.0, 0.035},
                                                            {0.13, 0.035},
                                                            {0.13, 0.065},
                                                            {0.26, 0.065},
                                                            {0.31, 0.1},
                                                            {0.34, 0.0}}};
    constexpr int stones = 11;
    constexpr int pieces = 4;
    const double face = outside ? wall_outer : wall_inner;
    const double out = outside ? 1.0 : -1.0;
    for (int stone = 0; stone < stones; ++stone) {
        Mesh made;
        for (std::size_t k = 0; k + 1 < section.size(); ++k) {
            std::vector<V3d> points;
            for (const auto& [from_edge, height] : {section[k], section[k + 1]}) {
                for (int i = 0; i <= pieces; ++i) {
                    const double turn = (stone + static_cast<double>(i) / pieces) / stones;
                    const double gap = i == 0 ? 0.0025 : i == pieces ? -0.0025 : 0.0;
                    const double angle = outside ? pi * (1.0 - turn) - gap : pi * turn + gap;
                    const double rho = arch_radius + from_edge;
                    points.push_back(bent(middle, rho * std::cos(angle),
                                          spring_z + rho * std::sin(angle), face + out * height));
                }
            }
            append(made, grid(pieces + 1, points, marble_size));
        }
        append(mesh, as_block(std::move(made), number * 40 + stone + (outside ? 0 : 20), 0.2));
    }
}

}  // namespace

Mesh arch(int number) {
    constexpr int pieces = 24;
    const double middle = (number - 0.5) * bay;
    const double half = radius * bay / 2.0;
    // The lower edge of the wall: level above the columns, then round the opening.
    std::vector<V2d> edge{V2d(-half, spring_z)};
    for (int k = 0; k <= pieces; ++k) {
        const double angle = pi * (1.0 - static_cast<double>(k) / pieces);
        edge.emplace_back(arch_radius * std::cos(angle), spring_z + arch_radius * std::sin(angle));
    }
    edge.emplace_back(half, spring_z);
    const auto columns = static_cast<std::uint32_t>(edge.size());

    Mesh wall;
    const auto add = [&](double low_r, bool low_is_edge, double high_r, bool reversed) {
        std::vector<V3d> points;
        for (const bool upper : {false, true}) {
            for (std::size_t k = 0; k < edge.size(); ++k) {
                const V2d& at = edge[reversed ? edge.size() - 1 - k : k];
                const bool on_edge = !upper || !low_is_edge;
                points.push_back(
                    bent(middle, at.x, on_edge ? at.y : ring_z, upper ? high_r : low_r));
            }
        }
        append(wall, grid(columns, points, marble_size));
    };
    add(wall_outer, true, wall_outer, false);
    add(wall_inner, true, wall_inner, true);
    add(wall_inner, false, wall_outer, false);
    Mesh mesh = as_block(std::move(wall), number, 0.1);
    add_archivolt(mesh, middle, number, true);
    add_archivolt(mesh, middle, number, false);
    weather(mesh, 0.008, 0.5);
    return mesh;
}

Mesh ring() {
    constexpr int segments = 10;
    Mesh mesh;
    // Architrave: two fasciae and a moulding, on both sides.
    Profile architrave(V2d(9.46, ring_z));
    architrave.line({10.54, ring_z}).line({10.54, ring_z + 0.22}).line({10.59, ring_z + 0.22});
    architrave.line({10.59, ring_z + 0.46})
        .arc({10.7, ring_z + 0.56}, -0.2)
        .line({10.7, ring_z + 0.6});
    architrave.line({9.36, ring_z + 0.6}).line({9.36, ring_z + 0.5}).line({9.46, ring_z + 0.44});
    architrave.line({9.46, ring_z});
    append(mesh, course(architrave, column_count, 2 * segments, 0.0, 1000));

    Profile frieze(V2d(9.46, ring_z + 0.6));
    frieze.line({10.52, ring_z + 0.6}).arc({10.52, ring_z + 1.1}, 0.06).line({9.46, ring_z + 1.1});
    frieze.line({9.46, ring_z + 0.6});
    append(mesh, course(frieze, column_count, 2 * segments, bay / 2, 1100));

    Profile cornice(V2d(9.3, ring_z + 1.1));
    cornice.line({10.58, ring_z + 1.1}).arc({10.7, ring_z + 1.2}, 0.2).line({10.7, ring_z + 1.42});
    cornice.line({11.16, ring_z + 1.45}).line({11.16, ring_z + 1.58}).line({11.2, ring_z + 1.58});
    cornice.arc({11.36, ring_z + 1.78}, -0.15).line({11.36, top_z}).line({11.3, top_z + 0.01});
    cornice.line({9.25, top_z + 0.06}).line({9.18, top_z}).line({9.18, ring_z + 1.5});
    cornice.arc({9.3, ring_z + 1.3}, -0.15).line({9.3, ring_z + 1.1});
    append(mesh, course(cornice, 2 * column_count, segments, 0.0, 1200));

    constexpr int dentils = 14 * 12;
    Profile dentil(V2d(10.68, ring_z + 1.24));
    dentil.line({10.88, ring_z + 1.24}).line({10.88, ring_z + 1.42});
    for (int k = 0; k < dentils; ++k) {
        const double from = 2.0 * pi * k / dentils;
        const Turn turn{from, from + 2.0 * pi / dentils * 0.6};
        Mesh made = revolve(dentil, 1, turn, marble_size);
        for (const double side : {turn.from, turn.to}) {
            std::vector<V3d> points;
            for (const double z : {1.24, 1.42}) {
                for (const double r : {10.68, 10.88}) {
                    const double flipped = side == turn.from ? r : 21.56 - r;
                    points.emplace_back(flipped * std::cos(side), flipped * std::sin(side),
                                        ring_z + z);
                }
            }
            append(made, grid(2, points, marble_size));
        }
        append(mesh, as_block(std::move(made), 1400 + k));
    }
    weather(mesh, 0.012, 0.45);
    return mesh;
}

Mesh steps() {
    Mesh mesh;
    constexpr double height = floor_z / 3.0;
    for (int step = 0; step < 3; ++step) {
        const double r = 12.6 - 0.5 * step;
        const double low = step * height;
        Profile profile(V2d(r, low - (step == 0 ? 0.6 : 0.0)));
        profile.line({r, low + height - 0.02}).arc({r - 0.02, low + height}, 0.2, 3);
        profile.line({step == 2 ? floor_radius - 0.01 : r - 0.52, low + height});
        append(mesh, course(profile, 4 * column_count, 6, step % 2 == 0 ? 0.0 : bay / 8,
                            2000 + 100 * step));
    }
    weather(mesh, 0.012, 0.6);
    return mesh;
}

Mesh floor_disc() {
    Profile profile(V2d(floor_radius, floor_z));
    profile.line({0.0, floor_z});
    Mesh mesh = revolve(profile, 8 * column_count);
    for (std::size_t k = 0; k < mesh.positions.size(); ++k) {
        const scene::V3f& p = mesh.positions[k];
        const V2d at(p.x / floor_radius, p.y / floor_radius);
        mesh.texture_coordinates[0][k] = scene::V2f(V2d(0.5 + at.x / 2, 0.5 - at.y / 2));
    }
    return mesh;
}

}  // namespace balcony::plates::temple
