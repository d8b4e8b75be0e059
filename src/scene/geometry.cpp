// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "scene/coincident.hpp"

namespace balcony::scene {

namespace {

// Twice the area of a triangle along its normal, in double so that tiny and huge triangles count.
V3d area_normal(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
    const V3d a(mesh.positions[triangle[0]]);
    const V3d b(mesh.positions[triangle[1]]);
    const V3d c(mesh.positions[triangle[2]]);
    return (b - a).cross(c - a);
}

// Normalises a vector; zero if it has no direction.
V3f unit(const V3d& vector) {
    const double length = vector.length();
    return std::isfinite(length) && length > 0.0 ? V3f(vector / length) : V3f(0.0F);
}

constexpr V3f any_normal(0.0F, 0.0F, 1.0F);

// Applies an action to everything that a mesh has one of per vertex.
template <class Action>
void for_each_attribute(Mesh& mesh, Action action) {
    action(mesh.positions);
    action(mesh.normals);
    action(mesh.tangents);
    for (std::vector<V2f>& coordinates : mesh.texture_coordinates) {
        action(coordinates);
    }
    action(mesh.colors);
}

// Replaces the vertices by some of them.
void select_vertices(Mesh& mesh, const std::vector<std::uint32_t>& selected,
                     std::vector<std::uint32_t>* vertices) {
    const auto select = [&]<class Element>(std::vector<Element>& attribute) {
        if (attribute.empty()) {
            return;
        }
        std::vector<Element> kept(selected.size());
        for (std::size_t i = 0; i < selected.size(); ++i) {
            kept[i] = attribute[selected[i]];
        }
        attribute = std::move(kept);
    };
    for_each_attribute(mesh, select);
    if (vertices != nullptr) {
        select(*vertices);
    }
}

bool has_area(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
    const V3f& a = mesh.positions[triangle[0]];
    const V3f rounded = (mesh.positions[triangle[1]] - a).cross(mesh.positions[triangle[2]] - a);
    return rounded != V3f(0.0F) || area_normal(mesh, triangle) != V3d(0.0);
}

// Strips repeat vertices to end a row, so a triangle that does so is not worth a warning.
void drop_bad_triangles(Mesh& mesh, Import& import) {
    std::size_t out_of_range = 0;
    std::size_t not_usable = 0;
    std::erase_if(mesh.triangles, [&](const std::array<std::uint32_t, 3>& triangle) {
        const auto past_end = [&](std::uint32_t index) { return index >= mesh.positions.size(); };
        if (std::any_of(triangle.begin(), triangle.end(), past_end)) {
            ++out_of_range;
            return true;
        }
        const auto bad = [&](std::uint32_t index) { return !usable(mesh.positions[index]); };
        if (std::any_of(triangle.begin(), triangle.end(), bad)) {
            ++not_usable;
            return true;
        }
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
            triangle[2] == triangle[0]) {
            return true;
        }
        const bool is_flat = !has_area(mesh, triangle);
        import.triangles_without_area += is_flat ? 1 : 0;
        return is_flat;
    });
    import.count_fault(mesh.name, "triangle", out_of_range,
                       "skipped because of a vertex index out of range");
    import.count_fault(mesh.name, "triangle", not_usable,
                       "skipped because of a vertex that is not finite or too large");
}

void keep_used_vertices(Mesh& mesh, std::vector<std::uint32_t>* vertices) {
    constexpr std::uint32_t unused = 0xffffffffU;
    std::vector<std::uint32_t> place(mesh.positions.size(), unused);
    std::size_t count = 0;
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t index : triangle) {
            count += place[index] == unused ? 1 : 0;
            place[index] = 0;
        }
    }
    if (count == place.size()) {
        return;
    }
    std::vector<std::uint32_t> used;
    used.reserve(count);
    for (std::uint32_t index = 0; index < place.size(); ++index) {
        if (place[index] != unused) {
            place[index] = static_cast<std::uint32_t>(used.size());
            used.push_back(index);
        }
    }
    for (auto& triangle : mesh.triangles) {
        for (std::uint32_t& index : triangle) {
            index = place[index];
        }
    }
    select_vertices(mesh, used, vertices);
}

