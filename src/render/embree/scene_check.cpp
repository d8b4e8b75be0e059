// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/embree/scene_check.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace balcony::render {

namespace {

bool holds_together(const scene::Mesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    const auto fits = [vertices](const auto& values) {
        return values.empty() || values.size() == vertices;
    };
    return fits(mesh.normals) && fits(mesh.tangents) && fits(mesh.colors) &&
           std::all_of(mesh.texture_coordinates.begin(), mesh.texture_coordinates.end(), fits) &&
           std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& triangle) {
               return std::all_of(triangle.begin(), triangle.end(),
                                  [&](std::uint32_t vertex) { return vertex < vertices; });
           });
}

template <class Index, class Element>
bool leads_into(Index index, const std::vector<Element>& elements) {
    return index.value() < elements.size();
}

bool is_usable(const scene::TextureUse& use, const scene::Scene& scene) {
    constexpr std::uint8_t channels = 4;
    return !use.valid() || (leads_into(use.index, scene.textures) && use.channel < channels &&
                            use.coordinates < scene::max_coordinate_sets);
}

}  // namespace

Diagnostics check(const scene::Scene& scene) {
    Diagnostics found;
    for (const scene::Mesh& mesh : scene.meshes) {
        if (!holds_together(mesh) || !leads_into(mesh.material, scene.materials)) {
            found.push_back(error(fmt::format(
                "mesh '{}' refers to missing vertices or to a missing material", mesh.name)));
        }
    }
    for (const scene::Instance& instance : scene.instances) {
        if (!leads_into(instance.mesh, scene.meshes) || instance.object >= scene.objects.size()) {
            found.push_back(error("an instance refers to a missing mesh or object"));
        }
    }
    for (const scene::Material& material : scene.materials) {
        for (const auto texture : scene::texture_uses) {
            if (!is_usable(material.*texture, scene)) {
                found.push_back(
                    error(fmt::format("material '{}' refers to a missing texture", material.name)));
            }
        }
    }
    return found;
}

}  // namespace balcony::render
