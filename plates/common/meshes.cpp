// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/meshes.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "common/mesh_builder.hpp"

namespace balcony::plates {

namespace {

using scene::Mesh;
using scene::V2f;
using scene::V3d;
using scene::V3f;

// Adds a flat convex polygon, turned so that its normal points to the same side as outward does.
void add_polygon(Mesh& mesh, std::span<const V3d> corners, const V3d& outward) {
    const V3d cross = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const bool turned = cross.dot(outward) < 0.0;
    const V3f normal(turned ? -cross.normalized() : cross.normalized());
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const V3d& corner : corners) {
        mesh.positions.emplace_back(corner);
        mesh.normals.push_back(normal);
    }
    for (std::uint32_t k = 2; k < corners.size(); ++k) {
        mesh.triangles.push_back(
            {first, first + (turned ? k : k - 1), first + (turned ? k - 1 : k)});
    }
}

}  // namespace

Mesh chamfered_cube(double size, double chamfer) {
    return MeshBuilder().box(V3d(-size / 2), V3d(size / 2), chamfer).mesh();
}

Mesh cylinder(int axis, double length, double radius) {
    constexpr std::uint32_t segments = 24;
    Mesh mesh;
    for (std::uint32_t k = 0; k <= segments; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / segments;
        V3d normal(0.0);
        normal[(axis + 1) % 3] = std::cos(angle);
        normal[(axis + 2) % 3] = std::sin(angle);
        for (const double end : {-0.5, 0.5}) {
            V3d position = normal * radius;
            position[axis] = end * length;
            mesh.positions.emplace_back(position);
            mesh.normals.emplace_back(normal);
        }
    }
    for (std::uint32_t k = 0; k < segments; ++k) {
        const std::uint32_t i = 2 * k;
        mesh.triangles.push_back({i, i + 2, i + 1});
        mesh.triangles.push_back({i + 1, i + 2, i + 3});
    }
    return mesh;
}

Mesh rectangle(double width, double height, double repeat_x, double repeat_y) {
    Mesh mesh;
    const std::array<V3d, 4> corners{V3d(-width / 2, -height / 2, 0),
                                     V3d(width / 2, -height / 2, 0), V3d(width / 2, height / 2, 0),
                                     V3d(-width / 2, height / 2, 0)};
    add_polygon(mesh, corners, V3d(0, 0, 1));
    const auto right = static_cast<float>(repeat_x);
    const auto bottom = static_cast<float>(repeat_y);
    mesh.texture_coordinates[0] = {V2f(0, bottom), V2f(right, bottom), V2f(right, 0), V2f(0, 0)};
    return mesh;
}

Mesh picture_frame(double width, double height, double moulding_width) {
    // Profile of the moulding: distance from the rectangle's edge, in frame widths, and height.
    const std::array<std::array<double, 2>, 6> profile{
        {{0.0, 0.0}, {0.18, 0.10}, {0.30, 0.06}, {0.75, 0.42}, {1.0, 0.34}, {1.0, -0.25}}};
    Mesh mesh;
    for (int side = 0; side < 4; ++side) {
        const auto corner = [&](int which, const std::array<double, 2>& at) {
            const double x = width / 2 + at[0] * moulding_width;
            const double y = height / 2 + at[0] * moulding_width;
            const int k = (side + which) % 4;  // Counter-clockwise from the lower left.
            return V3d(k == 1 || k == 2 ? x : -x, k >= 2 ? y : -y, at[1]);
        };
        const V3d away = V3d(side == 1   ? 1
                             : side == 3 ? -1
                                         : 0,
                             side == 0   ? -1
                             : side == 2 ? 1
                                         : 0,
                             0);
        for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
            const std::array<V3d, 4> strip{corner(0, profile[k]), corner(1, profile[k]),
                                           corner(1, profile[k + 1]), corner(0, profile[k + 1])};
            add_polygon(mesh, strip, profile[k + 1][0] > profile[k][0] ? V3d(0, 0, 1) : away);
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
