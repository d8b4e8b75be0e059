// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/solids.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace balcony::plates {

namespace {

using scene::Mesh;
using scene::V2f;
using scene::V3f;

constexpr double two_pi = 2.0 * std::numbers::pi;

// A point of a profile with its normal; a sharp edge has two, one for each side.
struct ProfilePoint {
    V2d at;
    V2d normal;
    double length;  // Of the profile up to here.
};

// The normal of a stretch of the profile, which points away from the axis where the profile rises.
V2d normal_of(const V2d& from, const V2d& to) {
    const V2d along = (to - from).normalized();
    return {along.y, -along.x};
}

std::vector<ProfilePoint> with_normals(std::span<const V2d> profile) {
    static const double sharp = std::cos(40.0 * std::numbers::pi / 180.0);
    std::vector<ProfilePoint> points;
    double length = 0.0;
    for (std::size_t k = 0; k < profile.size(); ++k) {
        length += k > 0 ? (profile[k] - profile[k - 1]).length() : 0.0;
        const bool first = k == 0;
        const bool last = k + 1 == profile.size();
        const V2d before = normal_of(profile[first ? 0 : k - 1], profile[first ? 1 : k]);
        const V2d after = last ? before : normal_of(profile[k], profile[k + 1]);
        if (before.dot(after) < sharp) {
            points.push_back({profile[k], before, length});
            points.push_back({profile[k], after, length});
        } else {
            points.push_back({profile[k], (before + after).normalized(), length});
        }
    }
    return points;
}

// The path's direction at point k.
V3d tangent_at(std::span<const V3d> path, std::size_t k, bool closed) {
    const std::size_t n = path.size();
    const V3d& before = k > 0 ? path[k - 1] : path[closed ? n - 1 : 0];
    const V3d& after = k + 1 < n ? path[k + 1] : path[closed ? 0 : n - 1];
    return (after - before).normalized();
}

// Some unit vector perpendicular to a direction.
V3d across(const V3d& direction) {
    const V3d axis = std::abs(direction.z) < 0.9 ? V3d(0, 0, 1) : V3d(1, 0, 0);
    return direction.cross(axis).normalized();
}

}  // namespace

Mesh lathe(std::span<const V2d> profile, int segments) {
    const std::vector<ProfilePoint> points = with_normals(profile);
    Mesh mesh;
    for (const ProfilePoint& point : points) {
        for (int k = 0; k <= segments; ++k) {
            const double angle = two_pi * k / segments;
            const V3d outward(std::cos(angle), std::sin(angle), 0.0);
            mesh.positions.emplace_back(outward * point.at.x + V3d(0, 0, point.at.y));
            mesh.normals.emplace_back(outward * point.normal.x + V3d(0, 0, point.normal.y));
            mesh.texture_coordinates[0].emplace_back(
                static_cast<float>(k) / static_cast<float>(segments),
                static_cast<float>(1.0 - point.length / points.back().length));
        }
    }
    // The two points of a sharp edge are at one place, and the triangles between them have no area.
    const auto columns = static_cast<std::uint32_t>(segments + 1);
    for (std::uint32_t row = 0; row + 1 < points.size(); ++row) {
        if (points[row].length == points[row + 1].length) {
            continue;
        }
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t i = row * columns + column;
            if (points[row].at.x > 0.0) {
                mesh.triangles.push_back({i, i + 1, i + columns});
            }
            if (points[row + 1].at.x > 0.0) {
                mesh.triangles.push_back({i + 1, i + columns + 1, i + columns});
            }
        }
    }
    return mesh;
}

Mesh sphere(double radius, int segments) {
    std::vector<V2d> profile;
    const int steps = segments / 2;
    for (int k = 0; k <= steps; ++k) {
        const double latitude = std::numbers::pi * (static_cast<double>(k) / steps - 0.5);
        const bool pole = k == 0 || k == steps;
        profile.emplace_back(pole ? 0.0 : radius * std::cos(latitude), radius * std::sin(latitude));
    }
    return lathe(profile, segments);
}

Mesh tube(std::span<const V3d> path, double radius, bool closed, int segments) {
    const std::size_t count = path.size() + (closed ? 1 : 0);
    std::vector<V3d> sides{across(tangent_at(path, 0, closed))};
    for (std::size_t k = 1; k < count; ++k) {
        const V3d along = tangent_at(path, k % path.size(), closed);
        sides.push_back((sides.back() - along * along.dot(sides.back())).normalized());
    }
    // The frame that comes back to the first point is turned against the one that left it; each
    // point takes its share of the angle.
    const V3d first_along = tangent_at(path, 0, closed);
    const double turned = closed ? std::atan2(first_along.cross(sides.front()).dot(sides.back()),
                                              sides.front().dot(sides.back()))
                                 : 0.0;
    Mesh mesh;
    for (std::size_t k = 0; k < count; ++k) {
        const V3d along = tangent_at(path, k % path.size(), closed);
        const V3d up = along.cross(sides[k]);
        const double share = static_cast<double>(k) / static_cast<double>(count - 1);
        for (int s = 0; s <= segments; ++s) {
            const double angle = two_pi * s / segments - turned * share;
            const V3d normal = sides[k] * std::cos(angle) + up * std::sin(angle);
            mesh.positions.emplace_back(path[k % path.size()] + normal * radius);
            mesh.normals.emplace_back(normal);
            mesh.texture_coordinates[0].emplace_back(
                static_cast<float>(share), static_cast<float>(s) / static_cast<float>(segments));
        }
    }
    const auto columns = static_cast<std::uint32_t>(segments + 1);
    for (std::uint32_t i = 0; i + columns < mesh.positions.size(); ++i) {
        if (i % columns + 1 < columns) {
            mesh.triangles.push_back({i, i + 1, i + columns});
            mesh.triangles.push_back({i + 1, i + columns + 1, i + columns});
        }
    }
    return mesh;
}

}  // namespace balcony::plates