void clean_texture_coordinates(Mesh& mesh, Import& import) {
    std::size_t bad = 0;
    for (std::vector<V2f>& coordinates : mesh.texture_coordinates) {
        for (V2f& coordinate : coordinates) {
            if (!std::isfinite(coordinate.x) || !std::isfinite(coordinate.y)) {
                coordinate = V2f(0.0F);
                ++bad;
            }
        }
    }
    import.count_fault(mesh.name, "texture coordinate", bad,
                       "replaced by (0, 0) because not finite");
}

void clean_colors(Mesh& mesh) {
    const auto cleaned = [](float part) {
        return std::isfinite(part) ? std::clamp(part, 0.0F, 1.0F) : 1.0F;
    };
    for (Color4f& color : mesh.colors) {
        color = {cleaned(color.r), cleaned(color.g), cleaned(color.b), cleaned(color.a)};
    }
}

void normalize_tangents(Mesh& mesh) {
    for (V4f& tangent : mesh.tangents) {
        const V3f along = unit(V3d(double{tangent.x}, double{tangent.y}, double{tangent.z}));
        tangent = {along.x, along.y, along.z, tangent.w < 0.0F ? -1.0F : 1.0F};
    }
}

// Gives every triangle separate vertices, with its normal.
void make_flat(Mesh& mesh, std::vector<std::uint32_t>* vertices) {
    std::vector<std::uint32_t> corners;
    corners.reserve(mesh.triangles.size() * 3);
    std::vector<V3f> normals;
    normals.reserve(mesh.triangles.size() * 3);
    for (auto& triangle : mesh.triangles) {
        const V3f normal = unit(area_normal(mesh, triangle));
        for (std::uint32_t& index : triangle) {
            corners.push_back(index);
            normals.push_back(normal);
            index = static_cast<std::uint32_t>(corners.size() - 1);
        }
    }
    select_vertices(mesh, corners, vertices);
    mesh.normals = std::move(normals);
}

void normalize_normals(Mesh& mesh, Import& import) {
    std::size_t without_length = 0;
    for (V3f& normal : mesh.normals) {
        normal = unit(V3d(normal));
        without_length += normal == V3f(0.0F) ? 1 : 0;
    }
    if (without_length == 0) {
        return;
    }
    std::vector<V3d> faced(mesh.positions.size(), V3d(0.0));
    for (const auto& triangle : mesh.triangles) {
        const V3d normal = area_normal(mesh, triangle);
        for (const std::uint32_t index : triangle) {
            faced[index] += normal;
        }
    }
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        if (mesh.normals[i] == V3f(0.0F)) {
            const V3f normal = unit(faced[i]);
            mesh.normals[i] = normal == V3f(0.0F) ? any_normal : normal;
        }
    }
    import.count_fault(mesh.name, "normal", without_length,
                       "of length 0 replaced by the normal of the faces");
}

}  // namespace

Color3f linear_of_srgb(const Color3f& color) {
    // IEC 61966-2-1.
    const auto linear = [](float encoded) {
        const float value = std::clamp(encoded, 0.0F, 1.0F);
        return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
    };
    return {linear(color.x), linear(color.y), linear(color.z)};
}

bool usable(const V3f& position) {
    const auto fits = [](float value) { return std::abs(double{value}) <= max_coordinate; };
    return fits(position.x) && fits(position.y) && fits(position.z);
}

std::optional<Mesh> finish_mesh(Mesh mesh, Import& import, std::vector<std::uint32_t>* vertices) {
    if (vertices != nullptr) {
        vertices->resize(mesh.positions.size());
        std::iota(vertices->begin(), vertices->end(), 0U);
    }
    for_each_attribute(mesh, [&]([[maybe_unused]] const auto& attribute) {
        assert(attribute.empty() || attribute.size() == mesh.positions.size());
    });
    import.check_stop();
    drop_bad_triangles(mesh, import);
    if (mesh.triangles.empty()) {
        return std::nullopt;
    }
    import.check_stop();
    if (vertices == nullptr) {
        import.coincident_triangles += drop_coincident_triangles(mesh);
        import.check_stop();
    }
    keep_used_vertices(mesh, vertices);
    import.check_stop();
    clean_texture_coordinates(mesh, import);
    clean_colors(mesh);
    normalize_tangents(mesh);
    import.check_stop();
    if (mesh.normals.empty()) {
        make_flat(mesh, vertices);
    } else {
        normalize_normals(mesh, import);
    }
    return mesh;
}

}  // namespace balcony::scene
