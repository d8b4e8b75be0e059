// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Objects made of arrays.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/precondition.hpp"
#include "scene/default_light.hpp"
#include "scene/edits/parts_by_name.hpp"
#include "scene/geometry.hpp"
#include "scene/import.hpp"

namespace balcony::scene {

namespace {

using Imath::V2d;

// What is wrong with one row of an array.
struct RowFault {
    std::string_view array;
    std::size_t row = 0;
    std::string fault;
};

Diagnostic error_of(const std::string& name, const RowFault& fault) {
    return error(fmt::format("mesh {}: row {} of the {} {}", in_quotes(name), fault.row,
                             fault.array, fault.fault));
}

// The first row that is not usable.
template <class Row, class IsUsable>
std::optional<RowFault> first_fault(std::string_view array, std::span<const Row> rows,
                                    std::string_view fault, const IsUsable& is_usable) {
    const auto bad = std::find_if_not(rows.begin(), rows.end(), is_usable);
    return bad == rows.end()
               ? std::nullopt
               : std::optional(RowFault{array, static_cast<std::size_t>(bad - rows.begin()),
                                        std::string(fault)});
}

bool is_unit_interval(double number) { return number >= 0.0 && number <= 1.0; }

// The number of rows of the colours; nothing if it is not whole.
std::optional<std::size_t> color_count(const MeshArrays& arrays) {
    const std::size_t channels = arrays.color_channels;
    return arrays.colors.size() % channels == 0 ? std::optional(arrays.colors.size() / channels)
                                                : std::nullopt;
}

std::optional<std::string> fault_of_counts(const MeshArrays& arrays) {
    const std::size_t vertices = arrays.positions.size();
    const auto differs = [&](std::string_view array,
                             std::optional<std::size_t> rows) -> std::optional<std::string> {
        return rows == 0U || rows == vertices
                   ? std::nullopt
                   : std::optional(fmt::format("there are {} of the {}, but {}",
                                               counted(rows.value_or(0), "row"), array,
                                               counted(vertices, "position")));
    };
    for (const auto& fault : {differs("normals", arrays.normals.size()),
                              differs("texture coordinates", arrays.texture_coordinates.size()),
                              differs("colours", color_count(arrays))}) {
        if (fault) {
            return fault;
        }
    }
    if (arrays.triangles.empty()) {
        return "it has no triangles";
    }
    return std::nullopt;
}

std::optional<RowFault> fault_of_rows(const MeshArrays& arrays) {
    const auto is_finite = [](const auto& v) { return std::isfinite(v.dot(v)); };
    auto fault = first_fault("positions", arrays.positions,
                             fmt::format("is not finite, or beyond {:g}", max_coordinate),
                             [](const V3d& p) { return usable(V3f(p)); });
    if (!fault) {
        const auto count = static_cast<std::int64_t>(arrays.positions.size());
        fault = first_fault("triangles", arrays.triangles,
                            fmt::format("names a vertex that is not there: there are {}, "
                                        "numbered from 0",
                                        count),
                            [count](const auto& triangle) {
                                return std::all_of(triangle.begin(), triangle.end(),
                                                   [count](std::int64_t vertex) {
                                                       return vertex >= 0 && vertex < count;
                                                   });
                            });
    }
    if (!fault) {
        fault = first_fault("normals", arrays.normals, "has no length, or is not finite",
                            [&](const V3d& n) { return is_finite(n) && n.length() > 0.0; });
    }
    if (!fault) {
        fault = first_fault("texture coordinates", arrays.texture_coordinates, "is not finite",
                            [&](const V2d& uv) { return is_finite(V2f(uv)); });
    }
    if (!fault) {
        fault = first_fault("colours", arrays.colors, "is not from 0 to 1", is_unit_interval);
        if (fault) {
            fault->row /= arrays.color_channels;
        }
    }
    return fault;
}

Diagnostics check(const std::string& name, const MeshArrays& arrays) {
    precondition(arrays.color_channels == 3 || arrays.color_channels == 4,
                 "colours have three or four channels");
    if (const auto fault = fault_of_counts(arrays)) {
        return {error(fmt::format("mesh {}: {}", in_quotes(name), *fault))};
    }
    if (const auto fault = fault_of_rows(arrays)) {
        return {error_of(name, *fault)};
    }
    return {};
}

Mesh mesh_of(const std::string& name, const MeshArrays& arrays, std::size_t material) {
    Mesh mesh;
    mesh.name = name;
    mesh.material = MaterialIndex(material);
    const auto single = [](const V3d& v) { return V3f(v); };
    std::transform(arrays.positions.begin(), arrays.positions.end(),
                   std::back_inserter(mesh.positions), single);
    std::transform(arrays.normals.begin(), arrays.normals.end(), std::back_inserter(mesh.normals),
                   [](const V3d& n) { return V3f(n.normalized()); });
    std::transform(arrays.texture_coordinates.begin(), arrays.texture_coordinates.end(),
                   std::back_inserter(mesh.texture_coordinates[0]),
                   [](const V2d& uv) { return V2f(uv); });
    const std::size_t channels = arrays.color_channels;
    for (std::size_t i = 0; i < arrays.colors.size(); i += channels) {
        const auto at = [&](std::size_t k) { return static_cast<float>(arrays.colors[i + k]); };
        mesh.colors.emplace_back(at(0), at(1), at(2), channels == 4 ? at(3) : 1.0F);
    }
    for (const auto& triangle : arrays.triangles) {
        mesh.triangles.push_back({static_cast<std::uint32_t>(triangle[0]),
                                  static_cast<std::uint32_t>(triangle[1]),
                                  static_cast<std::uint32_t>(triangle[2])});
    }
    return mesh;
}

}  // namespace

Result<std::size_t> add_object(Scene& scene, const std::string& name, const MeshArrays& arrays,
                               std::size_t material, const M44d& world_from_object) {
    precondition(material < scene.materials.size(), "a scene has no material with this number");
    Diagnostics found = refuse_object_name(scene, name);
    if (found.empty()) {
        found = check(name, arrays);
    }
    if (!found.empty()) {
        return found;
    }
    Import import;
    import.file = name;
    std::optional<Mesh> mesh = finish_mesh(mesh_of(name, arrays, material), import);
    if (!mesh) {
        return error(fmt::format("mesh {}: no triangle has an area", in_quotes(name)));
    }
    warn_of_meshes(import);
    Scene changed = scene;
    const std::size_t object = scene.objects.size();
    changed.objects.push_back({name});
    changed.meshes.emplace_back(std::move(*mesh));
    changed.instances.push_back({.mesh = MeshIndex(changed.meshes.size() - 1),
                                 .world_from_mesh = {},
                                 .object = static_cast<std::uint32_t>(object)});
    found = place_object(changed, object, world_from_object);
    if (!found.empty()) {
        return found;
    }
    find_default_light(changed);
    scene = std::move(changed);
    return {object, std::move(import.diagnostics)};
}

}  // namespace balcony::scene
