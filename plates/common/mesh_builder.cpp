// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/mesh_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace balcony::plates {

namespace {

using std::numbers::pi;

// The coordinate plane that a face is nearest to, seen from outside.
scene::V2f texture_place(const V3d& p, const V3d& normal) {
    const V3d size(std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z));
    if (size.z >= size.x && size.z >= size.y) {
        return scene::V2f(V2d(p.x, -p.y));
    }
    if (size.y >= size.x) {
        return scene::V2f(V2d(normal.y < 0.0 ? p.x : -p.x, -p.z));
    }
    return scene::V2f(V2d(normal.x > 0.0 ? p.y : -p.y, -p.z));
}

V3d on_circle(int k, int segments) {
    const double angle = 2.0 * pi * k / segments;
    return {std::cos(angle), std::sin(angle), 0.0};
}

// Unless it is without an area, as half of a quad with three corners is.
void add_triangle(scene::Mesh& mesh, const std::array<std::uint32_t, 3>& corners) {
    const auto& [a, b, c] = corners;
    const V3d from(mesh.positions[a]);
    const V3d cross = (V3d(mesh.positions[b]) - from).cross(V3d(mesh.positions[c]) - from);
    if (cross.length() > 1e-9) {
        mesh.triangles.push_back(corners);
    }
}

}  // namespace

MeshBuilder& MeshBuilder::quad(const V3d& a, const V3d& b, const V3d& c, const V3d& d) {
    const V3d normal = (c - a).cross(d - b).normalized();
    faces_.push_back({Corner{a, normal}, Corner{b, normal}, Corner{c, normal}, Corner{d, normal}});
    return *this;
}

MeshBuilder& MeshBuilder::box(const V3d& low, const V3d& high, double chamfer) {
    const V3d middle = (low + high) / 2.0;
    const V3d half = (high - low) / 2.0;
    // The corner with the signs s on a face: drawn inwards along the other two axes.
    const auto point = [&](const V3d& s, int face) {
        V3d p = s * (half - V3d(chamfer));
        p[face] = s[face] * half[face];
        return middle + p;
    };
    const auto face_towards = [&](const V3d& a, const V3d& b, const V3d& c, const V3d& d,
                                  const V3d& outward) {
        const bool turned = (c - a).cross(d - b).dot(outward) < 0.0;
        turned ? quad(a, d, c, b) : quad(a, b, c, d);
    };
    for (int face = 0; face < 3; ++face) {
        const int next = (face + 1) % 3;
        const int last = (face + 2) % 3;
        for (const double side : {-1.0, 1.0}) {
            const auto signs = [&](double along_next, double along_last) {
                V3d s;
                s[face] = side;
                s[next] = along_next;
                s[last] = along_last;
                return s;
            };
            V3d outward(0.0);
            outward[face] = side;
            face_towards(point(signs(-1, -1), face), point(signs(1, -1), face),
                         point(signs(1, 1), face), point(signs(-1, 1), face), outward);
            for (const double along : {-1.0, 1.0}) {
                if (chamfer <= 0.0) {
                    continue;
                }
                V3d diagonal = outward;
                diagonal[next] = along;
                face_towards(point(signs(along, -1), face), point(signs(along, 1), face),
                             point(signs(along, 1), next), point(signs(along, -1), next), diagonal);
            }
        }
    }
    for (int corner = 0; corner < 8 && chamfer > 0.0; ++corner) {
        const V3d s((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                    (corner & 4) != 0 ? 1 : -1);
        const bool turned = s.x * s.y * s.z < 0.0;
        triangle(point(s, 0), point(s, turned ? 2 : 1), point(s, turned ? 1 : 2));
    }
    return *this;
}

MeshBuilder& MeshBuilder::grid(const std::vector<std::vector<Corner>>& rows) {
    for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
        for (std::size_t i = 0; i + 1 < rows[j].size(); ++i) {
            const Face face{rows[j][i], rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i]};
            const V3d cross =
                (face[2].position - face[0].position).cross(face[3].position - face[1].position);
            if (cross.length() > 1e-12) {
                faces_.push_back(face);
            }
        }
    }
    return *this;
}

MeshBuilder& MeshBuilder::lathe(const V3d& foot, const std::vector<V2d>& profile, int segments) {
    // The normal of a point is that of its neighbours' chord, one-sided at ends and edges.
    const auto is_edge = [&](std::size_t i, std::size_t j) {
        return (profile[i] - profile[j]).length() < 1e-9;
    };
    for (std::size_t j = 0; j + 1 < profile.size(); ++j) {
        if (is_edge(j, j + 1)) {
            continue;
        }
        const auto row = [&](std::size_t at) {
            const std::size_t before =
                at > 0 && at == j && !is_edge(at, at - 1) ? at - 1 : std::min(at, j);
            const std::size_t after =
                at == j + 1 && at + 1 < profile.size() && !is_edge(at, at + 1) ? at + 1 : j + 1;
            const V2d chord = profile[after] - profile[before];
            std::vector<Corner> corners;
            for (int k = 0; k <= segments; ++k) {
                const V3d out = on_circle(k, segments);
                corners.push_back({foot + out * profile[at].x + V3d(0, 0, profile[at].y),
                                   (out * chord.y - V3d(0, 0, chord.x)).normalized()});
            }
            return corners;
        };
        grid({row(j), row(j + 1)});
    }
    return *this;
}

