// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/tubes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace balcony::plates {

namespace {

using scene::Mesh;
using scene::V2f;
using scene::V3d;
using scene::V3f;

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

void join_rings(Mesh& mesh, std::uint32_t lower, std::uint32_t upper) {
    for (std::uint32_t i = 0; i < tube_sides; ++i) {
        const std::uint32_t next = (i + 1) % tube_sides;
        const std::uint32_t a = lower * tube_sides + i;
        const std::uint32_t b = lower * tube_sides + next;
        const std::uint32_t c = upper * tube_sides + next;
        const std::uint32_t d = upper * tube_sides + i;
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
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

}  // namespace

std::vector<V3d> arc(const V3d& center, double radius, double from, double to, int steps) {
    std::vector<V3d> points;
    for (int i = 0; i <= steps; ++i) {
        const double angle = from + (to - from) * i / steps;
        points.push_back(center + radius * V3d(std::cos(angle), 0.0, std::sin(angle)));
    }
    return points;
}

Mesh tube(const std::vector<V3d>& path, double radius, TubeEnds ends) {
    const bool closed = ends == TubeEnds::closed;
    const std::size_t count = path.size();
    const auto along = [&](std::size_t i) {
        const V3d& before = i > 0 ? path[i - 1] : closed ? path[count - 1] : path[0];
        const V3d& after = i + 1 < count ? path[i + 1] : closed ? path[0] : path[count - 1];
        return (after - before).normalized();
    };
    std::vector<Ring> rings;
    if (!closed) {
        add_cap(rings, path.front(), -along(0), radius);
        std::reverse(rings.begin(), rings.end());
        for (Ring& ring : rings) {
            ring.along = -ring.along;
            ring.lean = -ring.lean;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        rings.push_back({path[i], along(i), radius, 0.0});
    }
    if (!closed) {
        add_cap(rings, path.back(), along(count - 1), radius);
    }
    Mesh mesh;
    for (const Ring& ring : rings) {
        add_ring(mesh, ring);
    }
    for (std::uint32_t i = 0; i + 1 < rings.size(); ++i) {
        join_rings(mesh, i, i + 1);
    }
    if (closed) {
        join_rings(mesh, static_cast<std::uint32_t>(rings.size()) - 1, 0);
    }
    return mesh;
}

Mesh lathe(const std::vector<V3d>& profile, int sides) {
    Mesh mesh;
    std::vector<double> lengths{0.0};
    for (std::size_t i = 1; i < profile.size(); ++i) {
        lengths.push_back(lengths.back() + (profile[i] - profile[i - 1]).length());
    }
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const V3d& before = profile[i > 0 ? i - 1 : 0];
        const V3d& after = profile[std::min(i + 1, profile.size() - 1)];
        const V3d along = (after - before).normalized();
        for (int k = 0; k <= sides; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / sides;
            const double c = std::cos(angle);
            const double s = std::sin(angle);
            mesh.positions.emplace_back(profile[i].x * c, profile[i].x * s, profile[i].z);
            mesh.normals.emplace_back(-along.z * c, -along.z * s, along.x);
            mesh.texture_coordinates[0].emplace_back(static_cast<double>(k) / sides,
                                                     1.0 - lengths[i] / lengths.back());
        }
    }
    const auto stride = static_cast<std::uint32_t>(sides + 1);
    for (std::uint32_t i = 0; i + 1 < profile.size(); ++i) {
        for (std::uint32_t k = 0; k < stride - 1; ++k) {
            const std::uint32_t a = i * stride + k;
            const std::uint32_t b = a + stride;
            mesh.triangles.push_back({a, b, b + 1});
            mesh.triangles.push_back({a, b + 1, a + 1});
        }
    }
    return mesh;
}

void append(Mesh& mesh, const Mesh& part) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
    for (std::size_t set = 0; set < mesh.texture_coordinates.size(); ++set) {
        mesh.texture_coordinates[set].insert(mesh.texture_coordinates[set].end(),
                                             part.texture_coordinates[set].begin(),
                                             part.texture_coordinates[set].end());
    }
    mesh.colors.insert(mesh.colors.end(), part.colors.begin(), part.colors.end());
    for (const auto& [a, b, c] : part.triangles) {
        mesh.triangles.push_back({first + a, first + b, first + c});
    }
}

}  // namespace balcony::plates
