// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "balcony/scene.hpp"

namespace balcony::scene {

namespace {

bool one_per_vertex(const Mesh& mesh, std::size_t count) {
    return count == 0 || count == mesh.positions.size();
}

bool is_consistent(const Mesh& mesh, const Scene& scene) {
    const std::size_t vertices = mesh.positions.size();
    return mesh.material.valid() && mesh.material.value() < scene.materials.size() &&
           one_per_vertex(mesh, mesh.normals.size()) &&
           one_per_vertex(mesh, mesh.tangents.size()) && one_per_vertex(mesh, mesh.colors.size()) &&
           std::all_of(mesh.texture_coordinates.begin(), mesh.texture_coordinates.end(),
                       [&](const auto& set) { return one_per_vertex(mesh, set.size()); }) &&
           std::all_of(
               mesh.triangles.begin(), mesh.triangles.end(), [vertices](const auto& corner) {
                   return corner[0] < vertices && corner[1] < vertices && corner[2] < vertices;
               });
}

bool is_consistent(const Material& material, const Scene& scene) {
    constexpr std::uint8_t channels = 4;
    return std::all_of(texture_uses.begin(), texture_uses.end(), [&](const auto& member) {
        const TextureUse& use = material.*member;
        return !use.valid() || (use.index.value() < scene.textures.size() &&
                                use.channel < channels && use.coordinates < max_coordinate_sets);
    });
}

bool is_consistent(const Instance& instance, const Scene& scene) {
    return instance.mesh.valid() && instance.mesh.value() < scene.meshes.size() &&
           instance.object < scene.objects.size();
}

// The error of the first part that does not fit to the others.
template <class Parts>
void check(const Parts& parts, std::string_view what, const Scene& scene, Diagnostics& found) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!is_consistent(parts[i], scene)) {
            found.push_back(
                error(Kind::internal,
                      fmt::format("{} {} of the scene refers to what is not there, or has lists of "
                                  "different lengths",
                                  what, i)));
            return;
        }
    }
}

}  // namespace

Diagnostics check(const Scene& scene) {
    Diagnostics found;
    check(scene.meshes, "mesh", scene, found);
    check(scene.materials, "material", scene, found);
    check(scene.instances, "instance", scene, found);
    return found;
}

}  // namespace balcony::scene
