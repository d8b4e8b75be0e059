// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/surfaces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace balcony::plates {

namespace {

using scene::Mesh;
using scene::V3d;
using scene::V3f;

// The tangent along one parameter by a central difference that stays within [0, 1].
V3d difference(const std::function<V3d(double)>& along, double at) {
    constexpr double step = 1e-4;
    return along(std::min(at + step, 1.0)) - along(std::max(at - step, 0.0));
}

}  // namespace

Mesh smooth_surface(int columns, int rows, const SurfacePoint& point) {
    Mesh mesh;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            const double u = static_cast<double>(i) / columns;
            const double v = static_cast<double>(j) / rows;
            // A pole has no tangent of its own along u or v: use that of a place nearby.
            const double near_u = std::clamp(u, 1e-3, 1.0 - 1e-3);
            const double near_v = std::clamp(v, 1e-3, 1.0 - 1e-3);
            const V3d along_u = difference([&](double t) { return point(t, near_v); }, u);
            const V3d along_v = difference([&](double t) { return point(near_u, t); }, v);
            mesh.positions.emplace_back(point(u, v));
            mesh.normals.emplace_back(along_u.cross(along_v).normalized());
            mesh.texture_coordinates[0].emplace_back(static_cast<float>(u),
                                                     static_cast<float>(1.0 - v));
        }
    }
    const auto index = [columns](int i, int j) {
        return static_cast<std::uint32_t>(j * (columns + 1) + i);
    };
    // At a pole, where a side has no length, every second triangle is left out.
    const auto add = [&mesh](const std::array<std::uint32_t, 3>& corners) {
        const auto& [a, b, c] = corners;
        const auto apart = [&](std::uint32_t p, std::uint32_t q) {
            return (mesh.positions[p] - mesh.positions[q]).length() > 1e-6F;
        };
        if (apart(a, b) && apart(b, c) && apart(c, a)) {
            mesh.triangles.push_back(corners);
        }
    };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            add({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
            add({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
        }
    }
    return mesh;
}

}  // namespace balcony::plates
