// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/soft/letters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "common/meshes.hpp"

namespace balcony::plates {

namespace {

using scene::Mesh;
using scene::V3d;

// Letters are bent from a round bar, about the point in their middle.
constexpr double bend = 4.0;
constexpr double bar = 1.5;
constexpr int bend_steps = 48;  // Of half a circle.

constexpr int tube_sides = 48;

// The circle of a tube: all its normals lean along the way by the same sine.
struct Ring {
    V3d center;
    V3d along;  // Unit.
    double radius;
    double lean;
};

void add_ring(Mesh& mesh, const Ring& ring) {
    const V3d across(0.0, 1.0, 0.0);
    const V3d aside = across.cross(ring.along);
    for (int i = 0; i < tube_sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / tube_sides;
        const V3d outward = std::cos(angle) * aside + std::sin(angle) * across;
        mesh.positions.emplace_back(ring.center + ring.radius * outward);
        mesh.normals.emplace_back(std::sqrt(1.0 - ring.lean * ring.lean) * outward +
                                  ring.lean * ring.along);
    }
}

// Triangles between two rings; a ring that is a point, at the end of a bar, has fewer.
void join_rings(Mesh& mesh, const std::vector<Ring>& rings, std::uint32_t lower,
                std::uint32_t upper) {
    constexpr double point = 1e-9;
    for (std::uint32_t i = 0; i < tube_sides; ++i) {
        const std::uint32_t next = (i + 1) % tube_sides;
        const std::uint32_t a = lower * tube_sides + i;
        const std::uint32_t b = lower * tube_sides + next;
        const std::uint32_t c = upper * tube_sides + next;
        const std::uint32_t d = upper * tube_sides + i;
        if (rings[lower].radius > point) {
            mesh.triangles.push_back({a, b, c});
        }
        if (rings[upper].radius > point) {
            mesh.triangles.push_back({a, c, d});
        }
    }
}

// The circles of a half sphere beyond the end of a tube, from its equator's neighbour to its pole.
void add_cap(std::vector<Ring>& rings, const V3d& end, const V3d& along, double radius) {
    constexpr int steps = tube_sides / 4;
    for (int i = 1; i <= steps; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / steps;
        rings.push_back({end + radius * std::sin(angle) * along, along, radius * std::cos(angle),
                         std::sin(angle)});
    }
}

std::vector<V3d> arc(const V3d& center, double radius, double from, double to, int steps) {
    std::vector<V3d> points;
    for (int i = 0; i <= steps; ++i) {
        const double angle = from + (to - from) * i / steps;
        points.push_back(center + radius * V3d(std::cos(angle), 0.0, std::sin(angle)));
    }
    return points;
}

// A bar along a smooth path in the xz plane. Its ends are half spheres beyond the path, or it is a
// ring whose last point is joined to the first.
enum class Ends { round, closed };

Mesh bent_bar(const std::vector<V3d>& path, Ends ends) {
    const bool closed = ends == Ends::closed;
    const std::size_t count = path.size();
    const auto along = [&](std::size_t i) {
        const V3d& before = i > 0 ? path[i - 1] : closed ? path[count - 1] : path[0];
        const V3d& after = i + 1 < count ? path[i + 1] : closed ? path[0] : path[count - 1];
        return (after - before).normalized();
    };
    std::vector<Ring> rings;
    if (!closed) {
        add_cap(rings, path.front(), -along(0), bar);
        std::reverse(rings.begin(), rings.end());
        for (Ring& ring : rings) {
            ring.along = -ring.along;
            ring.lean = -ring.lean;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        rings.push_back({path[i], along(i), bar, 0.0});
    }
    if (!closed) {
        add_cap(rings, path.back(), along(count - 1), bar);
    }
    Mesh mesh;
    for (const Ring& ring : rings) {
        add_ring(mesh, ring);
    }
    for (std::uint32_t i = 0; i + 1 < rings.size(); ++i) {
        join_rings(mesh, rings, i, i + 1);
    }
    if (closed) {
        join_rings(mesh, rings, static_cast<std::uint32_t>(rings.size()) - 1, 0);
    }
    return mesh;
}

Mesh straight(const V3d& from, const V3d& to) { return bent_bar({from, to}, Ends::round); }

}  // namespace

// Three quarters of a circle above, three quarters below, which meet in the middle.
Mesh letter_s() {
    constexpr double pi = std::numbers::pi;
    constexpr int steps = bend_steps * 3 / 2;
    std::vector<V3d> path = arc(V3d(0, 0, bend), bend, 0.0, 1.5 * pi, steps);
    const std::vector<V3d> below = arc(V3d(0, 0, -bend), bend, 0.5 * pi, -pi, steps);
    path.insert(path.end(), below.begin() + 1, below.end());
    return bent_bar(path, Ends::round);
}

Mesh letter_o() {
    constexpr double pi = std::numbers::pi;
    std::vector<V3d> path = arc(V3d(0, 0, bend), bend, 0.0, pi, bend_steps);
    const std::vector<V3d> below = arc(V3d(0, 0, -bend), bend, pi, 2.0 * pi, bend_steps);
    path.insert(path.end(), below.begin(), below.end());
    return bent_bar(path, Ends::closed);
}

Mesh letter_f() {
    Mesh mesh = straight(V3d(-bend, 0, -2 * bend), V3d(-bend, 0, 2 * bend));
    append(mesh, straight(V3d(-bend, 0, 0), V3d(1.5, 0, 0)));
    append(mesh, straight(V3d(-bend, 0, 2 * bend), V3d(bend, 0, 2 * bend)));
    return mesh;
}

Mesh letter_t() {
    Mesh mesh = straight(V3d(0, 0, -2 * bend), V3d(0, 0, 2 * bend));
    append(mesh, straight(V3d(-bend, 0, 2 * bend), V3d(bend, 0, 2 * bend)));
    return mesh;
}

}  // namespace balcony::plates
