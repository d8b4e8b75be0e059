// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/mouldings.hpp"

#include <cassert>
#include <cmath>

namespace balcony::plates {

namespace {

using scene::Mesh;
using scene::V2f;
using scene::V3f;

// The triangles between two neighbouring rows of vertices; the front is right x up.
void add_cells(Mesh& mesh, std::uint32_t first, std::uint32_t columns, std::uint32_t rows) {
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t low = first + row * columns + column;
            const std::uint32_t high = low + columns;
            // On the axis, the two corners of a side are one point.
            if (mesh.positions[low] != mesh.positions[low + 1]) {
                mesh.triangles.push_back({low, low + 1, high + 1});
            }
            if (mesh.positions[high] != mesh.positions[high + 1]) {
                mesh.triangles.push_back({low, high + 1, high});
            }
        }
    }
}

V2d direction_at(const Profile::Run& run, std::size_t k) {
    const V2d& before = run[k > 0 ? k - 1 : 0];
    const V2d& after = run[k + 1 < run.size() ? k + 1 : k];
    return (after - before).normalized();
}

}  // namespace

Profile& Profile::line(const V2d& to) {
    runs_.push_back({at_, to});
    at_ = to;
    return *this;
}

Profile& Profile::arc(const V2d& to, double bulge, int pieces) {
    const V2d half = (to - at_) / 2.0;
    const V2d right(half.y, -half.x);
    // An arc of height bulge over a chord of length 1 spans four times this angle.
    const double quarter = std::atan(2.0 * bulge);
    Run run;
    for (int k = 0; k <= pieces; ++k) {
        const double angle = 2.0 * quarter * (2.0 * k / pieces - 1.0);
        const double radius = 1.0 / std::sin(2.0 * quarter);
        const double along = radius * std::sin(angle);
        const double across = radius * (std::cos(angle) - std::cos(2.0 * quarter));
        run.push_back(at_ + half * (1.0 + along) + right * across);
    }
    runs_.push_back(std::move(run));
    at_ = to;
    return *this;
}

Mesh revolve(const Profile& profile, int segments, const Turn& turn, double texture_size) {
    Mesh mesh;
    const auto columns = static_cast<std::uint32_t>(segments) + 1;
    double radius = 0.0;
    for (const Profile::Run& run : profile.runs()) {
        for (const V2d& point : run) {
            radius = std::max(radius, point.x);
        }
    }
    double length = 0.0;
    for (const Profile::Run& run : profile.runs()) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (std::size_t k = 0; k < run.size(); ++k) {
            length += k > 0 ? (run[k] - run[k - 1]).length() : 0.0;
            const V2d along = direction_at(run, k);
            for (std::uint32_t column = 0; column < columns; ++column) {
                const double angle = std::lerp(turn.from, turn.to, column / (columns - 1.0));
                const double c = std::cos(angle);
                const double s = std::sin(angle);
                mesh.positions.push_back(V3f(V3d(run[k].x * c, run[k].x * s, run[k].y)));
                mesh.normals.push_back(V3f(V3d(along.y * c, along.y * s, -along.x)));
                mesh.texture_coordinates[0].push_back(
                    V2f(V2d(radius * angle, -length) / texture_size));
            }
        }
        add_cells(mesh, first, columns, static_cast<std::uint32_t>(run.size()));
    }
    return mesh;
}

Mesh grid(std::uint32_t columns, const std::vector<V3d>& points, double texture_size) {
    assert(columns >= 2 && points.size() % columns == 0);
    Mesh mesh;
    const auto rows = static_cast<std::uint32_t>(points.size() / columns);
    const auto at = [&](std::uint32_t column, std::uint32_t row) -> const V3d& {
        return points[row * columns + column];
    };
    std::vector<double> up(columns, 0.0);
    for (std::uint32_t row = 0; row < rows; ++row) {
        double along = 0.0;
        for (std::uint32_t column = 0; column < columns; ++column) {
            const V3d right =
                at(std::min(column + 1, columns - 1), row) - at(column > 0 ? column - 1 : 0, row);
            const V3d upwards =
                at(column, std::min(row + 1, rows - 1)) - at(column, row > 0 ? row - 1 : 0);
            along += column > 0 ? (at(column, row) - at(column - 1, row)).length() : 0.0;
            up[column] += row > 0 ? (at(column, row) - at(column, row - 1)).length() : 0.0;
            mesh.positions.emplace_back(at(column, row));
            mesh.normals.emplace_back(right.cross(upwards).normalized());
            mesh.texture_coordinates[0].push_back(V2f(V2d(along, -up[column]) / texture_size));
        }
    }
    add_cells(mesh, 0, columns, rows);
    return mesh;
}

Mesh fan(const std::vector<V3d>& outline, double texture_size) {
    assert(outline.size() >= 3);
    V3d middle(0.0);
    V3d area(0.0);
    for (std::size_t k = 0; k < outline.size(); ++k) {
        middle += outline[k] / static_cast<double>(outline.size());
        area += outline[k].cross(outline[(k + 1) % outline.size()]);
    }
    const V3d normal = area.normalized();
    const V3d right = (outline.front() - middle).normalized();
    const V3d up = normal.cross(right);
    Mesh mesh;
    const auto add = [&](const V3d& point) {
        const V3d offset = point - middle;
        mesh.positions.emplace_back(point);
        mesh.normals.emplace_back(normal);
        mesh.texture_coordinates[0].push_back(
            V2f(V2d(offset.dot(right), -offset.dot(up)) / texture_size));
    };
    for (const V3d& point : outline) {
        add(point);
    }
    add(middle);
    const auto corners = static_cast<std::uint32_t>(outline.size());
    for (std::uint32_t k = 0; k < corners; ++k) {
        mesh.triangles.push_back({k, (k + 1) % corners, corners});
    }
    return mesh;
}

void set_color(Mesh& mesh, const Color& color) {
    mesh.colors.assign(mesh.positions.size(),
                       scene::Color4f(static_cast<float>(color.x), static_cast<float>(color.y),
                                      static_cast<float>(color.z), 1.0F));
}

Mesh moved(Mesh mesh, const scene::M44d& motion) {
    for (V3f& position : mesh.positions) {
        position = V3f(V3d(position) * motion);
    }
    for (V3f& normal : mesh.normals) {
        V3d turned;
        motion.multDirMatrix(V3d(normal), turned);
        normal = V3f(turned);
    }
    return mesh;
}

}  // namespace balcony::plates