MeshBuilder& MeshBuilder::tube(const std::vector<Bead>& beads, int segments) {
    std::vector<std::vector<Corner>> rows;
    V3d right(0.0);
    const std::size_t last = beads.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        const V3d way =
            (beads[std::min(i + 1, last)].at - beads[i == 0 ? 0 : i - 1].at).normalized();
        // Carried on from bead to bead, so that the tube does not twist.
        if (i == 0) {
            right = way.cross(std::fabs(way.z) < 0.9 ? V3d(0, 0, 1) : V3d(1, 0, 0));
        }
        right = (right - way * right.dot(way)).normalized();
        const V3d front = way.cross(right);
        const auto ring = [&](double along, double radius) {
            std::vector<Corner> corners;
            for (int k = 0; k <= segments; ++k) {
                const V3d c = on_circle(k, segments);
                const V3d out = right * c.x + front * c.y;
                corners.push_back({beads[i].at + (way * along + out * radius) * beads[i].radius,
                                   way * along + out * radius});
            }
            rows.push_back(corners);
        };
        constexpr int steps = 4;
        for (int k = 0; i == 0 && k < steps; ++k) {
            ring(-std::cos(pi / 2 * k / steps), std::sin(pi / 2 * k / steps));
        }
        ring(0.0, 1.0);
        for (int k = 1; i == last && k <= steps; ++k) {
            ring(std::sin(pi / 2 * k / steps), std::cos(pi / 2 * k / steps));
        }
    }
    return grid(rows);
}

MeshBuilder& MeshBuilder::band(const std::vector<V2d>& lower, const std::vector<V2d>& upper,
                               double from, double to) {
    const auto front = [&](const V2d& p) { return V3d(p.x, from, p.y); };
    const auto back = [&](const V2d& p) { return V3d(p.x, to, p.y); };
    const std::size_t last = lower.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
        const V2d& a = lower[i];
        const V2d& b = lower[i + 1];
        const V2d& c = upper[i + 1];
        const V2d& d = upper[i];
        quad(front(a), front(b), front(c), front(d));
        quad(back(b), back(a), back(d), back(c));
        quad(front(d), front(c), back(c), back(d));
        quad(back(a), back(b), front(b), front(a));
    }
    quad(back(lower[0]), front(lower[0]), front(upper[0]), back(upper[0]));
    quad(front(lower[last]), back(lower[last]), back(upper[last]), front(upper[last]));
    return *this;
}

MeshBuilder& MeshBuilder::ellipsoid(const V3d& middle, const V3d& radii, int segments) {
    std::vector<std::vector<Corner>> rows;
    for (int j = 0; j <= segments / 2; ++j) {
        const double polar = pi * j / (segments / 2);
        std::vector<Corner> row;
        for (int k = 0; k <= segments; ++k) {
            const V3d out = on_circle(k, segments) * std::sin(polar) - V3d(0, 0, std::cos(polar));
            row.push_back({middle + out * radii, (out / radii).normalized()});
        }
        rows.push_back(row);
    }
    return grid(rows);
}

MeshBuilder& MeshBuilder::add(const MeshBuilder& other, const M44d& placed) {
    const M44d turned = placed.inverse().transposed();
    for (Face face : other.faces_) {
        for (Corner& corner : face) {
            corner.position = corner.position * placed;
            V3d normal;
            turned.multDirMatrix(corner.normal, normal);
            corner.normal = normal.normalized();
        }
        if (placed.determinant() < 0.0) {
            std::reverse(face.begin(), face.end());
        }
        faces_.push_back(face);
    }
    return *this;
}

scene::Mesh MeshBuilder::mesh() const {
    scene::Mesh mesh;
    for (const Face& face : faces_) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const V3d outward = face[0].normal + face[1].normal + face[2].normal + face[3].normal;
        for (const Corner& corner : face) {
            mesh.positions.emplace_back(corner.position);
            mesh.normals.emplace_back(corner.normal);
            mesh.texture_coordinates[0].push_back(texture_place(corner.position, outward));
        }
        add_triangle(mesh, {first, first + 1, first + 2});
        add_triangle(mesh, {first, first + 2, first + 3});
    }
    return mesh;
}

}  // namespace balcony::plates
